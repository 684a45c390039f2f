"""Images as files that DRC reads: floats as PFM, bytes as PNG."""

import struct
import zlib

import numpy as np


def pfm_bytes(pixels):
    """pixels: height x width (x 3), rows from the top. PFM has them from the bottom."""
    pixels = np.asarray(pixels, dtype="<f4")
    kind = "PF" if pixels.ndim == 3 else "Pf"
    return f"{kind}\n{pixels.shape[1]} {pixels.shape[0]}\n-1.0\n".encode() + pixels[::-1].tobytes()


def png_bytes(pixels):
    """pixels: height x width x channels (1, 3 or 4) of bytes, rows from the top."""
    pixels = np.ascontiguousarray(pixels, dtype=np.uint8)
    height, width, channels = pixels.shape
    rows = np.zeros((height, 1 + width * channels), dtype=np.uint8)  # each row begins with its filter: none
    rows[:, 1:] = pixels.reshape(height, -1)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, {1: 0, 3: 2, 4: 6}[channels], 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(rows.tobytes(), 3))
        + chunk(b"IEND", b"")
    )


def srgb_to_linear(values):
    values = np.asarray(values, dtype=np.float32)
    return np.where(values <= 0.04045, values / 12.92, (np.maximum(values, 0.04045) + 0.055) ** 2.4 / 1.055**2.4)
