"""Perlin's improved gradient noise (2002) in one to four dimensions, with the gradients and sizes that Blender has."""

import itertools

import numpy as np

from .hashes import jenkins

# By the number of dimensions: what brings the noise to about [-1, 1].
_SIZE = {1: 0.25, 2: 0.6616, 3: 0.982, 4: 0.8344}
_PERIOD = 100000  # beyond it, floats have no fractions that are worth to be told


def perlin(place):
    """An array of about [-1, 1]. place: a list of arrays of float32, one for each coordinate."""
    place = [_within_period(c) for c in place]
    whole = [np.floor(c) for c in place]
    part = [c - w for c, w in zip(place, whole)]
    cell = [w.astype(np.int32).view(np.uint32) for w in whole]
    # The two cells and the two distances that a corner can have along each axis.
    cells = [(c, c + np.uint32(1)) for c in cell]
    parts = [(p, p - np.float32(1)) for p in part]
    corners = [
        _slope(jenkins(*(c[i] for c, i in zip(cells, corner))), [p[i] for p, i in zip(parts, corner)])
        for corner in itertools.product((0, 1), repeat=len(place))
    ]
    for p in reversed(part):  # the last axis changes fastest
        share = p * p * p * (p * (p * 6 - 15) + 10)
        corners = [low + (high - low) * share for low, high in zip(corners[::2], corners[1::2])]
    return corners[0] * np.float32(_SIZE[len(place)])


def _within_period(coordinate):
    if np.abs(coordinate).max(initial=0) < _PERIOD:
        return coordinate
    # Half a cell farther where floats are whole numbers, at which the noise is 0.
    return np.fmod(coordinate, np.float32(_PERIOD)) + np.where(
        np.abs(coordinate) >= 1e6, np.float32(0.5), np.float32(0)
    )


def _signed(hashed, bit, value):
    """The value, negative where the hash has the bit."""
    return np.where(hashed & np.uint32(1 << bit), -value, value)


def _slope(hashed, away):
    """The product of the gradient that the hash chooses and the vector from the corner."""
    if len(away) == 1:
        return _signed(hashed, 3, ((hashed & np.uint32(7)) + np.uint32(1)).astype(np.float32) * away[0])
    if len(away) == 2:
        x, y = away
        first = hashed & np.uint32(4) == 0
        return _signed(hashed, 0, np.where(first, x, y)) + 2 * _signed(hashed, 1, np.where(first, y, x))
    if len(away) == 3:
        x, y, z = away
        kind = hashed & np.uint32(15)
        u = np.where(kind < 8, x, y)
        v = np.where(kind < 4, y, np.where(kind & np.uint32(13) == 12, x, z))
        return _signed(hashed, 0, u) + _signed(hashed, 1, v)
    x, y, z, w = away
    kind = hashed & np.uint32(31)
    u = np.where(kind < 24, x, y)
    v = np.where(kind < 16, y, z)
    return _signed(hashed, 0, u) + _signed(hashed, 1, v) + _signed(hashed, 2, np.where(kind < 8, z, w))
