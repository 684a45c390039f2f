"""The page of a comparison: one HTML file that fetches nothing."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from . import equal_time, paper_table
from .budget import UNITS
from .curves import error_curves, memory_curves
from .equal_time import equal_time_tables
from .measures import budgets_of
from .number_text import significant
from .pages import render
from .paper_table import paper_tables
from .pictures import page_pictures
from .program import Program
from .result import Report


def _repeats(report: Report) -> str:
    """3, or 1 to 3 where runs differ."""
    counts = Counter((run.scene, run.method, run.budget) for run in report.runs).values()
    least, most = min(counts, default=0), max(counts, default=0)
    return f"{most}" if least == most else f"{least} to {most}"


def _budgets(report: Report) -> str:
    """10, 30 s; 1, 2, 4 tasks."""
    lists = []
    for unit in UNITS:
        if budgets := budgets_of(report, unit):
            lists.append(", ".join([f"{budget.amount:g}" for budget in budgets[:-1]] + [budgets[-1].name]))
    return "; ".join(lists)


def bench_page(report: Report, folder: Path, program: str) -> str:
    """folder: what the report's pictures are relative to. program: the drc that reads them."""
    pictures = page_pictures(report, folder, Program(program))
    equal_times, papers = equal_time_tables(report), paper_tables(report)
    curves, memory = error_curves(report), memory_curves(report)
    has_strips = any(scene.strip for scene in pictures)
    sections = [
        ("equal-time", "Equal time", equal_times),
        ("pictures", "Pictures", pictures),
        ("tasks-and-samples", "Tasks and samples", papers),
        ("curves", "Error against time", curves),
        ("memory", "Memory against tasks", memory),
        ("figures", "Figures", has_strips),
        ("made", "How it was made", True),
    ]
    return render(
        "bench.html",
        report=report,
        failed=sum(1 for run in report.runs if run.failure),
        sections=[(name, title) for name, title, content in sections if content],
        equal_times=equal_times,
        equal_time_columns=equal_time.COLUMNS,
        column_count=equal_time.COLUMN_COUNT,
        pictures=pictures,
        papers=papers,
        paper_columns=paper_table.COLUMNS,
        curves=curves,
        memory=memory,
        budgets=_budgets(report),
        repeats=_repeats(report),
        significant=significant,
    )
