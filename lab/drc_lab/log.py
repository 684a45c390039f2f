"""Messages to the user on standard error, in the words of drc itself."""

import sys

QUIET, NORMAL, VERBOSE = range(3)
_MOST_CHARACTERS = 4000  # as messages quote files, whose names may be of any length
_level = NORMAL


def set_level(level: int) -> None:
    global _level
    _level = level


def _printable(text: str) -> str:
    """Replaces control characters, so that a file cannot send escape sequences to the terminal."""
    if len(text) > _MOST_CHARACTERS:
        text = text[:_MOST_CHARACTERS] + "..."
    return "".join(c if c in "\n\t" or (ord(c) >= 32 and ord(c) != 127) else "?" for c in text)


def _say(text: str) -> None:
    print(f"drc: {_printable(text)}", file=sys.stderr, flush=True)


def error(message: str) -> None:
    _say(f"error: {message}")


def warning(message: str) -> None:
    _say(f"warning: {message}")


def info(message: str) -> None:
    if _level >= NORMAL:
        _say(message)


def debug(message: str) -> None:
    if _level >= VERBOSE:
        _say(message)
