"""pbrt-v4's picture of all directions: a square in which areas are solid angles (Clarberg 2008)."""

import numpy as np


def directions(size):
    """size x size x 3: the unit vectors of the pixels' centres, first row first."""
    centre = (np.arange(size) + 0.5) / size * 2 - 1
    u, v = np.meshgrid(centre, centre)
    inside = 1 - np.abs(u) - np.abs(v)  # negative in the corners, where the lower hemisphere is folded out
    r = 1 - np.abs(inside)
    with np.errstate(invalid="ignore", divide="ignore"):
        turn = np.where(r == 0, 1.0, (np.abs(v) - np.abs(u)) / r + 1)
    phi = turn * (np.pi / 4)
    sine = r * np.sqrt(np.maximum(0, 2 - r * r))
    return np.stack(
        [sine * np.copysign(np.cos(phi), u), sine * np.copysign(np.sin(phi), v), np.copysign(1 - r * r, inside)],
        axis=-1,
    )
