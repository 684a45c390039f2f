"""Expressions as pbrt textures: constants as numbers, images that stand alone as they are, all else baked."""

import os

import numpy as np

from ..export.cache import digest
from ..export.image_files import pfm_bytes, png_bytes
from ..export.pbrt_text import statement
from .expressions import UV
from .image_lookup import DATA_SPACES, LINEAR_SPACES
from .points import NOWHERE, Points

CHUNK = 1 << 18
READABLE = {"PNG", "JPEG", "OPEN_EXR", "HDR", "TARGA"}
WRAPS = {"REPEAT": "repeat", "EXTEND": "clamp", "CLIP": "black"}


class Window:
    """The part of texture space that a baked picture covers, in whole tiles."""

    MOST_TILES = 8

    def __init__(self, low=(0, 0), high=(1, 1)):
        self.low, self.high = tuple(map(int, low)), tuple(map(int, high))

    @staticmethod
    def of(uv):
        """Around the texture coordinates of a mesh; beyond MOST_TILES the picture is repeated."""
        if not len(uv) or not np.all(np.isfinite(uv)):
            return Window()
        low = np.floor(uv.min(axis=0) + 1e-5)
        high = np.maximum(np.ceil(uv.max(axis=0) - 1e-5), low + 1)
        return Window() if np.any(high - low > Window.MOST_TILES) or np.any(np.abs(low) > 1e6) else Window(low, high)

    @property
    def tiles(self):
        return tuple(h - l for l, h in zip(self.low, self.high))

    def parameters(self):
        wide, tall = self.tiles
        return {
            "float uscale": 1 / wide,
            "float vscale": 1 / tall,
            "float udelta": -self.low[0] / wide,
            "float vdelta": -self.low[1] / tall,
            "string wrap": "repeat",
        }

    def size(self, side, most=4096):
        return tuple(min(most, side * n) for n in self.tiles)

    def points(self, width, height):
        x = self.low[0] + (np.arange(width) + 0.5) / width * self.tiles[0]
        y = self.low[1] + (np.arange(height) + 0.5) / height * self.tiles[1]
        uv = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2).astype(np.float32)
        return uv


def evaluated(expression, points, columns):
    """All points, in pieces: n x columns."""
    result = np.empty((points.count, columns), dtype=np.float32)
    for begin in range(0, points.count, CHUNK):
        end = min(begin + CHUNK, points.count)
        result[begin:end] = expression(points.slice(begin, end))
    return np.nan_to_num(result, nan=0.0, posinf=0.0, neginf=0.0)


class TextureWriter:
    """Writes image files by a FileCache and gives the lines of the scene file that use them."""

    def __init__(self, cache, images, side):
        self.cache, self.images, self.side = cache, images, side

    def bake_window(self, expression, columns, window, key):
        """The file of an expression over a part of texture space. key: of the node tree and of what is baked."""
        width, height = window.size(self.side)

        def make():
            # Four places a texel, so that thin lines, such as mortar, keep the share of the surface that they have.
            uv = window.points(2 * width, 2 * height)
            names = {need[1] for need in expression.needs if need[0] == UV} | {""}
            points = Points(len(uv), {name: uv for name in names})
            fine = evaluated(expression, points, columns).reshape(height, 2, width, 2, columns)
            return self._pfm(fine.mean(axis=(1, 3)), width, height, columns)

        key = digest(key, window.low, window.high, width, height, columns)
        return self.cache.file(key, "pfm", make)

    def bake_points(self, expression, columns, points, size, key):
        """points(): the Points of a picture of size x size, row by row from below."""
        return self.cache.file(
            digest(key, size, columns),
            "pfm",
            lambda: self._pfm(evaluated(expression, points(), columns), size, size, columns),
        )

    @staticmethod
    def _pfm(values, width, height, columns):
        picture = values.reshape((height, width, columns) if columns == 3 else (height, width))
        return pfm_bytes(picture[::-1])

    # Images that need no baking

    def direct(self, expression, data=False):
        """(file, parameters) of an expression that is an image under the mesh's own coordinates; None if it is not.
        data: the numbers in the file count, whatever their colour space."""
        at = expression.image
        if at is None:
            return None
        node, placed = at.node, placement(at)
        if (
            placed is None
            or node.projection != "FLAT"
            or node.extension not in WRAPS
            or node.interpolation == "Closest"
        ):
            return None
        file, encoding = self.file_of(node.image)
        if file is None:
            return None
        return file, {**placed, "string wrap": WRAPS[node.extension], "string encoding": "linear" if data else encoding}

    def file_of(self, image):
        """(path, encoding) of an image: its own file, or a copy of its pixels. (None, None) if it has none."""
        space = image.colorspace_settings.name
        if space not in LINEAR_SPACES | DATA_SPACES | {"sRGB"} or image.source in ("TILED", "SEQUENCE", "MOVIE"):
            return None, None
        encoding = "sRGB" if space == "sRGB" else "linear"
        import bpy

        path = os.path.realpath(bpy.path.abspath(image.filepath, library=image.library)) if image.filepath else ""
        # Floats of EXR files are linear, whatever Blender is told of them.
        fits = not (image.is_float and space == "sRGB")
        if (
            image.source == "FILE"
            and not image.packed_file
            and not image.is_dirty
            and image.file_format in READABLE
            and fits
        ):
            if (
                os.path.isfile(path)
                and '"' not in path
                and image.channels != 2
                and image.depth in (8, 24, 32, 48, 64, 96, 128)
            ):
                return path, encoding
        pixels = self.images.pixels(image)
        if pixels is None:
            return None, None
        top_first = pixels.values[::-1, :, :3]
        if image.is_float:
            return self.cache.file(digest("copy", top_first), "pfm", lambda: pfm_bytes(top_first)), "linear"
        stored = np.clip(np.rint(top_first * 255), 0, 255).astype(np.uint8)
        return self.cache.file(digest("copy", stored), "png", lambda: png_bytes(stored)), encoding


def placement(at):
    """uscale, udelta ... of an Image Texture under the mesh's coordinates, moved and scaled at most; else None."""
    vector = at.input("Vector").source()
    if not vector.socket.is_output:
        return {}
    if is_uv(vector):
        return {}
    if vector.node.type != "MAPPING" or vector.node.vector_type != "POINT":
        return None
    inner = vector.input("Vector").source()
    if not inner.socket.is_output or not is_uv(inner):
        return None
    numbers = {}
    for name in ("Location", "Rotation", "Scale"):
        source = vector.input(name).source()
        if source.socket.is_output:
            return None
        numbers[name] = tuple(source.socket.default_value)
    if any(numbers["Rotation"]):
        return None
    return {
        "float uscale": numbers["Scale"][0],
        "float vscale": numbers["Scale"][1],
        "float udelta": numbers["Location"][0],
        "float vdelta": numbers["Location"][1],
    }


def is_uv(at):
    return at.node.type == "UVMAP" or (at.node.type == "TEX_COORD" and at.socket.name == "UV")


def texture(name, columns, file, parameters):
    return statement(
        "Texture",
        name,
        "spectrum" if columns == 3 else "float",
        "imagemap",
        params={"string filename": file, **parameters},
    )


def value_at_nowhere(expression):
    return expression(NOWHERE)[0]
