"""The page's tables of methods that had the same seconds."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from markupsafe import Markup

from . import measures as m
from .budget import SECONDS, Budget
from .measures import Measure, MeasuredSpread, spread_over, spread_text
from .number_text import significant, two_decimals
from .page_cell import Cell
from .result import NOT_MEASURED, OPPONENT, Report, Run, Scene, failures_of, is_noisy, opponent_error, runs_of

COLUMNS = (
    m.ERROR, m.TRIMMED_ERROR, m.BLOCK_ERROR, m.SSIM, m.FLIP, m.SPP, m.LOAD_SECONDS, m.RENDER_SECONDS, m.DENOISE_SECONDS,
    m.WRITE_SECONDS, m.SECONDS, m.CPU_SECONDS, m.PEAK_MB,
)  # fmt: skip
COLUMN_COUNT = len(COLUMNS) + 1  # and, beside the error, its ratio to the opponent's


@dataclass
class Row:
    method: str
    cells: list[Cell] = field(default_factory=list)  # empty: all runs failed
    failure: str = ""


@dataclass
class MeanRow:
    method: str
    ratio: Markup
    scenes: int


@dataclass
class Table:
    budget: Budget
    blocks: list[tuple[str, list[Row]]]  # by scene
    base: str = ""  # the method whose error is the unit of the means
    means: list[MeanRow] = field(default_factory=list)


def _is_clearly_better(a: MeasuredSpread, b: MeasuredSpread, better: int) -> bool:
    """By more than the standard errors of both together and, of several repeats, with intervals that do not overlap."""
    error = math.hypot(*(0 if math.isnan(s.standard_error) else s.standard_error for s in (a, b)))
    if not better * (a.median - b.median) > error:
        return False
    overlap = a.low <= b.high if better > 0 else a.high >= b.low
    return a.count < 2 or b.count < 2 or not overlap


def _best_of(methods: list[MeasuredSpread], better: int) -> float:
    """The best median, which several may have; NaN if fewer than two have one, or if it is not clearly the best."""
    known = [spread for spread in methods if not math.isnan(spread.median)]
    if len(known) < 2 or better == 0:
        return NOT_MEASURED
    best = max(known, key=lambda spread: better * spread.median)
    others = [spread for spread in known if spread.median != best.median]
    return best.median if all(_is_clearly_better(best, other, better) for other in others) else NOT_MEASURED


def _is_noisy(scene: Scene, measure: Measure, value: float) -> bool:
    if measure is m.SSIM:
        return is_noisy(value, 1, scene.ssim_noise)
    return measure is m.FLIP and is_noisy(value, 0, scene.flip_noise)


def _cells(report: Report, scene: Scene, budget: Budget, runs: list[list[Run]]) -> list[list[Cell]]:
    """By method."""
    cells: list[list[Cell]] = [[] for _ in runs]
    opponent = opponent_error(report, scene.name, budget)
    for measure in COLUMNS:
        spreads = [spread_over(of_method, measure) for of_method in runs]
        best = _best_of(spreads, measure.better)
        if _is_noisy(scene, measure, best):
            best = NOT_MEASURED
        for row, spread in zip(cells, spreads):
            # Time and memory are shown as medians alone, without their spread.
            text = spread_text(spread, measure) if measure.better else measure.text(spread.median)
            mark = Markup("~" if _is_noisy(scene, measure, spread.median) else "")
            row.append(Cell(mark + text, spread.median == best))
            if measure is m.ERROR:
                row.append(Cell(two_decimals(spread.median / opponent)))
    return cells


def _failure_text(failures: list[Run], succeeded: int) -> str:
    if not failures:
        return ""
    reason = failures[0].failure
    return f"{len(failures)} of {len(failures) + succeeded} failed: {reason}" if succeeded else reason


def _rows(report: Report, scene: Scene, budget: Budget) -> list[Row]:
    runs = [runs_of(report, scene.name, method, budget) for method in report.methods]
    rows = []
    for method, own, cells in zip(report.methods, runs, _cells(report, scene, budget, runs)):
        failure = _failure_text(failures_of(report, scene.name, method, budget), len(own))
        if own or failure:
            rows.append(Row(method, cells if own else [], failure))
    return rows


def _add_means(report: Report, table: Table) -> None:
    """Geometric means of the errors, in units of the opponent's, or of the first method's if that was not run."""
    names = [scene.name for scene in report.scenes]
    opponents = {name: opponent_error(report, name, table.budget) for name in names}

    def errors_of(method: str) -> dict[str, float]:
        return {name: spread_over(runs_of(report, name, method, table.budget), m.ERROR).median for name in names}

    has_opponent = not all(math.isnan(error) for error in opponents.values())
    base = opponents if has_opponent else errors_of(report.methods[0])
    means = []
    for method in report.methods:
        own = errors_of(method)
        logs = [math.log(own[n] / base[n]) for n in names if 0 < own[n] < math.inf and 0 < base[n] < math.inf]
        if logs:
            means.append(MeanRow(method, significant(math.exp(sum(logs) / len(logs))), len(logs)))
    if has_opponent or any(mean.method == report.methods[0] for mean in means):
        table.base = f"the best {OPPONENT}" if has_opponent else report.methods[0]
        table.means = means


def equal_time_tables(report: Report) -> list[Table]:
    tables = []
    for budget in m.budgets_of(report, SECONDS):
        blocks = [(scene.name, rows) for scene in report.scenes if (rows := _rows(report, scene, budget))]
        if blocks:
            tables.append(Table(budget, blocks))
            _add_means(report, tables[-1])
    return tables
