"""Plots by matplotlib, as SVG that becomes a part of a page and has the page's colours, light or dark."""

from __future__ import annotations

import html
import io
import itertools
import math
import re
from dataclasses import dataclass, field

import matplotlib

matplotlib.use("svg")

import matplotlib.ticker
from markupsafe import Markup
from matplotlib.axes import Axes
from matplotlib.figure import Figure

# Colours that the style sheet has as variables. Those of series are --c0 to --c7.
SERIES = ("#85898d", "#b57a1c", "#22689c", "#2f8456", "#8a4a9c", "#b4443f", "#4d7c86", "#7a6a3a")
_INK, _SOFT, _RULE = "#1d1f21", "#63676b", "#d9d9d4"
_VARIABLES = {colour: f"var(--c{i})" for i, colour in enumerate(SERIES)}
_VARIABLES |= {_INK: "var(--ink)", _SOFT: "var(--soft)", _RULE: "var(--rule)"}

_WIDTH, _HEIGHT, _ROW_HEIGHT = 3.6, 2.5, 0.26  # inches
_MOST_LETTERS = 18  # of a label
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_STYLE = {
    "svg.fonttype": "none",
    "svg.hashsalt": "drc",
    "font.size": 8.5,
    "axes.titlesize": 9.5,
    "axes.titleweight": "semibold",
    "axes.titlecolor": _INK,
    "axes.edgecolor": _RULE,
    "axes.labelcolor": _SOFT,
    "xtick.labelcolor": _SOFT,
    "ytick.labelcolor": _SOFT,
    "xtick.color": _RULE,
    "ytick.color": _RULE,
    "axes.grid": True,
    "grid.color": _RULE,
    "grid.linewidth": 0.6,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "figure.facecolor": "none",
    "axes.facecolor": "none",
}
_serial = itertools.count()


@dataclass
class Point:
    x: float
    y: float
    title: str = ""
    low: float = math.nan  # of its bar
    high: float = math.nan


@dataclass
class Series:
    label: str
    colour: int
    marker: str = "o"
    points: list[Point] = field(default_factory=list)


@dataclass
class Box:
    label: str
    colour: int
    summary: dict[str, float]  # median, q1, q3, p5, p95, mean; NaN: there is nothing to draw


def tick_text(value: float) -> str:
    if abs(value) < 1e-12:
        return "0"
    decade = math.floor(math.log10(abs(value)) + 1e-9)
    if -3 <= decade < 5:
        return f"{value:.4g}"
    power = "10" + str(decade).translate(_RAISED)
    factor = f"{value / 10.0**decade:.3g}"
    return power if factor == "1" else f"{factor}·{power}"


def _set_logarithmic(axis: "matplotlib.axis.Axis", low: float, high: float) -> None:
    decades = math.log10(high / low)
    axis.axes.set(**{f"{axis.axis_name}scale": "log"})
    axis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1, 2, 5) if decades < 2 else (1,)))
    axis.set_minor_locator(matplotlib.ticker.NullLocator())
    axis.set_major_formatter(matplotlib.ticker.FuncFormatter(lambda value, _: tick_text(value)))


def _inline_svg(figure: Figure, title: str, tips: dict[str, str]) -> Markup:
    """tips: texts that show where the pointer rests, by the names (gid) of what they belong to."""
    with io.StringIO() as file:
        figure.savefig(file, format="svg", metadata={"Date": None})
        svg = file.getvalue()
    svg = svg[svg.index("<svg") :]
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    # Nothing reaches out of the axes, whose limits are around all values.
    svg = re.sub(r"<clipPath.*?</clipPath>", "", svg, flags=re.DOTALL)
    svg = re.sub(r' clip-path="[^"]*"', "", svg)
    view_box = re.search(r'viewBox="[^"]*"', svg)[0]
    label = html.escape(title)
    svg = re.sub(r"<svg[^>]*>", f'<svg class="plot" {view_box} role="img" aria-label="{label}">', svg, count=1)
    for name, tip in tips.items():
        svg = svg.replace(f'<g id="{name}">', f'<g class="tip"><title>{html.escape(tip)}</title>')
    # Names must be the page's own: several plots have a "figure_1".
    serial = next(_serial)
    svg = re.sub(r'\bid="', f'id="plot{serial}-', svg)
    svg = re.sub(r'(?:xlink:)?href="#', f'href="#plot{serial}-', svg)
    return Markup(re.sub("|".join(_VARIABLES), lambda colour: _VARIABLES[colour[0]], svg))


def _shown(series: list[Series], log_x: bool, log_y: bool) -> list[Series]:
    """Leaves out points that the axes cannot show."""

    def fits(value: float, logarithmic: bool) -> bool:
        return math.isfinite(value) and (value > 0 or not logarithmic)

    kept = [
        Series(one.label, one.colour, one.marker, [p for p in one.points if fits(p.x, log_x) and fits(p.y, log_y)])
        for one in series
    ]
    return [one for one in kept if one.points]


def line_plot(
    title: str, x_label: str, series: list[Series], log_y: bool, x_ticks: list[float] | None = None
) -> Markup:
    """A line for each series, with a mark and, where they are known, a bar at each point. x is logarithmic.

    x_ticks: the values below the axis, in place of round ones.
    """
    series = _shown(series, True, log_y)
    with matplotlib.rc_context(_STYLE):
        figure = Figure(figsize=(_WIDTH, _HEIGHT), layout="constrained")
        axes = figure.add_subplot()
        tips: dict[str, str] = {}
        for one in series:
            colour = SERIES[one.colour]
            axes.plot([p.x for p in one.points], [p.y for p in one.points], color=colour, linewidth=1.4)
            for p in one.points:
                _add_point(axes, p, one, tips)
        if series:
            xs = [p.x for one in series for p in one.points]
            ys = [y for one in series for p in one.points for y in (p.y, p.low, p.high) if math.isfinite(y)]
            _set_logarithmic(axes.xaxis, min(xs), max(xs))
            if log_y:
                _set_logarithmic(axes.yaxis, min(y for y in ys if y > 0), max(ys))
            else:
                axes.set_ylim(0, 1.05 * max(ys))
            if x_ticks:
                axes.xaxis.set_major_locator(matplotlib.ticker.FixedLocator(x_ticks))
        axes.set_title(title, loc="left")
        axes.set_xlabel(x_label, loc="right")
        return _inline_svg(figure, title, tips)


def _add_point(axes: Axes, point: Point, series: Series, tips: dict[str, str]) -> None:
    colour, name = SERIES[series.colour], f"tip-{len(tips)}"
    if math.isfinite(point.low) and math.isfinite(point.high):
        axes.plot([point.x] * 2, [point.low, point.high], color=colour, linewidth=1, gid=f"bar-{len(tips)}")
    axes.plot([point.x], [point.y], series.marker, color=colour, markersize=4.5, gid=name)
    tips[name] = point.title


def box_limits(boxes: list[Box], logarithmic: bool) -> tuple[float, float, bool]:
    """The range around all boxes, and whether the axis is logarithmic, which takes values above zero."""
    known = [box.summary for box in boxes if not math.isnan(box.summary["median"])]
    if not known:
        return 0, 1, False
    low = min(min(s["p5"], s["mean"]) for s in known)
    high = max(max(s["p95"], s["mean"]) for s in known)
    if logarithmic and low > 0:
        return low / 1.1, high * 1.1, True
    # The axis begins at zero, also if a sliver of the data lies below it that is not worth a tick.
    low = min(0, high) if low > -0.03 * (high - low) else low * 1.05
    return low, high * 1.05 if high > low else low + 1, False


def box_plot(title: str, boxes: list[Box], limits: tuple[float, float, bool]) -> Markup:
    """Draws boxes between quartiles, a line at the median, a circle at the mean, whiskers to outer percentiles."""
    low, high, logarithmic = limits
    with matplotlib.rc_context(_STYLE):
        figure = Figure(figsize=(_WIDTH, 0.6 + _ROW_HEIGHT * max(1, len(boxes))), layout="constrained")
        axes = figure.add_subplot()
        if logarithmic:
            _set_logarithmic(axes.xaxis, low, high)
        axes.set_xlim(low, high)
        tips: dict[str, str] = {}
        for place, box in enumerate(boxes):
            if not math.isnan(box.summary["median"]):
                _add_box(axes, box, place, tips)
        labels = [b.label if len(b.label) <= _MOST_LETTERS else b.label[: _MOST_LETTERS - 1] + "…" for b in boxes]
        axes.set_yticks(range(len(boxes)), labels, color=_INK)
        axes.set_ylim(max(0, len(boxes) - 1) + 0.5, -0.5)
        axes.grid(axis="y", visible=False)
        axes.set_title(title, loc="left")
        return _inline_svg(figure, title, tips)


def _add_box(axes: Axes, box: Box, place: int, tips: dict[str, str]) -> None:
    s, colour, name = box.summary, SERIES[box.colour], f"tip-{place}"
    values = {
        "med": s["median"],
        "q1": s["q1"],
        "q3": s["q3"],
        "whislo": s["p5"],
        "whishi": s["p95"],
        "mean": s["mean"],
    }
    line = {"color": colour, "linewidth": 1.1}
    drawn = axes.bxp(
        [values | {"fliers": []}], positions=[place], widths=0.5, vert=False, patch_artist=True, showmeans=True,
        showfliers=False, manage_ticks=False, whiskerprops=line, capprops=line, medianprops=line | {"linewidth": 2},
        boxprops={"edgecolor": colour, "facecolor": "none", "linewidth": 1.1},
        meanprops={"marker": "o", "markersize": 4, "markerfacecolor": colour, "markeredgecolor": colour},
    )  # fmt: skip
    drawn["boxes"][0].set_gid(name)
    tips[name] = (
        f"{box.label}: median {s['median']:.4g}, quartiles {s['q1']:.4g} and {s['q3']:.4g}, mean {s['mean']:.4g}"
    )
