"""Numbers as HTML."""

from __future__ import annotations

import math

from markupsafe import Markup

DASH = Markup("&#8211;")  # stands for what is not known
SMALLEST_P = 1e-300


def decimals(count: int):
    return lambda x: DASH if math.isnan(x) else Markup(f"{x:.{count}f}")


four_decimals, two_decimals, one_decimal, no_decimals = map(decimals, (4, 2, 1, 0))


def _scientific(x: float, count: int) -> Markup:
    mantissa, _, exponent = f"{x:.{count}e}".partition("e")  # note that 9.96e-5 is rounded to 1.0e-04
    power = ("&#8722;" if int(exponent) < 0 else "") + str(abs(int(exponent)))
    return Markup(f"{mantissa}&#8201;&#215;&#8201;10<sup>{power}</sup>")


def significant(x: float) -> Markup:
    """Three digits count."""
    if math.isnan(x):
        return DASH
    if math.isinf(x):
        return Markup("&#8734;" if x > 0 else "&#8722;&#8734;")
    size = abs(float(f"{x:.2e}"))  # rounded first: 9.996 becomes 10.0
    if size == 0:
        return Markup("0")
    if 1e-4 <= size < 1e5:
        decade = math.floor(math.log10(size) + 1e-9)
        return Markup(f"{x:.{max(0, 2 - decade)}f}")
    return _scientific(x, 2)


def p_value(p: float) -> Markup:
    if math.isnan(p):
        return DASH
    if p <= SMALLEST_P:
        return Markup("&lt;&#8201;10<sup>&#8722;300</sup>")
    return Markup(f"{p:#.2g}") if p >= 0.001 else _scientific(p, 1)
