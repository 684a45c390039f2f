"""Writes linear RGB as OpenEXR files with metadata, so that a reference carries what made it.

Scan lines of floats, compressed by ZIP: https://openexr.com/en/latest/OpenEXRFileLayout.html. drc reads them, and reads
the metadata back (program.py).
"""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import numpy as np

from .files import write_whole

_MAGIC, _VERSION = 20000630, 2
_LONG_NAMES = 0x400
_FLOAT, _ZIP, _LINES_OF_A_CHUNK = 2, 3, 16
_CHANNELS = ((b"B", 2), (b"G", 1), (b"R", 0))  # in the order of the file, with their places in the array


def _attribute(name: str, kind: str, value: bytes) -> bytes:
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def _header(width: int, height: int, metadata: dict[str, str]) -> bytes:
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    channels = b"".join(name + b"\0" + struct.pack("<iB3x2i", _FLOAT, 0, 1, 1) for name, _ in _CHANNELS) + b"\0"
    attributes = [
        _attribute("channels", "chlist", channels),
        _attribute("compression", "compression", bytes([_ZIP])),
        _attribute("dataWindow", "box2i", window),
        _attribute("displayWindow", "box2i", window),
        _attribute("lineOrder", "lineOrder", b"\0"),
        _attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        _attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)),
        _attribute("screenWindowWidth", "float", struct.pack("<f", 1)),
    ]
    attributes += [_attribute(name, "string", text.encode("utf-8")) for name, text in metadata.items()]
    return struct.pack("<2i", _MAGIC, _VERSION | _LONG_NAMES) + b"".join(attributes) + b"\0"


def _compressed(data: bytes) -> bytes:
    """ZIP of OpenEXR: first all even bytes, then all odd ones, as differences from byte to byte, off by 128."""
    values = np.frombuffer(data, np.uint8)
    ordered = np.concatenate((values[::2], values[1::2]))
    predicted = ordered.copy()
    predicted[1:] = ordered[1:] - ordered[:-1] + np.uint8(128)
    packed = zlib.compress(predicted.tobytes(), 4)
    return packed if len(packed) < len(data) else data


def write_exr(path: Path, pixels: np.ndarray, metadata: dict[str, str]) -> None:
    """pixels: height x width x 3."""
    height, width, _ = pixels.shape
    # Each line has all values of one channel after those of the other.
    lines = np.ascontiguousarray(np.stack([pixels[:, :, place] for _, place in _CHANNELS], axis=1), dtype="<f4")
    chunks = []
    for y in range(0, height, _LINES_OF_A_CHUNK):
        data = _compressed(lines[y : y + _LINES_OF_A_CHUNK].tobytes())
        chunks.append(struct.pack("<2i", y, len(data)) + data)
    head = _header(width, height, metadata)
    place, offsets = len(head) + 8 * len(chunks), []
    for chunk in chunks:
        offsets.append(place)
        place += len(chunk)
    write_whole(path, head + struct.pack(f"<{len(offsets)}Q", *offsets) + b"".join(chunks))
