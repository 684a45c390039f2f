"""The features of Blender's Voronoi Texture, in one octave.

Space is cut into unit cells, each with one point at a random place in it (Worley, "A Cellular Texture Basis Function",
1996). Places are lists of one to four arrays of coordinates, so that numpy works on contiguous numbers.
"""

import itertools
import math
from dataclasses import dataclass, replace

import numpy as np

from .hashes import IntegerCells

_FAR = np.finfo(np.float32).max
_SAME = 1e-4  # square of the distance within which two points have no edge between them, in two and more dimensions


@dataclass(frozen=True)
class Cells:
    """metric: EUCLIDEAN, MANHATTAN, CHEBYCHEV or MINKOWSKI, which has an exponent; randomness: 0 puts each point in its
    cell's lowest corner, 1 anywhere in the cell; hashes: NumberedCells or IntegerCells."""

    metric: str
    exponent: float
    randomness: float
    hashes: type = IntegerCells

    def point(self, cell):
        """The place of the cell's point in it."""
        return [p * np.float32(self.randomness) for p in self.hashes.point(cell)]

    def length(self, vector):
        if len(vector) == 1:
            return np.abs(vector[0])
        if self.metric == "EUCLIDEAN":
            return np.sqrt(_square(vector))
        sizes = [np.abs(c) for c in vector]
        if self.metric == "MANHATTAN":
            return sum(sizes[1:], sizes[0])
        if self.metric == "CHEBYCHEV":
            return np.max(sizes, axis=0)
        exponent = np.float32(self.exponent)
        return sum(s**exponent for s in sizes) ** (1 / exponent)


@dataclass
class Found:
    """distance: the array of it; owner: the cell whose point it is. Its colour and place are made when they are asked."""

    cells: Cells
    distance: np.ndarray
    owner: list

    def value(self, wanted):
        """wanted: "distance", "colour" or "position"; the arrays of its columns."""
        if wanted == "distance":
            return [self.distance]
        if wanted == "colour":
            return self.cells.hashes.colour(self.owner)
        return [c.astype(np.float32) + p for c, p in zip(self.owner, self.cells.point(self.owner))]


class _Around:
    """The cells within a reach of the cells of places. Places of a block are near each other more often than not: what is
    random in these cells is computed once for all places, unless there are fewer places than cells."""

    def __init__(self, cells, cell, reach):
        self.cells, self.cell, self.reach = cells, cell, reach
        self.offsets = _offsets(len(cell), reach)
        self.low = [int(c.min()) - reach for c in cell]
        self.sides = [int(c.max()) + reach + 1 - low for c, low in zip(cell, self.low)]
        self.tables = {}
        if math.prod(self.sides) <= len(cell[0]):
            self.index = np.ravel_multi_index([c - low for c, low in zip(cell, self.low)], self.sides)
        else:
            self.index = None

    def of(self, function, offset):
        """The arrays that a function of cells gives for the cells that are beside by the offset."""
        if self.index is None:
            return function(_beside(self.cell, offset))
        if function not in self.tables:
            grid = np.indices(self.sides, dtype=np.int32).reshape(len(self.sides), -1)
            self.tables[function] = function([(g + np.int64(low)).astype(np.int32) for g, low in zip(grid, self.low)])
        middle = np.ravel_multi_index([self.reach] * len(self.sides), self.sides)
        there = np.ravel_multi_index([self.reach + o for o in offset], self.sides)
        return [table[self.index + (there - middle)] for table in self.tables[function]]

    def towards(self, local, offset):
        """The vectors from places in their cells to the points of the cells beside."""
        points = self.of(self.cells.point, offset)
        return [np.float32(o) + p - l for o, p, l in zip(offset, points, local)]


def nearest(cells, place, rank=0):
    """The nearest point or, with rank 1, the second."""
    cell, local = _split(place)
    around = _Around(cells, cell, 1)
    offsets = around.offsets
    distances = [np.full(len(place[0]), _FAR) for _ in range(rank + 1)]
    owners = [np.full(len(place[0]), len(offsets) // 2, dtype=np.int16) for _ in range(rank + 1)]
    for number, offset in enumerate(offsets):
        distance, owner = cells.length(around.towards(local, offset)), np.int16(number)
        for i in range(rank + 1):  # what is nearer takes the place, and what was there goes on to the next
            nearer = distance < distances[i]
            distances[i], distance = np.where(nearer, distance, distances[i]), np.where(nearer, distances[i], distance)
            owners[i], owner = np.where(nearer, owner, owners[i]), np.where(nearer, owners[i], owner)
    chosen = np.array(offsets, dtype=np.int32)[owners[rank]].T
    return Found(cells, distances[rank], [c + o for c, o in zip(cell, chosen)])


def smooth_nearest(cells, place, width, wanted):
    """As nearest(...).value(wanted), with a minimum that is smooth over a range of distances of that width."""
    cell, local = _split(place)
    around = _Around(cells, cell, 2)
    smooth, values, width = None, None, np.float32(width)
    for offset in around.offsets:
        vector = around.towards(local, offset)
        distance = cells.length(vector)
        if wanted == "distance":
            found = []
        elif wanted == "colour":
            found = around.of(cells.hashes.colour, offset)
        else:
            found = [v + p for v, p in zip(vector, place)]
        if smooth is None:
            smooth, values = distance, found
            continue
        share = np.clip(np.float32(0.5) + np.float32(0.5) * (smooth - distance) / width, 0, 1)
        share = share * share * (3 - 2 * share)
        lower = width * share * (1 - share)
        smooth = smooth + (distance - smooth) * share - lower
        lower = lower / (1 + 3 * width)
        values = [v + (f - v) * share - lower for v, f in zip(values, found)]
    return [smooth] if wanted == "distance" else values


def distance_to_edge(cells, place):
    """To the nearest of the planes half way between the nearest point and the others."""
    cell, local = _split(place)
    around = _Around(cells, cell, 1)
    vectors = [around.towards(local, o) for o in around.offsets]
    least, closest = np.full(len(place[0]), _FAR), [np.zeros_like(c) for c in place]
    for vector in vectors:
        square = _square(vector)
        nearer = square < least
        least = np.where(nearer, square, least)
        closest = [np.where(nearer, v, c) for v, c in zip(vector, closest)]
    edge = np.full(len(place[0]), _FAR)
    for vector in vectors:
        across = [v - c for v, c in zip(vector, closest)]
        square = _square(across)
        distance = sum((v + c) * a for v, c, a in zip(vector, closest, across)) / (2 * np.sqrt(square))
        edge = np.where(square > (_SAME if len(place) > 1 else 0), np.minimum(edge, distance), edge)
    return edge


def radius(cells, place):
    """Of the largest balls around the points that do not meet: half the distance between the nearest point and the
    point nearest to that."""
    euclidean = replace(cells, metric="EUCLIDEAN")
    owner = nearest(euclidean, place).owner
    local = euclidean.point(owner)
    around = _Around(euclidean, owner, 1)
    return np.min([euclidean.length(around.towards(local, o)) for o in around.offsets if any(o)], axis=0) / 2


def _split(place):
    """(cell, place in it)"""
    whole = [np.floor(c) for c in place]
    return [w.astype(np.int32) for w in whole], [c - w for c, w in zip(place, whole)]


def _offsets(dimensions, reach):
    """To the cells around a cell, the first coordinate changing fastest: smooth_nearest depends on the order."""
    return [o[::-1] for o in itertools.product(range(-reach, reach + 1), repeat=dimensions)]


def _beside(cell, offset):
    return [c + np.int32(o) for c, o in zip(cell, offset)]


def _square(vector):
    return sum(c * c for c in vector)
