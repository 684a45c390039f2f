"""How hair looks: each strand, or piece of a strand, has one look, and there are only so many of them."""

import numpy as np

from ..export.cache import digest
from .clusters import groups_of
from .textures import evaluated

STANDING_FOR_ALL = 64  # of a group, whose mean is taken


def looks_of(plan, points):
    """The numbers of the points that look alike, group by group."""
    return groups_of(np.concatenate([finite(e, points) for e in plan.expressions() if e.needs], axis=1))


def finite(expression, points):
    """All points; what is no number is zero, as in images."""
    return evaluated(expression, points, expression(points.take([0], 1)).shape[1])


class StrandLook:
    """The mean over a group; as values of a material, see MaterialWriter."""

    def __init__(self, points, rows):
        some = rows[:: -(-len(rows) // STANDING_FOR_ALL)]
        self.points = points.take(some, len(some))

    def _mean(self, expression):
        return finite(expression, self.points).mean(axis=0, dtype=np.float64)

    def key(self, plan):
        return digest(*(self._mean(e) for e in plan.expressions() if e.needs))

    def parameter(self, declared, expression, _name):
        value = self._mean(expression)
        return {declared: np.broadcast_to(value, 3) if declared.startswith("rgb") else float(value[0])}

    def normal_map(self, _expression):
        return None

    def emission(self, _expression):
        return {}
