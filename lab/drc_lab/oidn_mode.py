"""The modes of Open Image Denoise; the best one for a budget makes path tracing with it a fair opponent."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class OidnMode:
    name: str  # as in "path+oidn:balanced-raw"; raw: albedo and normal are not filtered first
    quality: str  # of drc render --oidn-quality
    prefilter: bool  # of drc render --oidn-prefilter
    # The time that one core takes for a pixel of the whole picture; NaN: not measured. Measured with version 2.5 at
    # 1280x720 on two cores of Zen 3: high 13.9 s, balanced-raw 2.0 s, fast-raw 1.1 s. high-raw is the filter of
    # balanced-raw there, bit for bit.
    microseconds: float = math.nan


# From the most expensive to the cheapest.
MODES = (
    OidnMode("high", "high", True, 30),
    OidnMode("balanced", "balanced", True),
    OidnMode("high-raw", "high", False),
    OidnMode("balanced-raw", "balanced", False, 4.4),
    OidnMode("fast-raw", "fast", False, 2.5),
)
_MOST_SHARE = 0.25  # of the budget


def find_mode(name: str) -> OidnMode | None:
    return next((mode for mode in MODES if mode.name == name), None)


def best_mode(seconds: float, pixels: float, threads: int) -> OidnMode:
    """The mode of "path+oidn": the first measured one that takes at most a quarter of the budget, else the cheapest.

    By errors at 1280x720 on two cores, with 10 and 30 s, in three interiors (docs/measuring.md), balanced-raw is best
    or equal to the best in all but one of the six; what high costs is worth more as samples there. Whether high is best
    from 60 s on has not been measured.
    """
    measured = [mode for mode in MODES if not math.isnan(mode.microseconds)]
    for mode in measured:
        if mode.microseconds * 1e-6 * pixels / max(1, threads) <= _MOST_SHARE * seconds:
            return mode
    return measured[-1]
