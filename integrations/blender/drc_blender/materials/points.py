"""The points at which nodes are evaluated, and what is known there."""

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Points:
    """Arrays of n rows each; what is None is not known."""

    count: int
    uvs: dict = field(default_factory=dict)  # by the map's name; "" is the map that counts where none is named
    generated: np.ndarray = None  # n x 3, in [0, 1] over the bounds of the undeformed mesh
    object: np.ndarray = None  # n x 3, object space
    position: np.ndarray = None  # n x 3, world space
    normal: np.ndarray = None  # n x 3, world space
    attributes: dict = field(default_factory=dict)  # n x 3 colours by name
    along: np.ndarray = None  # n x 1, of hair: from 0 at the root to 1 at the tip
    random: np.ndarray = None  # n x 1, of hair: a number of the strand in [0, 1)

    def uv(self, name=""):
        found = self.uvs.get(name, self.uvs.get(""))
        return np.zeros((self.count, 2), dtype=np.float32) if found is None else found

    def slice(self, begin, end):
        return self.take(slice(begin, min(end, self.count)), min(end, self.count) - begin)

    def take(self, rows, count):
        """rows: of numpy's indices, which choose `count`."""

        def cut(array):
            return None if array is None else array[rows]

        return Points(
            count,
            {k: cut(v) for k, v in self.uvs.items()},
            cut(self.generated),
            cut(self.object),
            cut(self.position),
            cut(self.normal),
            {k: cut(v) for k, v in self.attributes.items()},
            cut(self.along),
            cut(self.random),
        )


NOWHERE = Points(1)
