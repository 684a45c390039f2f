"""Pixels of Blender's images, linear, and lookups in them."""

import numpy as np

from ..export.image_files import srgb_to_linear

LINEAR_SPACES = {"Linear", "Linear Rec.709", "Linear Rec. 709", "scene_linear"}
DATA_SPACES = {"Non-Color", "Raw", "Generic Data"}


class Pixels:
    """values: height x width x 4, rows from the bottom, as they are stored; encoded: whether they are sRGB's."""

    def __init__(self, values, encoded):
        self.values, self.encoded = values, encoded

    def lookup(self, uv, extension, interpolation):
        """n x 4. Colours are interpolated as they are stored, as in Cycles."""
        height, width = self.values.shape[:2]
        x, y = uv[:, 0] * width, uv[:, 1] * height
        if interpolation == "Closest":
            found = self._at(np.floor(x).astype(np.int64), np.floor(y).astype(np.int64), extension)
        else:
            x0, y0 = np.floor(x - 0.5), np.floor(y - 0.5)
            fx, fy = (x - 0.5 - x0)[:, None], (y - 0.5 - y0)[:, None]
            x0, y0 = x0.astype(np.int64), y0.astype(np.int64)
            lower = self._at(x0, y0, extension) * (1 - fx) + self._at(x0 + 1, y0, extension) * fx
            upper = self._at(x0, y0 + 1, extension) * (1 - fx) + self._at(x0 + 1, y0 + 1, extension) * fx
            found = lower * (1 - fy) + upper * fy
        if self.encoded:
            found = np.concatenate([srgb_to_linear(found[:, :3]), found[:, 3:]], axis=1)
        if extension == "CLIP":
            outside = (uv[:, 0] < 0) | (uv[:, 0] > 1) | (uv[:, 1] < 0) | (uv[:, 1] > 1)
            found = np.where(outside[:, None], 0, found)
        return found.astype(np.float32)

    def _at(self, x, y, extension):
        height, width = self.values.shape[:2]
        if extension == "REPEAT":
            x, y = x % width, y % height
        elif extension == "MIRROR":
            x, y = x % (2 * width), y % (2 * height)
            x, y = np.minimum(x, 2 * width - 1 - x), np.minimum(y, 2 * height - 1 - y)
        else:
            x, y = np.clip(x, 0, width - 1), np.clip(y, 0, height - 1)
        return self.values[y, x]


class Images:
    """The pixels of images, read once."""

    def __init__(self):
        self._read = {}

    def pixels(self, image):
        """None if the image has no pixels, as where its file is missing."""
        if image.name_full not in self._read:
            self._read[image.name_full] = self._pixels(image)
        return self._read[image.name_full]

    @staticmethod
    def _pixels(image):
        width, height = image.size
        if not width or not height or image.channels == 0:
            return None
        values = np.empty(width * height * image.channels, dtype=np.float32)
        image.pixels.foreach_get(values)
        values = values.reshape(height, width, image.channels)
        full = np.ones((height, width, 4), dtype=np.float32)
        if image.channels < 3:
            full[..., :3] = values[..., :1]
            if image.channels == 2:
                full[..., 3] = values[..., 1]
        else:
            full[..., : image.channels] = values
        return Pixels(full, is_encoded(image))


def is_encoded(image):
    """Blender keeps bytes as they are in the file, and floats linear."""
    return not image.is_float and image.colorspace_settings.name not in LINEAR_SPACES | DATA_SPACES


def equirectangular(directions):
    """Texture coordinates of Blender's Environment Texture: n x 2."""
    x, y, z = directions.T
    return np.stack([0.5 - np.arctan2(y, x) / (2 * np.pi), np.arctan2(z, np.hypot(x, y)) / np.pi + 0.5], axis=1)


def mirror_ball(directions):
    x, y, z = directions.T
    d = np.stack([x, y - 1, z], axis=1)
    length = np.linalg.norm(d, axis=1)
    return np.stack(
        [0.5 * (1 + d[:, 0] / np.maximum(length, 1e-9)), 0.5 * (1 + d[:, 2] / np.maximum(length, 1e-9))], axis=1
    )
