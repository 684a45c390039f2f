"""Values of material parameters: constants, or functions of the point that a ray meets.

An expression is evaluated on many points at once: an array of 1 or n rows, and of 1 or 3 columns.
"""

import numpy as np

# What an expression depends on: texture coordinates, other properties of the place, the way along a strand of hair.
UV, SPACE, ALONG = "uv", "space", "along"
LUMINANCE = np.array([[0.2126], [0.7152], [0.0722]], dtype=np.float32)


class Expression:
    """function(points) gives the array; needs: a set of (UV, map name), (SPACE,) and (ALONG,), empty for constants;
    image: the Socket of the Image Texture whose colour this is as it stands, if it is one."""

    def __init__(self, function, needs=(), image=None):
        self.function, self.needs, self.image = function, frozenset(needs), image

    def __call__(self, points):
        return np.asarray(self.function(points), dtype=np.float32)

    @property
    def is_constant(self):
        return not self.needs

    def constant(self):
        """The row of values of a constant; elsewhere that at no place in particular."""
        from .points import NOWHERE

        return self(NOWHERE)[0]

    def is_always(self, value):
        return self.is_constant and bool(np.all(self.constant() == value))


def constant(*values):
    row = np.array([values], dtype=np.float32)
    return Expression(lambda points: row)


def combined(function, *parts):
    """function on the arrays of the parts."""
    made = Expression(
        lambda points: function(*(p(points) for p in parts)), frozenset().union(*(p.needs for p in parts))
    )
    if made.is_constant:
        value = made.constant()
        return constant(*value)
    return made


def as_number(expression):
    return combined(lambda v: v if v.shape[1] == 1 else v @ LUMINANCE, expression)


def as_colour(expression):
    made = combined(lambda v: np.repeat(v, 3, axis=1) if v.shape[1] == 1 else v, expression)
    made.image = expression.image
    return made


ZERO, ONE = constant(0.0), constant(1.0)


def product(a, b):
    if a is ONE or b is ZERO:
        return b
    if b is ONE or a is ZERO:
        return a
    return combined(lambda x, y: x * y, a, b)


def total(parts):
    result = None
    for part in parts:
        result = part if result is None else combined(lambda x, y: x + y, result, part)
    return ZERO if result is None else result


def rest(a):
    return combined(lambda x: 1 - x, a)
