"""Budgets of a method: wall-clock seconds of its whole process, or an amount in its own unit."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from .errors import UsageError

SECONDS, SPP, TASKS = UNITS = ("seconds", "spp", "tasks")


@dataclass(frozen=True)
class Budget:
    unit: str
    amount: float

    @property
    def name(self) -> str:
        """30 s, 16 spp, 16 tasks."""
        unit = {SECONDS: "s", SPP: "spp", TASKS: "task" if self.amount == 1 else "tasks"}[self.unit]
        return f"{self.amount:g} {unit}"


def _amount(text: str, option: str) -> float:
    # Python's float() also takes blanks, underscores, "inf" and "nan".
    is_number = re.fullmatch(r"-?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", text, re.ASCII)
    value = float(text) if is_number else math.nan
    if not 0 < value < 1e9:
        raise UsageError(f"{option} {text}: give positive numbers with commas between, or 1..256 for 1,2,4 to 256")
    return value


def parse_budgets(texts: list[str], unit: str, option: str) -> list[Budget]:
    """Each once. "a..b" stands for a, 2a, 4a and so on, up to b."""
    budgets: list[Budget] = []
    for text in texts:
        first_text, dots, last_text = text.partition("..")
        amount = _amount(first_text, option)
        last = _amount(last_text, option) if dots else amount
        while amount <= last:
            if unit != SECONDS and amount != math.floor(amount):
                raise UsageError(f"{option} {text}: must be a whole number")
            if Budget(unit, amount) not in budgets:
                budgets.append(Budget(unit, amount))
            amount *= 2
    return budgets
