"""The plots of a comparison's page: error against time, and memory against tasks."""

from __future__ import annotations

from dataclasses import dataclass

from markupsafe import Markup

from . import measures as m
from .budget import TASKS, UNITS, Budget
from .measures import Measure, budgets_of, method_colour, spread_over
from .plots import Point, Series, line_plot
from .result import Report, Run, runs_of

_MARKERS = dict(zip(UNITS, "osD"))
_ERRORS = (("error", m.ERROR), ("1 − SSIM", m.SSIM), ("FLIP", m.FLIP))


@dataclass
class Curves:
    title: str
    legend: list[tuple[str, int]]  # names and colours
    plots: list[Markup]


@dataclass
class Growth:
    method: str
    fewest: tuple[str, str]  # megabytes, and the budget
    most: tuple[str, str]
    change: str


def _error_of(value: float, measure: Measure) -> float:
    return 1 - value if measure.better > 0 else value


def error_series(report: Report, scene: str, title: str, measure: Measure) -> list[Series]:
    """A line for each method and unit of its budgets."""
    series = []
    for number, method in enumerate(report.methods):
        for unit in UNITS:
            one = Series(method, method_colour(number), _MARKERS[unit])
            for budget in budgets_of(report, unit):
                point = _error_point(runs_of(report, scene, method, budget), measure)
                if point.x > 0 and point.y > 0:
                    point.title = f"{method}, {budget.name}: {title} {point.y:.4g} in {point.x:.2f} s"
                    one.points.append(point)
            if one.points:
                series.append(one)
    return series


def _error_point(runs: list[Run], measure: Measure) -> Point:
    spread = spread_over(runs, measure)
    point = Point(spread_over(runs, m.SECONDS).median, _error_of(spread.median, measure))
    if spread.count > 1:
        point.low, point.high = sorted(_error_of(end, measure) for end in (spread.low, spread.high))
    return point


def _legend(report: Report, series: list[Series]) -> list[tuple[str, int]]:
    shown = {one.label for one in series}
    return [(method, method_colour(number)) for number, method in enumerate(report.methods) if method in shown]


def error_curves(report: Report) -> list[Curves]:
    """For each scene the error, 1 - SSIM and FLIP against the seconds of the process; none without two budgets."""
    curves = []
    for scene in report.scenes:
        plots, last = [], []
        for title, measure in _ERRORS:
            series = error_series(report, scene.name, title, measure)
            if any(len(one.points) > 1 for one in series):
                plots.append(line_plot(title, "seconds", series, log_y=True))
                last = series
        if plots:
            curves.append(Curves(scene.name, _legend(report, last), plots))
    return curves


def memory_series(report: Report, scene: str) -> list[Series]:
    """The peak memory of methods with two or more budgets in tasks."""
    series = []
    for number, method in enumerate(report.methods):
        one = Series(method, method_colour(number), _MARKERS[TASKS])
        for budget in budgets_of(report, TASKS):
            megabytes = spread_over(runs_of(report, scene, method, budget), m.PEAK_MB).median
            if megabytes > 0:
                one.points.append(Point(budget.amount, megabytes, f"{method}, {budget.name}: {megabytes:.0f} MB"))
        if len(one.points) > 1:
            series.append(one)
    return series


def growth_of(series: Series) -> Growth:
    first, last = series.points[0], series.points[-1]
    change = 100 * (last.y / first.y - 1)
    ends = [(f"{p.y:.0f}", Budget(TASKS, p.x).name) for p in (first, last)]
    return Growth(series.label, ends[0], ends[1], f"{'−' if change < 0 else '+'}{abs(change):.1f}")


def memory_curves(report: Report) -> tuple[Curves, list[tuple[str, list[Growth]]]] | None:
    """One plot for each scene, and the growth by scene; none if no method has two numbers of tasks."""
    plots, growth, everything = [], [], []
    for scene in report.scenes:
        if series := memory_series(report, scene.name):
            ticks = sorted({point.x for one in series for point in one.points})
            plots.append(line_plot(f"{scene.name}, peak MB", "tasks", series, log_y=False, x_ticks=ticks))
            growth.append((scene.name, [growth_of(one) for one in series]))
            everything += series
    return (Curves("", _legend(report, everything), plots), growth) if plots else None
