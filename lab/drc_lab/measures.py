"""The parts of a comparison's page share this: the quantities, how each is written, and which budgets there are."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from markupsafe import Markup

from .budget import Budget
from .number_text import four_decimals, no_decimals, one_decimal, significant, two_decimals
from .result import NOT_MEASURED, Report, Run, Spread, spread_of

_COLOUR_ORDER = (2, 5, 3, 1, 4, 6, 7, 0)  # the first ones differ most


@dataclass(frozen=True)
class Measure:
    title: str
    name: str  # of Run's attribute
    text: Callable[[float], Markup]
    better: int = 0  # 1: larger is better; -1: smaller is; 0: neither
    has_standard_error: bool = False

    @property
    def arrow(self) -> str:
        """Points to where better is."""
        return {1: "↑", -1: "↓", 0: ""}[self.better]


SSIM = Measure("SSIM", "ssim", four_decimals, 1)
FLIP = Measure("FLIP", "flip", four_decimals, -1)
ERROR = Measure("error", "error", significant, -1, True)
TRIMMED_ERROR = Measure("trimmed", "trimmed_error", significant, -1, True)
BLOCK_ERROR = Measure("blocks", "block_error", significant, -1, True)
SPP = Measure("spp", "spp", no_decimals)
LOAD_SECONDS = Measure("load", "load_seconds", two_decimals)
RENDER_SECONDS = Measure("render", "render_seconds", two_decimals)
DENOISE_SECONDS = Measure("denoise", "denoise_seconds", two_decimals)
WRITE_SECONDS = Measure("write", "write_seconds", two_decimals)
SECONDS = Measure("seconds", "seconds", two_decimals)
CPU_SECONDS = Measure("CPU s", "cpu_seconds", one_decimal)
PEAK_MB = Measure("peak MB", "peak_mb", no_decimals)
PNG_KB = Measure("PNG KB", "png_kb", one_decimal)


@dataclass
class MeasuredSpread(Spread):
    standard_error: float = NOT_MEASURED  # median over the runs


def spread_over(runs: list[Run], measure: Measure) -> MeasuredSpread:
    spread = spread_of([getattr(run, measure.name) for run in runs])
    errors = [getattr(run, f"{measure.name}_se") for run in runs] if measure.has_standard_error else []
    return MeasuredSpread(**spread.__dict__, standard_error=spread_of(errors).median)


def spread_text(spread: MeasuredSpread, measure: Measure) -> Markup:
    """The median and, in small type, the standard error of a run and the range of the repeats, if there are several."""
    parts = []
    if not math.isnan(spread.standard_error):
        parts.append(Markup("&#177;&#8202;") + measure.text(spread.standard_error))
    if spread.count > 1:
        parts.append(measure.text(spread.low) + Markup("&#8202;&#8211;&#8202;") + measure.text(spread.high))
    small = Markup("<small>{}</small>").format(Markup("; ").join(parts)) if parts else ""
    return measure.text(spread.median) + small


def budgets_of(report: Report, unit: str) -> list[Budget]:
    """The budgets in that unit, smallest first, each once."""
    return sorted({budget for budget in report.budgets if budget.unit == unit}, key=lambda budget: budget.amount)


def method_colour(method: int) -> int:
    """The colour of a method, on the whole page."""
    return _COLOUR_ORDER[method % len(_COLOUR_ORDER)]
