"""Blender's regular patterns on arrays of points: checks, gradients, bricks."""

import numpy as np


def checker(points):
    """1 where the first colour is."""
    cell = np.floor((points + 1e-6) * 0.999999).astype(np.int64)
    return (np.sum(cell, axis=1, keepdims=True) % 2 == 1).astype(np.float32)


def gradient(points, kind):
    x, y, z = points.T
    unit = np.clip(x, 0, 1)
    ball = np.maximum(0.999999 - np.sqrt(x * x + y * y + z * z), 0)
    value = {
        "LINEAR": lambda: x,
        "QUADRATIC": lambda: np.maximum(x, 0) ** 2,
        "EASING": lambda: unit * unit * (3 - 2 * unit),
        "DIAGONAL": lambda: (x + y) / 2,
        "RADIAL": lambda: np.arctan2(y, x) / (2 * np.pi) + 0.5,
        "SPHERICAL": lambda: ball,
        "QUADRATIC_SPHERE": lambda: ball * ball,
    }[kind]()
    return np.clip(value, 0, 1)[:, None]


def _brick_tint(number):
    n = (number + 1013) & 0x7FFFFFFF
    n = (n >> 13) ^ n
    n = (n * ((n * n * 60493 + 19990303) & 0xFFFFFFFF) + 1376312589) & 0x7FFFFFFF
    return 0.5 * n / 1073741824.0


def bricks(points, mortar_size, mortar_smooth, bias, width, height, offset, offset_every, squash, squash_every):
    """(tint, mortar), each n x 1: which of the two colours a brick has, and the share of mortar."""
    x, y = points[:, 0].astype(np.float64), points[:, 1].astype(np.float64)
    row = np.floor(y / height).astype(np.int64)
    wide, shift = np.full(len(x), width), np.zeros(len(x))
    if offset_every and squash_every:
        wide = np.where(row % squash_every, width, width * squash)
        shift = np.where(row % offset_every, 0.0, wide * offset)
    column = np.floor((x + shift) / wide).astype(np.int64)
    across, up = x + shift - wide * column, y - height * row
    tint = np.clip(_brick_tint((row << 16) + (column & 0xFFFF)) + bias, 0, 1)
    edge = np.minimum(np.minimum(across, up), np.minimum(wide - across, height - up))
    if mortar_size <= 0:
        mortar = np.zeros(len(x))
    elif mortar_smooth == 0:
        mortar = (edge < mortar_size).astype(float)
    else:
        depth = np.clip((1 - edge / mortar_size) / mortar_smooth, 0, 1)
        mortar = np.where(edge < mortar_size, depth * depth * (3 - 2 * depth), 0)
    return tint[:, None].astype(np.float32), mortar[:, None].astype(np.float32)
