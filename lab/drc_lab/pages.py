"""The templates of the pages (templates/), which Jinja2 fills in; all that they show is escaped."""

from __future__ import annotations

from pathlib import Path

import jinja2
from markupsafe import Markup

_FOLDER = Path(__file__).with_name("templates")


def _inline(name: str) -> Markup:
    """A style sheet or a script as it is, to be a part of the page."""
    return Markup((_FOLDER / name).read_text(encoding="utf-8"))


def render(name: str, **values: object) -> str:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(str(_FOLDER)),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.globals["inline"] = _inline
    return environment.get_template(name).render(**values)
