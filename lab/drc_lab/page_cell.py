"""A cell of a table on a page."""

from dataclasses import dataclass

from markupsafe import Markup


@dataclass
class Cell:
    html: Markup
    is_best: bool = False
