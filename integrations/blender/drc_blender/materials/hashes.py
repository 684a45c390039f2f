"""Hashes of numbers and of cells: the random numbers of Blender's procedural textures.

Numbers are hashed by Bob Jenkins' lookup3 (2006), cells from Blender 5 on by the PCG hashes of Jarzynski and Olano, "Hash
Functions for GPU Rendering" (2020). All take arrays of one shape, or numbers beside arrays.
"""

import numpy as np

_SEED = 0xDEADBEEF
_MOST = 0x7FFFFFFF
_MULTIPLIER, _INCREMENT = 1664525, 1013904223  # of the linear congruential generator in "Numerical Recipes"


def _turned(x, k):
    return (x << np.uint32(k)) | (x >> np.uint32(32 - k))


def _mix(a, b, c):
    """Mixes three words reversibly, where more words follow."""
    for turns in (4, 6, 8, 16, 19, 4):
        a, b, c = b, c + b, (a - c) ^ _turned(c, turns)  # the next step is the same on the next words
    return a, b, c


def _final_mix(a, b, c):
    c = (c ^ b) - _turned(b, 14)
    a = (a ^ c) - _turned(c, 11)
    b = (b ^ a) - _turned(a, 25)
    c = (c ^ b) - _turned(b, 16)
    a = (a ^ c) - _turned(c, 4)
    b = (b ^ a) - _turned(a, 14)
    return (c ^ b) - _turned(b, 24)


def jenkins(*words):
    """lookup3 of one to four arrays of uint32."""
    start = np.uint32((_SEED + (len(words) << 2) + 13) & 0xFFFFFFFF)
    with np.errstate(over="ignore"):
        mixed = [w + start for w in words[:3]] + [start] * (3 - len(words))
        if len(words) == 4:
            mixed = list(_mix(*mixed))
            mixed[0] = mixed[0] + words[3]
        return _final_mix(*mixed)


def _bits(number):
    return (np.asarray(number, dtype=np.float32)).view(np.uint32)


def of_numbers(*numbers):
    """A random number in [0, 1] for each row of one to four numbers, by the bits of their floats."""
    return jenkins(*(_bits(n) for n in numbers)).astype(np.float32) * np.float32(1 / 0xFFFFFFFF)


def colour_of_numbers(*numbers):
    """Three such numbers, of which the first is that of of_numbers."""
    if len(numbers) == 4:
        x, y, z, w = numbers
        return [of_numbers(x, y, z, w), of_numbers(z, x, w, y), of_numbers(w, z, y, x)]
    return [of_numbers(*numbers)] + [of_numbers(*numbers, seed) for seed in (1.0, 2.0)]


# By the number of words: what is added to each word in turn is the product of these words, or of this word and the
# multiplier.
_SOURCES = {
    2: ((1,), (0,)),
    3: ((1, 2), (2, 0), (0, 1)),
    4: ((1, 3), (2, 0), (0, 1), (1, 2)),
}


def _pcg(words):
    """Two to four arrays of int32."""
    words = [w * np.int32(_MULTIPLIER) + np.int32(_INCREMENT) for w in words]
    for last in (False, True):
        for i, sources in enumerate(_SOURCES[len(words)]):
            factors = [words[s] for s in sources]
            words[i] = words[i] + (factors[0] * factors[1] if len(factors) == 2 else factors[0] * np.int32(_MULTIPLIER))
        if not last:
            words = [w ^ (w >> np.int32(16)) for w in words]
    return words


class NumberedCells:
    """Random numbers of cells, arrays of int32 by their one to four coordinates: by the bits of floats, as Blender 4 has them."""

    @staticmethod
    def point(cell):
        """As many numbers in [0, 1] as the cell has coordinates."""
        if len(cell) == 4:
            return [of_numbers(*cell[4 - i :], *cell[: 4 - i]) for i in range(4)]
        return [of_numbers(*cell)] + [of_numbers(*cell, seed) for seed in (1.0, 2.0)[: len(cell) - 1]]

    @staticmethod
    def colour(cell):
        """Three numbers in [0, 1]."""
        return colour_of_numbers(*cell)


class IntegerCells:
    """As NumberedCells, by integers, as Blender 5 has them; in one dimension they are the same."""

    @staticmethod
    def point(cell):
        if len(cell) == 1:
            return NumberedCells.point(cell)
        return [(w & np.int32(_MOST)).astype(np.float32) * np.float32(1 / _MOST) for w in _pcg(cell)]

    @staticmethod
    def colour(cell):
        if len(cell) == 1:
            return NumberedCells.colour(cell)
        return IntegerCells.point(list(cell) + [np.zeros_like(cell[0])] * (3 - len(cell)))[:3]
