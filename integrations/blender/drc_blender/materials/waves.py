"""Blender's Wave and Magic Textures on arrays of points, n x 3, already scaled."""

from dataclasses import dataclass

import numpy as np

from .blocks import beside, in_blocks
from .noise import Noise

_PERIODS = np.float32(20)  # the phase, in radians, that bands and rings pass in a unit
_AXES = {"X": 0, "Y": 1, "Z": 2}


@dataclass(frozen=True)
class Wave:
    """shape: BANDS along the axis X, Y, Z or DIAGONAL, or RINGS around X, Y, Z or SPHERICAL; profile: SIN, SAW or TRI. Noise
    of so much detail and roughness, at so many times the scale, distorts the phase."""

    shape: str = "BANDS"
    axis: str = "X"
    profile: str = "SIN"
    detail: float = 2.0
    roughness: float = 0.5

    def values(self, points, distortion=0.0, noise_scale=1.0, phase=0.0):
        """n x 1; the other arguments: numbers, or arrays of 1 or n rows."""
        rows = beside(points, distortion, noise_scale, phase)
        return in_blocks(lambda r: self._block(*np.ascontiguousarray(r.T))[:, None], rows)

    def _block(self, x, y, z, distortion, noise_scale, phase):
        # So that surfaces at whole coordinates are not cut by rounding.
        place = [(c + np.float32(1e-6)) * np.float32(0.999999) for c in (x, y, z)]
        angle = self._across(place) * _PERIODS + phase
        if np.any(distortion):
            noise = Noise("FBM", True, self.detail, self.roughness)
            angle = angle + distortion * (noise.fractal([c * noise_scale for c in place]) * 2 - 1)
        if self.profile == "SIN":
            return np.float32(0.5) + np.float32(0.5) * np.sin(angle - np.float32(np.pi / 2))
        turns = angle / np.float32(2 * np.pi)
        if self.profile == "SAW":
            return turns - np.floor(turns)
        return np.abs(turns - np.floor(turns + np.float32(0.5))) * 2

    def _across(self, place):
        if self.shape == "BANDS":
            return sum(place) / 2 if self.axis == "DIAGONAL" else place[_AXES[self.axis]]
        kept = [c for i, c in enumerate(place) if i != _AXES.get(self.axis)]
        return np.sqrt(sum(c * c for c in kept))


# The steps of the Magic Texture after the first, each a wave of the sum of all three values that takes the place of one
# of them: which, and the signs of the sum. The waves in the order of the steps: c is a cosine, s a sine, in capitals with
# the opposite sign.
_STEPS = (
    (1, (1, -1, 1)),
    (0, (1, -1, -1)),
    (2, (-1, -1, -1)),
    (0, (-1, 1, -1)),
    (1, (-1, 1, 1)),
    (1, (-1, 1, 1)),
    (0, (1, 1, 1)),
    (2, (1, 1, -1)),
    (0, (-1, -1, 1)),
    (1, (1, -1, 1)),
)
_STEP_WAVES = "CcsCSCcsCS"
_WAVES = {"c": np.cos, "C": lambda a: -np.cos(a), "s": np.sin, "S": lambda a: -np.sin(a)}


def magic(points, depth, distortion):
    """n x 3. depth: how many of the ten steps are taken; distortion: a number, or an array of 1 or n rows."""
    return in_blocks(lambda rows: _magic(rows, depth), beside(points, distortion))


def _magic(rows, depth):
    x, y, z = np.ascontiguousarray(rows[:, :3].T) * np.float32(5)
    distortion = rows[:, 3]
    values = [np.sin(x + y + z), np.cos(-x + y - z), -np.cos(-x - y + z)]
    if depth > 0:
        values = [v * distortion for v in values]
    for (which, signs), wave in zip(_STEPS[:depth], _STEP_WAVES):
        values[which] = _WAVES[wave](sum(s * v for s, v in zip(signs, values))) * distortion
    size = np.where(distortion == 0, np.float32(1), 2 * distortion)
    return np.float32(0.5) - np.stack(values, axis=1) / size[:, None]
