"""Blender's Noise Texture on arrays of points: sums and products of octaves of gradient noise.

The kinds are those of F. K. Musgrave, "Procedural Fractal Terrains", in Ebert et al., "Texturing & Modeling".
"""

from dataclasses import dataclass

import numpy as np

from .blocks import in_blocks
from .hashes import of_numbers
from .perlin import perlin

_MOST_OCTAVES = 15


@dataclass(frozen=True)
class Noise:
    """kind: FBM, MULTIFRACTAL, RIDGED_MULTIFRACTAL, HYBRID_MULTIFRACTAL or HETERO_TERRAIN; detail: how many finer octaves
    there are, the last by its fraction; offset and gain: of ridged, hybrid and hetero terrain; normalized: fBM alone, to
    [0, 1]; distortion: how far other noise moves the places. points: n x 1 to n x 4, already scaled."""

    kind: str = "FBM"
    normalized: bool = True
    detail: float = 2.0
    roughness: float = 0.5
    lacunarity: float = 2.0
    offset: float = 0.0
    gain: float = 1.0
    distortion: float = 0.0

    def values(self, points):
        """n x 1"""
        return in_blocks(lambda p: self._channels(p, 1), points)

    def colours(self, points):
        """n x 3, of which the first is that of values."""
        return in_blocks(lambda p: self._channels(p, 3), points)

    def _channels(self, points, count):
        place = list(np.ascontiguousarray(points.T, dtype=np.float32))
        dimensions = len(place)
        if self.distortion:
            moved = [perlin(_shifted(place, seed)) for seed in range(dimensions)]
            place = [c + m * np.float32(self.distortion) for c, m in zip(place, moved)]
        # The noise that displaces, and that of the other channels, is the same noise elsewhere.
        places = [place] + [_shifted(place, dimensions + channel) for channel in range(count - 1)]
        with np.errstate(all="ignore"):  # what is no number becomes 0 when it is written
            return np.stack([self.fractal(p) for p in places], axis=1)

    def fractal(self, place):
        """An array. place: a list of arrays of float32, one for each coordinate."""
        return _KINDS[self.kind](self, self._octaves(place))

    def _octaves(self, place):
        """(share, amplitude, noise) of each octave, the coarsest first; the share is below 1 for the last alone."""
        detail, roughness = min(max(self.detail, 0.0), _MOST_OCTAVES), max(self.roughness, 0.0)
        amplitude, frequency = np.float32(1), np.float32(1)
        for number in range(int(np.ceil(detail)) + 1):
            yield min(1.0, detail + 1 - number), amplitude, perlin([c * frequency for c in place])
            amplitude = amplitude * np.float32(roughness)
            frequency = frequency * np.float32(self.lacunarity)


def _shifted(place, seed):
    """Farther by an offset that depends on the seed."""
    if len(place) == 1:
        offsets = [of_numbers(np.float32([seed]))]
    else:
        offsets = [of_numbers(np.float32([seed]), np.float32([axis])) for axis in range(len(place))]
    return [c + (100 + 100 * o) for c, o in zip(place, offsets)]


def _mixed(a, b, share):
    return b if share == 1 else a + (b - a) * np.float32(share)


def _fbm(noise, octaves):
    total, most, result = np.float32(0), np.float32(0), None
    for share, amplitude, value in octaves:
        total, most = total + value * amplitude, most + amplitude
        result = _mixed(result, np.float32(0.5) * total / most + np.float32(0.5) if noise.normalized else total, share)
    return result


def _multifractal(_noise, octaves):
    product = np.float32(1)
    for share, amplitude, value in octaves:
        product = product * (np.float32(share) * amplitude * value + 1)
    return product


def _hetero_terrain(noise, octaves):
    total, offset = None, np.float32(noise.offset)
    for share, amplitude, value in octaves:
        if total is None:
            total = value + offset
        else:
            total = total + np.float32(share) * (value + offset) * amplitude * total
    return total


def _hybrid(noise, octaves):
    """Octaves count less where the coarser ones are low, and no more where they are near 0."""
    total, weight = np.float32(0), np.float32(1)
    for share, amplitude, value in octaves:
        counts = weight > 0.001
        weight = np.minimum(weight, np.float32(1))
        signal = (value + np.float32(noise.offset)) * amplitude
        total = total + np.where(counts, np.float32(share) * weight * signal, np.float32(0))
        weight = np.where(counts, weight * np.float32(noise.gain) * signal, weight)
    return total


def _ridged(noise, octaves):
    """Ridges where the noise changes its sign; finer ones on them alone. Fractions of octaves are not told."""
    total = None
    for share, amplitude, value in octaves:
        signal = (np.float32(noise.offset) - np.abs(value)) ** 2
        if total is None:
            total = signal
        elif share == 1:
            signal = signal * np.clip(previous * np.float32(noise.gain), 0, 1)
            total = total + signal * amplitude
        previous = signal
    return total


_KINDS = {
    "FBM": _fbm,
    "HETERO_TERRAIN": _hetero_terrain,
    "HYBRID_MULTIFRACTAL": _hybrid,
    "MULTIFRACTAL": _multifractal,
    "RIDGED_MULTIFRACTAL": _ridged,
}
