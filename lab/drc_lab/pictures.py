"""The pictures of a comparison, each once on the page: a strip of figures for each scene, and a gallery of the rest."""

from __future__ import annotations

import base64
import io
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import PIL.Image
from markupsafe import Markup

from . import measures as m
from .budget import UNITS, Budget
from .errors import Error
from .number_text import one_decimal, two_decimals
from .program import Program
from .result import Report, Run, Scene, runs_of

_CAPTION = (m.ERROR, m.BLOCK_ERROR, m.SSIM, m.FLIP, m.SECONDS)
_GAIN = 4  # of differences, as in those that drc compare writes


@dataclass
class Picture:
    uri: str
    width: int
    height: int
    alt: str


@dataclass
class PageFigure:
    scene: int  # indices in the report's lists, by which the viewer's script finds the picture
    method: str  # an index, or "reference"
    budget: int | None
    name: str
    spent: str
    picture: Picture
    difference: Picture | None
    facts: list[tuple[str, Markup]]


@dataclass
class ScenePictures:
    name: str
    budget: str = ""  # of the strip
    strip: list[PageFigure] = field(default_factory=list)  # the reference and all methods at one budget
    gallery: list[PageFigure] = field(default_factory=list)  # all pictures that the strip does not show


def png_uri(png: bytes) -> str:
    return "data:image/png;base64," + base64.b64encode(png).decode()


def _levels(png: bytes) -> np.ndarray:
    """Displayed colours, from 0 to 255."""
    return np.asarray(PIL.Image.open(io.BytesIO(png)).convert("RGB"), dtype=np.int16)


def difference_png(reference: bytes, picture: bytes) -> bytes:
    """The absolute difference between displayed colours, four times as large, from PNGs to a PNG."""
    apart = np.clip(_GAIN * np.abs(_levels(picture) - _levels(reference)), 0, 255).astype(np.uint8)
    with io.BytesIO() as file:
        PIL.Image.fromarray(apart).save(file, "PNG", optimize=True)
        return file.getvalue()


def _picture(png: bytes, alt: str) -> Picture:
    width, height = PIL.Image.open(io.BytesIO(png)).size
    return Picture(png_uri(png), width, height, alt)


class _SceneMaker:
    def __init__(self, report: Report, folder: Path, program: Program, index: int) -> None:
        self._report, self._folder, self._program = report, folder, program
        self._index, self._scene = index, report.scenes[index]

    def make(self) -> ScenePictures | None:
        shown = self._shown_runs()
        if not shown:  # such a scene needs no reference
            return None
        self._reference = self._png(self._scene.reference)
        pictures, common = ScenePictures(self._scene.name), self._common_budget(shown)
        reference = self._reference_figure()
        (pictures.gallery if common is None else pictures.strip).append(reference)
        for (method, budget), run in sorted(shown.items()):
            is_common = budget == common
            figure = self._figure(method, budget, run, with_difference=is_common)
            (pictures.strip if is_common else pictures.gallery).append(figure)
        if common is not None:
            pictures.budget = self._report.budgets[common].name
        return pictures

    def _shown_runs(self) -> dict[tuple[int, int], Run]:
        """The first repeat with a picture, by the indices of method and budget."""
        shown = {}
        for i, method in enumerate(self._report.methods):
            for j, budget in enumerate(self._report.budgets):
                runs = [run for run in runs_of(self._report, self._scene.name, method, budget) if run.picture]
                if runs:
                    shown[i, j] = min(runs, key=lambda run: run.repeat)
        return shown

    def _common_budget(self, shown: dict[tuple[int, int], Run]) -> int | None:
        """The budget at which most methods have a picture, and of these the largest; seconds come first.

        None if no budget has pictures of two methods.
        """
        counts = {j: sum(1 for _, other in shown if other == j) for _, j in shown}

        def rank(j: int) -> tuple:
            budget: Budget = self._report.budgets[j]
            return counts[j], -UNITS.index(budget.unit), budget.amount

        return max((j for j in counts if counts[j] > 1), key=rank, default=None)

    def _png(self, file: str) -> bytes:
        try:
            return self._program.png(str(self._folder / file))
        except Error as error:
            raise Error(f"cannot show {self._folder / file}: {error}") from None

    def _reference_figure(self) -> PageFigure:
        scene: Scene = self._scene
        picture = _picture(self._reference, f"the reference of {scene.name}")
        facts = [("PNG KB", one_decimal(scene.reference_png_kb)), ("entropy", two_decimals(scene.reference_entropy))]
        return PageFigure(self._index, "reference", None, "reference", "", picture, None, facts)

    def _figure(self, method: int, budget: int, run: Run, with_difference: bool) -> PageFigure:
        png, spent = self._png(run.picture), run.budget.name
        picture = _picture(png, f"{run.scene} by {run.method}, {spent}")
        if (picture.width, picture.height) != PIL.Image.open(io.BytesIO(self._reference)).size:
            raise Error(f"cannot show {self._folder / run.picture}: its size is not that of the reference")
        difference = None
        if with_difference:
            difference = _picture(difference_png(self._reference, png), "its difference to the reference")
        facts = [(measure.title, measure.text(getattr(run, measure.name))) for measure in _CAPTION]
        shown_spent = "" if with_difference else spent
        return PageFigure(self._index, str(method), budget, run.method, shown_spent, picture, difference, facts)


def page_pictures(report: Report, folder: Path, program: Program) -> list[ScenePictures]:
    """Raises Error, naming the file, if a picture cannot be read or has another size than the reference."""
    made = [_SceneMaker(report, folder, program, index).make() for index in range(len(report.scenes))]
    return [scene for scene in made if scene]
