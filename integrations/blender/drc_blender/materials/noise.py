"""Blender's procedural patterns on arrays of points: gradient noise, checks, gradients, bricks.

They follow the definitions of Blender's nodes, so that a baked texture has every blob where Cycles has it; the tests
compare them.
"""

import numpy as np

_SEED = 0xDEADBEEF


def _final_mix(a, b, c):
    """Bob Jenkins' final mixing of three 32-bit words (lookup3, 2006)."""

    def turned(x, k):
        return (x << np.uint32(k)) | (x >> np.uint32(32 - k))

    c = (c ^ b) - turned(b, 14)
    a = (a ^ c) - turned(c, 11)
    b = (b ^ a) - turned(a, 25)
    c = (c ^ b) - turned(b, 16)
    a = (a ^ c) - turned(c, 4)
    b = (b ^ a) - turned(a, 14)
    return (c ^ b) - turned(b, 24)


def _hash(*words):
    start = np.uint32((_SEED + (len(words) << 2) + 13) & 0xFFFFFFFF)
    words = [np.asarray(w).astype(np.int64).astype(np.uint32) for w in words]
    words += [np.zeros_like(words[0])] * (3 - len(words))
    with np.errstate(over="ignore"):
        return _final_mix(words[0] + start, words[1] + start, words[2] + start)


def _offset(seed):
    """Where the noise that displaces or colours other noise is taken from."""

    def unit(i):
        bits = np.array([seed, i], dtype=np.float32).view(np.uint32)
        return float(_hash(bits[:1], bits[1:])[0]) / 0xFFFFFFFF

    return np.array([100 + 100 * unit(i) for i in range(3)], dtype=np.float32)


def perlin(points):
    """Perlin's improved gradient noise, about [-1, 1]; points: n x 3."""
    whole = np.floor(points)
    part = (points - whole).astype(np.float32)
    cell = whole.astype(np.int64)
    smooth = part**3 * (part * (part * 6 - 15) + 10)
    total = np.zeros(len(points), dtype=np.float32)
    for corner in range(8):
        step = np.array([corner & 1, corner >> 1 & 1, corner >> 2], dtype=np.int64)
        kind = _hash(*(cell + step).T) & np.uint32(15)
        x, y, z = (part - step).T
        u = np.where(kind < 8, x, y)
        v = np.where(kind < 4, y, np.where((kind == 12) | (kind == 14), x, z))
        slope = np.where(kind & 1, -u, u) + np.where(kind & 2, -v, v)
        total += slope * np.prod(np.where(step, smooth, 1 - smooth), axis=1)
    return np.float32(0.982) * total


def fractal(points, detail, roughness, lacunarity, normalized):
    """A sum of octaves; the last counts as the fraction of the detail says."""
    detail, roughness = min(max(detail, 0.0), 15.0), min(max(roughness, 0.0), 1.0)
    total, amplitude, frequency, largest = 0.0, 1.0, 1.0, 0.0
    for _ in range(int(detail) + 1):
        total = total + amplitude * perlin(points * np.float32(frequency))
        largest += amplitude
        amplitude *= roughness
        frequency *= lacunarity
    rest = detail - int(detail)
    if not rest:
        return 0.5 * total / largest + 0.5 if normalized else total
    more = total + amplitude * perlin(points * np.float32(frequency))
    if normalized:
        total, more = 0.5 * total / largest + 0.5, 0.5 * more / (largest + amplitude) + 0.5
    return (1 - rest) * total + rest * more


def noise(points, detail=2.0, roughness=0.5, lacunarity=2.0, distortion=0.0, normalized=True, coloured=False):
    """The Noise Texture in three dimensions, kind fBM: n x 1, or n x 3 if coloured."""
    if distortion:
        points = points + distortion * np.stack([perlin(points + _offset(i)) for i in range(3)], axis=1)
    shifts = [0.0, _offset(3), _offset(4)] if coloured else [0.0]
    return np.stack([fractal(points + shift, detail, roughness, lacunarity, normalized) for shift in shifts], axis=1)


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
