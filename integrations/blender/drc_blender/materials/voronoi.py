"""Blender's Voronoi Texture on arrays of points: octaves of the features of voronoi_cells."""

import math
from dataclasses import dataclass

import numpy as np

from .blocks import in_blocks
from .hashes import IntegerCells
from .voronoi_cells import Cells, distance_to_edge, nearest, radius, smooth_nearest

_MOST_OCTAVES = 15
_FAR_FROM_EDGES = 8.0  # farther than any place is


@dataclass(frozen=True)
class Voronoi:
    """feature: F1, F2, SMOOTH_F1, DISTANCE_TO_EDGE or N_SPHERE_RADIUS; metric: EUCLIDEAN, MANHATTAN, CHEBYCHEV or
    MINKOWSKI, which has an exponent; detail: how many finer octaves there are, the last by its fraction. hashes: those of the
    version of Blender. points: n x 1 to n x 4, already scaled."""

    feature: str = "F1"
    metric: str = "EUCLIDEAN"
    normalized: bool = False
    detail: float = 0.0
    roughness: float = 0.5
    lacunarity: float = 2.0
    smoothness: float = 1.0
    exponent: float = 0.5
    randomness: float = 1.0
    hashes: type = IntegerCells

    def distances(self, points):
        """n x 1: the distance, or the radius, of which the feature tells."""
        return self._evaluated(points, "distance")

    def colours(self, points):
        """n x 3: random colours of the points' cells, for F1, F2 and SMOOTH_F1."""
        return self._evaluated(points, "colour")

    def positions(self, points):
        """As points: where the points in the cells are, for F1, F2 and SMOOTH_F1."""
        return self._evaluated(points, "position")

    def _evaluated(self, points, wanted):
        def block(some):
            place = np.ascontiguousarray(some.T, dtype=np.float32)
            with np.errstate(all="ignore"):  # what is no number becomes 0 when it is written
                return np.stack(self._octaves(place, wanted), axis=1)

        return in_blocks(block, points)

    @property
    def _cells(self):
        return Cells(self.metric, self.exponent, min(max(self.randomness, 0.0), 1.0), self.hashes)

    def _octave(self, place, wanted):
        """The arrays of the columns."""
        if self.feature == "DISTANCE_TO_EDGE":
            return [distance_to_edge(self._cells, place)]
        if self.feature == "SMOOTH_F1":
            return smooth_nearest(self._cells, place, min(max(self.smoothness / 2, 0.0), 0.5), wanted)
        return nearest(self._cells, place, 1 if self.feature == "F2" else 0).value(wanted)

    def _octaves(self, place, wanted):
        if self.feature == "N_SPHERE_RADIUS":
            return [radius(self._cells, place)]
        largest = self._largest_distance(len(place)) if wanted == "distance" else 1.0
        detail, roughness = min(max(self.detail, 0.0), _MOST_OCTAVES), min(max(self.roughness, 0.0), 1.0)
        if detail == 0 or roughness == 0:
            total = self._octave(place, wanted)
        else:
            total, largest = self._sum(place, wanted, detail, roughness, largest)
        return [t / np.float32(largest) for t in total] if self.normalized and wanted != "position" else total

    def _sum(self, place, wanted, detail, roughness, largest):
        """(sum of the octaves, the largest that it can be). Distances and colours are added; a finer position or a nearer
        edge replaces the coarser by a share."""
        edge = self.feature == "DISTANCE_TO_EDGE"

        def with_octave(before, octave, amplitude, scale):
            if edge:
                return _mixed(before, np.minimum(before, octave / scale), amplitude)
            if wanted == "position":
                return _mixed(before, octave / scale, amplitude)
            return before + octave * np.float32(amplitude)

        totals = [np.float32(_FAR_FROM_EDGES if edge else 0)] * {"distance": 1, "colour": 3, "position": len(place)}[
            wanted
        ]
        most = largest if edge else 0.0
        amplitude, scale = 1.0, np.float32(1)
        for number in range(math.ceil(detail) + 1):
            share = min(1.0, detail + 1 - number)
            octave = self._octave(place * scale, wanted)
            finer = [with_octave(t, o, amplitude, scale) for t, o in zip(totals, octave)]
            totals = [_mixed(t, f, share) for t, f in zip(totals, finer)]
            more = _mixed(most, largest / scale, amplitude) if edge else most + largest * amplitude
            most = _mixed(most, more, share)
            amplitude *= roughness
            scale *= np.float32(self.lacunarity)
        return totals, most

    def _largest_distance(self, dimensions):
        """By which distances are divided to be normalized."""
        side = 0.5 + 0.5 * self._cells.randomness
        if self.feature == "DISTANCE_TO_EDGE":
            return side
        return float(self._cells.length([np.float32(side)] * dimensions)) * (2 if self.feature == "F2" else 1)


def _mixed(a, b, share):
    return a + (b - a) * np.float32(share)
