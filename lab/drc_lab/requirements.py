"""The libraries that the laboratory stands on. Nothing but the commands that need them imports them."""

import importlib.util

from .errors import Error

_MODULES = ("numpy", "matplotlib", "jinja2")
_HOW = "apt install python3-numpy python3-matplotlib python3-jinja2, or pip install -r lab/requirements.txt"


def missing_modules() -> list[str]:
    return [name for name in _MODULES if importlib.util.find_spec(name) is None]


def require_modules() -> None:
    if missing := missing_modules():
        raise Error(f"Python has no module {' and none called '.join(missing)}: {_HOW}")
