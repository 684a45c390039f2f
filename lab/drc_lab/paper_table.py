"""The page's tables in the units of each method, tasks and samples, as the paper has them."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from markupsafe import Markup

from . import measures as m
from .budget import SPP, TASKS, Budget
from .measures import budgets_of, spread_over
from .number_text import one_decimal, two_decimals
from .result import NOT_MEASURED, Report, Scene, failures_of, runs_of

COLUMNS = (m.SECONDS, m.SSIM, m.PNG_KB)
_PAPER_TASKS = 16


@dataclass(frozen=True)
class MethodUnit:
    """A method as far as its budgets are of one unit."""

    method: str
    unit: str


@dataclass
class Group:
    """The cells of a method for one amount: numbers, a failure, or nothing where it was not run."""

    cells: list[Markup] = field(default_factory=list)
    failure: str = ""


@dataclass
class Beside:
    """SSIM of a method with maps, and of another one in the same time and in four times that."""

    ours: str
    other: str
    ssim: Markup
    last: Markup
    last_budget: str
    same_time: Markup
    later: Markup


@dataclass
class PaperTable:
    scene: str
    png_kb: Markup
    entropy: Markup
    columns: list[MethodUnit]
    rows: list[tuple[str, list[Group]]]  # by amount
    beside: list[Beside]


def _columns_of(report: Report, scene: str, unit: str) -> list[MethodUnit]:
    def was_tried(method: str) -> bool:
        return any(
            runs_of(report, scene, method, budget) or failures_of(report, scene, method, budget)
            for budget in budgets_of(report, unit)
        )

    return [MethodUnit(method, unit) for method in report.methods if was_tried(method)]


def _group(report: Report, scene: str, column: MethodUnit, amount: float) -> Group:
    budget = Budget(column.unit, amount)
    runs = runs_of(report, scene, column.method, budget)
    failures = failures_of(report, scene, column.method, budget)
    if failures and not runs:
        return Group(failure=failures[0].failure)
    texts = [measure.text(spread_over(runs, measure).median) for measure in COLUMNS] if runs else [Markup("")] * 3
    return Group(texts)


def ssim_after(report: Report, scene: str, method: str, unit: str, seconds: float) -> float:
    """SSIM after that time, linear in the logarithm of time between two runs; NaN outside of what was run."""
    points = []
    for budget in budgets_of(report, unit):
        runs = runs_of(report, scene, method, budget)
        time, ssim = spread_over(runs, m.SECONDS).median, spread_over(runs, m.SSIM).median
        if time > 0 and not math.isnan(ssim):
            points.append((time, ssim))
    points.sort()
    for (t0, s0), (t1, s1) in zip(points, points[1:]):
        if t0 <= seconds <= t1 and t1 > t0:
            return s0 + (s1 - s0) * math.log(seconds / t0) / math.log(t1 / t0)
    return NOT_MEASURED


def _beside(report: Report, scene: str, ours: MethodUnit, others: list[MethodUnit]) -> list[Beside]:
    at_tasks = runs_of(report, scene, ours.method, Budget(TASKS, _PAPER_TASKS))
    seconds, ssim = spread_over(at_tasks, m.SECONDS).median, spread_over(at_tasks, m.SSIM).median
    last, most = NOT_MEASURED, 0.0
    for budget in budgets_of(report, TASKS):
        if runs := runs_of(report, scene, ours.method, budget):
            last, most = spread_over(runs, m.SSIM).median, budget.amount
    rows = []
    for other in others:
        same, later = (ssim_after(report, scene, other.method, other.unit, factor * seconds) for factor in (1, 4))
        if math.isnan(same) and math.isnan(later):
            continue
        last_budget = "" if most == _PAPER_TASKS else f"at {Budget(TASKS, most).name}"
        texts = map(two_decimals, (ssim, last, same, later))
        ssim_text, last_text, same_text, later_text = texts
        rows.append(Beside(ours.method, other.method, ssim_text, last_text, last_budget, same_text, later_text))
    return rows


def _table(report: Report, scene: Scene) -> PaperTable | None:
    tasks, samples = (_columns_of(report, scene.name, unit) for unit in (TASKS, SPP))
    columns = tasks + samples
    if not columns:
        return None
    amounts = sorted({budget.amount for column in columns for budget in budgets_of(report, column.unit)})
    return PaperTable(
        scene=scene.name,
        png_kb=one_decimal(scene.reference_png_kb),
        entropy=two_decimals(scene.reference_entropy),
        columns=columns,
        rows=[
            (f"{amount:g}", [_group(report, scene.name, column, amount) for column in columns]) for amount in amounts
        ],
        beside=[row for ours in tasks for row in _beside(report, scene.name, ours, samples)],
    )


def paper_tables(report: Report) -> list[PaperTable]:
    return [table for scene in report.scenes if (table := _table(report, scene))]
