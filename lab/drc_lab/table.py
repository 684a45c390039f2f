"""The results as Markdown: a table for each budget."""

from __future__ import annotations

import math

from .budget import Budget
from .result import MOST_DISPLAYED_NOISE, Report, Run, Scene, all_runs_of, is_noisy, opponent_error, runs_of, spread_of

_HEADER = [
    "scene", "method", "error", "trimmed", "8x8 blocks", "/ path+oidn", "SSIM", "FLIP", "mean ratio RGB", "spp",
    "load s", "render s", "denoise s", "write s", "whole s", "MB",
]  # fmt: skip


def _median(runs: list[Run], name: str) -> float:
    return spread_of([getattr(run, name) for run in runs]).median


def _number(x: float, digits: int) -> str:
    return "-" if math.isnan(x) else f"{x:.{digits}f}"


def _error(runs: list[Run], name: str) -> str:
    """0.00123 ± 0.00004."""
    x, standard_error = _median(runs, name), _median(runs, f"{name}_se")
    if math.isnan(x):
        return "-"
    return f"{x:.5f}" + ("" if math.isnan(standard_error) else f" ± {standard_error:.5f}")


def _in_cell(text: str) -> str:
    return text.replace("|", "\\|")  # a column ends at each bar


def _aligned(rows: list[list[str]]) -> str:
    widths = [max(len(row[i]) for row in rows if i < len(row)) for i in range(len(rows[0]))]
    lines = []
    for row in rows:
        cells = row + [""] * (len(widths) - len(row))
        lines.append("".join(f"| {cell:<{width}} " for cell, width in zip(cells, widths)) + "|\n")
    lines.insert(1, "".join("|" + "-" * (width + 2) for width in widths) + "|\n")
    return "".join(lines)


class _BudgetTable:
    def __init__(self, report: Report, budget: Budget) -> None:
        self._report, self._budget = report, budget
        self._rows, self._notes, self._modes, self._any_noisy = [_HEADER], [], [], False
        for scene in report.scenes:
            self._add_scene(scene)
        if self._any_noisy:
            share = f"{100 * MOST_DISPLAYED_NOISE:.0f} %"
            self._notes.append(f"- ~: more than {share} of the difference is the references' own noise\n")

    def text(self) -> str:
        table = f"## {self._budget.name}\n\n{_aligned(self._rows)}\n" if len(self._rows) > 1 else ""
        notes = "".join(self._notes + self._modes)
        return table + (notes + "\n" if notes else "")

    def _add_scene(self, scene: Scene) -> None:
        before = len(self._rows)
        for method in self._report.methods:
            runs = runs_of(self._report, scene.name, method, self._budget)
            tried = all_runs_of(self._report, scene.name, method, self._budget)
            if runs:
                self._rows.append(self._row(scene, method, runs))
                if runs[0].oidn_mode and ":" not in method:
                    mode = runs[0].oidn_mode
                    self._modes.append(f"- {scene.name}, {method}: Open Image Denoise in the mode {mode}\n")
            elif tried:
                self._rows.append([_in_cell(scene.name), _in_cell(method), "-"])
                self._notes.append(f"- {scene.name}, {method}: {tried[0].failure}\n")
        if len(self._rows) > before and not scene.pair:
            self._notes.append(f"- {scene.name}: one reference only; its noise is in the errors (relMSE)\n")

    def _row(self, scene: Scene, method: str, runs: list[Run]) -> list[str]:
        opponent = opponent_error(self._report, scene.name, self._budget)
        errors = [_error(runs, name) for name in ("error", "trimmed_error", "block_error")]
        ratios = [spread_of([run.mean_ratio[c] for run in runs]).median for c in range(3)]
        seconds = [
            _number(_median(runs, f"{part}seconds"), 1) for part in ("load_", "render_", "denoise_", "write_", "")
        ]
        return [
            _in_cell(scene.name),
            _in_cell(method),
            *errors,
            _number(_median(runs, "error") / opponent, 2),
            self._displayed(_median(runs, "ssim"), 1, scene.ssim_noise),
            self._displayed(_median(runs, "flip"), 0, scene.flip_noise),
            " ".join(f"{ratio:.3f}" for ratio in ratios),
            _number(_median(runs, "spp"), 0),
            *seconds,
            _number(_median(runs, "peak_mb"), 0),
        ]

    def _displayed(self, x: float, perfect: float, noise: float) -> str:
        noisy = is_noisy(x, perfect, noise)
        self._any_noisy |= noisy
        return ("~" if noisy else "") + _number(x, 4)


def markdown(report: Report) -> str:
    return "".join(_BudgetTable(report, budget).text() for budget in report.budgets)
