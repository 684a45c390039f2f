"""An evaluation of networks, as `drc evaluate --json` says it, made ready to be shown."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path

from .errors import Error
from .files import read_text


@dataclass(frozen=True)
class Measure:
    """One column of the tables: a measure under one view of the energy."""

    group: str  # as in the JSON
    key: str
    title: str
    group_title: str
    higher_is_better: bool = False
    is_logarithmic: bool = False  # errors that span decades

    def of(self, told: dict) -> dict:
        return told[self.group][self.key]

    def is_best(self, value: float, values: list[float]) -> bool:
        """Several may be the best; NaN is not."""
        return all(value >= other if self.higher_is_better else value <= other for other in values)


MEASURES = tuple(
    Measure(group, *rest, higher_is_better=higher, is_logarithmic=logarithmic)
    for group, title in (("as_rendered", "as rendered"), ("equal_energy", "equal energy"))
    for *rest, higher, logarithmic in (
        ("l1", "L1", title, False, False),
        ("ssim", "SSIM", title, True, False),
        ("irradiance_relmse", "irradiance", title, False, True),
    )
)


def number(value: float | None) -> float:
    return math.nan if value is None else value


def summary_of(told: dict) -> dict[str, float]:
    return {name: number(value) for name, value in told.items()}


def description(group: dict) -> str:
    """equal-area maps of 32x32 texels, 494 examples of 25 files, one input each."""
    files, size = len(group["files"]), group["map_size"]
    inputs = max([1, *(file["inputs"] for file in group["files"])])
    return (
        f"{group['projection']} maps of {size}x{size} texels, {group['examples']} examples of {files} "
        f"{'file' if files == 1 else 'files'}, {'one input' if inputs == 1 else f'up to {inputs} inputs'} each"
    )


def read_evaluation(path: Path) -> dict:
    """Raises Error, naming the file, if it is not what `drc evaluate --json` prints."""
    try:
        told = json.loads(read_text(path))
    except json.JSONDecodeError as error:
        raise Error(f"{path}: not JSON: {error}") from None
    keys = ("version", "examples", "files", "skipped_files", "networks", "projections", "across_projections")
    if not isinstance(told, dict) or any(key not in told for key in keys):
        raise Error(f"{path}: not what drc evaluate --json prints: it has {', '.join(keys)}")
    return told
