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

    def uv(self, name=""):
        found = self.uvs.get(name, self.uvs.get(""))
        return np.zeros((self.count, 2), dtype=np.float32) if found is None else found

    def slice(self, begin, end):
        def cut(array):
            return None if array is None else array[begin:end]

        return Points(
            min(end, self.count) - begin,
            {k: cut(v) for k, v in self.uvs.items()},
            cut(self.generated),
            cut(self.object),
            cut(self.position),
            cut(self.normal),
            {k: cut(v) for k, v in self.attributes.items()},
        )


NOWHERE = Points(1)
