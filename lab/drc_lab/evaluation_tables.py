"""The tables of an evaluation's page: blocks of rows with a cell for each measure."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

from markupsafe import Markup

from .evaluation import MEASURES, Measure, number
from .number_text import DASH, four_decimals, p_value
from .page_cell import Cell


@dataclass
class Row:
    name: str
    cells: list[Cell]


@dataclass
class Block:
    title: str
    rows: list[Row] = field(default_factory=list)


def _row(name: str, cell: Callable[[Measure], Cell]) -> Row:
    return Row(name, [cell(measure) for measure in MEASURES])


def _part(told: dict, measure: Measure, part: str) -> float:
    return number(measure.of(told)[part])


def score_table(group: dict) -> list[Block]:
    methods: dict[str, dict] = group["methods"]

    def cell(told: dict, part: str) -> Callable[[Measure], Cell]:
        def of(measure: Measure) -> Cell:
            value = _part(told, measure, part)
            values = [_part(other, measure, part) for other in methods.values()]
            return Cell(four_decimals(value), measure.is_best(value, values))

        return of

    def quartiles(told: dict) -> Callable[[Measure], Cell]:
        def of(measure: Measure) -> Cell:
            low, high = (four_decimals(_part(told, measure, part)) for part in ("q1", "q3"))
            return Cell(low + Markup(" &#8211; ") + high)

        return of

    return [
        Block("Mean", [_row(name, cell(told, "mean")) for name, told in methods.items()]),
        Block("Median", [_row(name, cell(told, "median")) for name, told in methods.items()]),
        Block("Quartiles", [_row(name, quartiles(told)) for name, told in methods.items()]),
    ]


def _better_in(told: dict) -> Cell:
    share = number(told["first_better"])
    return Cell(DASH if math.isnan(share) else Markup(f"{100 * share:.1f} %"))


def _p(told: dict) -> Cell:
    return Cell(p_value(number(told["p"])))


def _test_rows(pair: dict) -> list[Row]:
    return [
        _row("better in", lambda measure: _better_in(measure.of(pair))),
        _row("Wilcoxon p", lambda measure: _p(measure.of(pair)["wilcoxon"])),
        _row("Kruskal–Wallis p", lambda measure: _p(measure.of(pair)["kruskal_wallis"])),
    ]


def _versus(pair: dict) -> str:
    return pair["first"] if pair["first"] == pair["second"] else f"{pair['first']} against {pair['second']}"


def test_table(group: dict) -> list[Block]:
    everything = group["all_methods"]["kruskal_wallis"]
    blocks = [Block("All methods together", [_row("Kruskal–Wallis p", lambda measure: _p(measure.of(everything)))])]
    return blocks + [Block(_versus(pair), _test_rows(pair)) for pair in group["comparisons"]]


def across_table(across: dict) -> list[Block]:
    def means(pair: dict, own: str, other: str) -> Callable[[Measure], Cell]:
        def of(measure: Measure) -> Cell:
            value = _part(pair, measure, own)
            return Cell(four_decimals(value), measure.is_best(value, [_part(pair, measure, other)]))

        return of

    return [
        Block(
            _versus(pair),
            [
                _row(f"mean, {across['first']}", means(pair, "first_mean", "second_mean")),
                _row(f"mean, {across['second']}", means(pair, "second_mean", "first_mean")),
                *_test_rows(pair),
            ],
        )
        for pair in across["comparisons"]
    ]
