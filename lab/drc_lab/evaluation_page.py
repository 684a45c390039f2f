"""The page of `drc evaluate --html`: one file with tables, box plots, tests and pictures of some examples."""

from __future__ import annotations

from pathlib import Path

from markupsafe import Markup

from .errors import Error, reason_of
from .evaluation import MEASURES, description, number, summary_of
from .evaluation_tables import across_table, score_table, test_table
from .number_text import four_decimals
from .pages import render
from .pictures import png_uri
from .plots import SERIES, Box, box_limits, box_plot

# The most important metadata of a network come first; the rest is folded.
_MAIN_KEYS = ("projection", "ablation", "data", "examples_drawn", "validation", "commit")
_METHODS_AT_FULL_SIZE = 4  # more than these get smaller pictures


def _boxes(evaluation: dict, group: dict, measure_index: int) -> list[Box]:
    networks = [network["name"] for network in evaluation["networks"]]
    boxes = []
    for place, (method, told) in enumerate(group["methods"].items()):
        # A network has one colour in all groups.
        colour = 2 + networks.index(method) % (len(SERIES) - 2) if method in networks else place
        boxes.append(Box(method, colour, summary_of(MEASURES[measure_index].of(told))))
    return boxes


def _plots(evaluation: dict) -> list[list[Markup]]:
    """By group. All groups share one axis for each measure, so that they can be compared by eye."""
    groups = evaluation["projections"]
    plots: list[list[Markup]] = [[] for _ in groups]
    for i, measure in enumerate(MEASURES):
        boxes = [_boxes(evaluation, group, i) for group in groups]
        limits = box_limits([box for of_group in boxes for box in of_group], measure.is_logarithmic)
        title = f"{measure.title}, {measure.group_title}{', logarithmic' if limits[2] else ''}"
        for own, of_group in zip(plots, boxes):
            own.append(box_plot(title, of_group, limits))
    return plots


def _metadata_rows(networks: list[dict], keys: list[str]) -> list[tuple[str, list[str]]]:
    """A row for each key that any network has, with a value for each network."""
    return [
        (key.replace("_", " "), [network["metadata"].get(key, "") for network in networks])
        for key in keys
        if any(key in network["metadata"] for network in networks)
    ]


def _network_tables(networks: list[dict]) -> list[list[tuple[str, list[str]]]]:
    first = [("file", [network["path"] for network in networks])]
    first += [("content", [network["content"] for network in networks])]
    others = sorted({key for network in networks for key in network["metadata"]} - set(_MAIN_KEYS))
    return [first + _metadata_rows(networks, list(_MAIN_KEYS)), _metadata_rows(networks, others)]


def _scores(method: dict) -> list[tuple[str, Markup]]:
    keys = (("L1", "l1"), ("SSIM", "ssim"), ("irradiance", "irradiance_relmse"))
    return [(title, four_decimals(number(method[key]))) for title, key in keys]


class _Pictures:
    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def uri(self, name: str) -> str:
        try:
            return png_uri((self._folder / name).read_bytes())
        except OSError as error:
            raise Error(f"cannot read {self._folder / name}: {reason_of(error)}") from None


def evaluation_page(evaluation: dict, folder: Path) -> str:
    """evaluation: what read_evaluation gives. folder: of the pictures that it names."""
    groups = evaluation["projections"]
    return render(
        "evaluation.html",
        evaluation=evaluation,
        measures=MEASURES,
        network_tables=_network_tables(evaluation["networks"]),
        sections=[
            (group, description(group), score_table(group), plots, test_table(group))
            for group, plots in zip(groups, _plots(evaluation))
        ],
        across=[(across, across_table(across)) for across in evaluation["across_projections"]],
        sampled=[group for group in groups if group.get("samples")],
        picture=_Pictures(folder).uri,
        scores=_scores,
        full_size=_METHODS_AT_FULL_SIZE,
    )
