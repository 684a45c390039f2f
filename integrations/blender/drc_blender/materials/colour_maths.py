"""The arithmetic of Blender's colour and converter nodes on arrays."""

import numpy as np


def rotation(angles):
    """n x 3 Euler angles, applied about x, then y, then z: n x 3 x 3."""
    cx, cy, cz = np.cos(angles).T
    sx, sy, sz = np.sin(angles).T
    rows = [
        [cy * cz, sx * sy * cz - cx * sz, cx * sy * cz + sx * sz],
        [cy * sz, sx * sy * sz + cx * cz, cx * sy * sz - sx * cz],
        [-sy, sx * cy, cx * cy],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=1)


def _safe_divide(a, b):
    return np.where(b == 0, 0, a / np.where(b == 0, 1, b))


def _power(a, b):
    with np.errstate(all="ignore"):
        found = np.where((a < 0) & (b != np.floor(b)), 0, np.sign(a) ** np.floor(b) * np.abs(a) ** b)
    return np.nan_to_num(found, nan=0, posinf=0, neginf=0)


NUMBERS = {
    "ADD": lambda a, b: a + b,
    "SUBTRACT": lambda a, b: a - b,
    "MULTIPLY": lambda a, b: a * b,
    "DIVIDE": _safe_divide,
    "MULTIPLY_ADD": lambda a, b, c: a * b + c,
    "POWER": _power,
    "LOGARITHM": lambda a, b: np.where(
        (a > 0) & (b > 0) & (b != 1), _safe_divide(np.log(np.maximum(a, 1e-37)), np.log(np.maximum(b, 1e-37))), 0
    ),
    "SQRT": lambda a: np.sqrt(np.maximum(a, 0)),
    "INVERSE_SQRT": lambda a: np.where(a > 0, 1 / np.sqrt(np.maximum(a, 1e-37)), 0),
    "ABSOLUTE": lambda a: np.abs(a),
    "EXPONENT": lambda a: np.exp(a),
    "MINIMUM": lambda a, b: np.minimum(a, b),
    "MAXIMUM": lambda a, b: np.maximum(a, b),
    "LESS_THAN": lambda a, b: (a < b) * 1.0,
    "GREATER_THAN": lambda a, b: (a > b) * 1.0,
    "SIGN": lambda a: np.sign(a),
    "COMPARE": lambda a, b, c: (np.abs(a - b) <= np.maximum(c, 1e-5)) * 1.0,
    "ROUND": lambda a: np.floor(a + 0.5),
    "FLOOR": lambda a: np.floor(a),
    "CEIL": lambda a: np.ceil(a),
    "TRUNC": lambda a: np.trunc(a),
    "FRACT": lambda a: a - np.floor(a),
    "MODULO": lambda a, b: np.where(b == 0, 0, np.fmod(a, np.where(b == 0, 1, b))),
    "FLOORED_MODULO": lambda a, b: np.where(b == 0, 0, np.mod(a, np.where(b == 0, 1, b))),
    "WRAP": lambda a, b, c: np.where(b == c, c, a - (b - c) * np.floor(_safe_divide(a - c, b - c))),
    "SNAP": lambda a, b: np.floor(_safe_divide(a, b)) * b,
    "PINGPONG": lambda a, b: np.where(b == 0, 0, np.abs(_fraction(_safe_divide(a - b, 2 * b)) * 2 * b - b)),
    "SINE": lambda a: np.sin(a),
    "COSINE": lambda a: np.cos(a),
    "TANGENT": lambda a: np.tan(a),
    "ARCSINE": lambda a: np.arcsin(np.clip(a, -1, 1)),
    "ARCCOSINE": lambda a: np.arccos(np.clip(a, -1, 1)),
    "ARCTANGENT": lambda a: np.arctan(a),
    "ARCTAN2": lambda a, b: np.arctan2(a, b),
    "SINH": lambda a: np.sinh(a),
    "COSH": lambda a: np.cosh(a),
    "TANH": lambda a: np.tanh(a),
    "RADIANS": lambda a: np.radians(a),
    "DEGREES": lambda a: np.degrees(a),
}


def _fraction(a):
    return a - np.floor(a)


def _between(function):
    return lambda t, a, b: a + t * (function(a, b) - a)


# t: the factor, a and b: the two colours.
BLENDS = {
    "MIX": lambda t, a, b: a + t * (b - a),
    "DARKEN": _between(np.minimum),
    "MULTIPLY": _between(np.multiply),
    "BURN": lambda t, a, b: np.where(a >= 1, 1, np.clip(1 - _safe_divide(1 - a, 1 - t + t * b), 0, 1)),
    "LIGHTEN": _between(np.maximum),
    "SCREEN": lambda t, a, b: 1 - (1 - t + t * (1 - b)) * (1 - a),
    "DODGE": lambda t, a, b: np.where(
        a == 0, 0, np.where(1 - t * b <= 0, 1, np.minimum(1, a / np.maximum(1 - t * b, 1e-20)))
    ),
    "ADD": lambda t, a, b: a + t * b,
    "OVERLAY": lambda t, a, b: np.where(a < 0.5, a * (1 - t + 2 * t * b), 1 - (1 - t + 2 * t * (1 - b)) * (1 - a)),
    "SOFT_LIGHT": lambda t, a, b: (1 - t) * a + t * ((1 - a) * b * a + a * (1 - (1 - b) * (1 - a))),
    "LINEAR_LIGHT": lambda t, a, b: a + t * (2 * b - 1),
    "DIFFERENCE": lambda t, a, b: (1 - t) * a + t * np.abs(a - b),
    "EXCLUSION": lambda t, a, b: np.maximum((1 - t) * a + t * (a + b - 2 * a * b), 0),
    "SUBTRACT": lambda t, a, b: a - t * b,
    "DIVIDE": lambda t, a, b: np.where(b == 0, a, (1 - t) * a + t * a / np.where(b == 0, 1, b)),
}


def brightness_contrast(colour, bright, contrast):
    return np.maximum((1 + contrast) * colour + (bright - contrast / 2), 0)


def hue_saturation(hue, saturation, value, factor, colour):
    high, low = colour.max(axis=1, keepdims=True), colour.min(axis=1, keepdims=True)
    span = np.where(high > low, high - low, 1)
    r, g, b = (colour / span).T[..., None]
    h = np.where(colour[:, :1] >= high, g - b, np.where(colour[:, 1:2] >= high, 2 + b - r, 4 + r - g)) / 6
    h = np.where(high > low, h, 0)
    s = np.where(high > 0, (high - low) / np.where(high > 0, high, 1), 0)
    h, s, v = (h + hue + 0.5) % 1.0, np.clip(s * saturation, 0, 1), high * value
    wheel = np.clip(np.abs((h + np.array([0, 2 / 3, 1 / 3])) % 1.0 * 6 - 3) - 1, 0, 1)
    found = np.maximum(v * (1 - s * (1 - wheel)), 0)
    return colour + factor * (found - colour)


def mapped_range(kind, clamp, value, from_low, from_high, to_low, to_high):
    t = _safe_divide(value - from_low, from_high - from_low)
    if kind in ("SMOOTHSTEP", "SMOOTHERSTEP"):
        t = np.clip(t, 0, 1)
        t = t * t * (3 - 2 * t) if kind == "SMOOTHSTEP" else t**3 * (t * (6 * t - 15) + 10)
    found = to_low + t * (to_high - to_low)
    return np.clip(found, np.minimum(to_low, to_high), np.maximum(to_low, to_high)) if clamp else found
