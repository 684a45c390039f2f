"""Other renderers, as the bench runs them: the contents of an adapter file (integrations/README.md)."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from .budget import SECONDS, SPP
from .errors import Error
from .files import read_text

_KEYS = ("name", "about", "check", "install", "denoisers", "command")
_UNITS = (SECONDS, SPP)
_PLACEHOLDERS = (
    "folder", "scene", "output", "width", "height", "seed", "threads", "seconds", "spp", "denoiser", "timing", "drc"
)  # fmt: skip


@dataclass
class Adapter:
    name: str
    about: str = ""
    install: str = ""
    folder: str = ""  # of its file, absolute
    check: list[str] = field(default_factory=list)  # empty: nothing to check
    denoisers: list[str] = field(default_factory=list)
    commands: dict[str, list[str]] = field(default_factory=dict)  # by the budget's unit

    def command(self, unit: str, values: dict[str, str]) -> list[str]:
        """The command line of a run, for a unit that `commands` has. values: of all placeholders but the folder."""
        known = {"folder": self.folder, **values}
        known["denoiser"] = known.get("denoiser") or "off"
        return [_expand(argument, lambda name: known.get(name, "")) for argument in self.commands[unit]]


def _expand(text: str, value: Callable[[str], str]) -> str:
    """Replaces {name} by what `value` gives for the name; "{{" and "}}" are braces."""
    expanded, i = "", 0
    while i < len(text):
        c = text[i]
        if c in "{}" and text[i + 1 : i + 2] == c:
            expanded += c
            i += 1
        elif c == "{":
            end = text.find("}", i)
            if end < 0:
                raise Error(f"'{text}': a brace is not closed")
            expanded += value(text[i + 1 : end])
            i = end
        elif c == "}":
            raise Error(f"'{text}': a brace is closed that was not opened; write }}}} for one")
        else:
            expanded += c
        i += 1
    return expanded


def _check_placeholders(text: str, unit: str) -> None:
    def check(name: str) -> str:
        if name not in _PLACEHOLDERS:
            raise Error(f"'{text}': no placeholder {{{name}}}; there are {', '.join(_PLACEHOLDERS)}")
        if name in _UNITS and name != unit:
            raise Error(f"'{text}': {{{name}}} has no value where the budget is another")
        return ""

    _expand(text, check)


def _strings(value: object, key: str) -> list[str]:
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        raise Error(f'"{key}" must be a list of strings')
    return value


def _text(adapter: dict, key: str) -> str:
    if key not in adapter:
        raise Error(f'"{key}" is missing')
    if not isinstance(adapter[key], str) or not adapter[key]:
        raise Error(f'"{key}" must be a text that is not empty')
    return adapter[key]


def _commands(value: object) -> dict[str, list[str]]:
    if not isinstance(value, dict) or not value:
        raise Error('"command" must be an object with "seconds", "spp" or both')
    for unit, command in value.items():
        if unit not in _UNITS:
            raise Error(f'"command": unknown unit "{unit}"; there are seconds and spp')
        if not _strings(command, unit):
            raise Error(f'"{unit}" has no program')
        for argument in command:
            _check_placeholders(argument, unit)
    return value


def _check_command(check: list[str], folder: str) -> list[str]:
    def value(name: str) -> str:
        if name != "folder":
            raise Error(f'"check": only {{folder}} has a value there, not {{{name}}}')
        return folder

    # A folder's path may have braces of its own: it is put in as a value, never expanded.
    return [_expand(argument, value) for argument in check]


def _from_json(adapter: object, folder: str) -> Adapter:
    if not isinstance(adapter, dict):
        raise Error("an adapter is a JSON object")
    for key in adapter:
        if key not in _KEYS:
            raise Error(f'unknown key "{key}"; there are {", ".join(_KEYS)}')
    name = _text(adapter, "name")
    if any(c in "+:=,/ " for c in name):
        raise Error(f"\"name\": '{name}' may have none of +:=,/ and no blanks")
    return Adapter(
        name=name,
        about=_text(adapter, "about"),
        install=_text(adapter, "install"),
        folder=folder,
        check=_check_command(_strings(adapter.get("check", []), "check"), folder),
        denoisers=_strings(adapter.get("denoisers", []), "denoisers"),
        commands=_commands(adapter.get("command")),
    )


def read_adapter(path: str) -> Adapter:
    """path: an adapter file, or a folder that contains adapter.json. Errors name the file and the key."""
    file = Path(path, "adapter.json") if Path(path).is_dir() else Path(path)
    text = read_text(file)
    try:
        return _from_json(json.loads(text), os.path.dirname(os.path.abspath(file)))
    except json.JSONDecodeError as error:
        raise Error(f"{file}: not JSON: {error}") from None
    except Error as error:
        raise Error(f"{file}: {error}") from None
