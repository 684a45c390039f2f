"""A command line with the rules and the messages that drc's other commands have."""

from __future__ import annotations

import argparse
import difflib
import math
import os
import re
from collections.abc import Callable

from .errors import UsageError

# Options of other renderers, with their names here.
_ELSEWHERE = {"--samples": "--spp", "--width": "--resolution", "--height": "--resolution", "--size": "--resolution",
              "--out": "--output", "-j": "--nthreads", "-t": "--nthreads", "-s": "--spp"}  # fmt: skip
_YEAR = 366.0 * 24 * 3600
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", re.ASCII)


def _refuse(message: str) -> argparse.ArgumentTypeError:
    return argparse.ArgumentTypeError(message)


def _number(text: str) -> float:
    return float(text) if _NUMBER.fullmatch(text) else math.nan


def whole_number_in(
    low: int, high: int, message: str = "{} is not a whole number from {} to {}"
) -> Callable[[str], int]:
    def check(text: str) -> int:
        if re.fullmatch(r"[-+]?\d{1,18}", text, re.ASCII) and low <= int(text) <= high:
            return int(text)
        raise _refuse(message.format(text, low, high))

    return check


def number_above(bound: float) -> Callable[[str], float]:
    def check(text: str) -> float:
        value = _number(text)
        if math.isfinite(value) and value > bound:
            return value
        raise _refuse(f"{text} is not a number above {bound:g}")

    return check


def seconds_of_work(text: str) -> float:
    value = _number(text)
    if not (math.isfinite(value) and value > 0):
        raise _refuse(f"{text} is not a number of seconds above 0")
    if value > _YEAR:
        raise _refuse(f"{text} is too long: at most a year, in seconds")
    return value


def one_of(*names: str) -> Callable[[str], str]:
    def check(text: str) -> str:
        if text in names:
            return text
        raise _refuse(f"{text} not in {{{','.join(names)}}}")

    return check


def comma_list(text: str) -> list[str]:
    return text.split(",")


def threads_number() -> Callable[[str], int]:
    # More threads than twice the cores only wait for each other; but files of settings travel between machines.
    return whole_number_in(0, max(256, 2 * (os.cpu_count() or 1)))


class ExtendLists(argparse.Action):
    """Each value is a list, or one item; all values of all repetitions of the option make one list."""

    def __call__(self, parser, namespace, values, option_string=None):  # noqa: D102
        items = list(getattr(namespace, self.dest) or [])
        for value in values:
            items += value if isinstance(value, list) else [value]
        setattr(namespace, self.dest, items)


class Parser(argparse.ArgumentParser):
    """Raises UsageError, with one line, where argparse would print its usage and exit."""

    def __init__(self, name: str, **options) -> None:
        super().__init__(
            prog=name,
            allow_abbrev=False,
            formatter_class=argparse.RawDescriptionHelpFormatter,
            add_help=False,
            **options,
        )
        self.add_argument("-h", "--help", action="help", help="Print this help message and exit")

    def error(self, message: str) -> None:
        raise UsageError(f"{self.prog}: {message}")

    def parse(self, words: list[str]) -> argparse.Namespace:
        words = self._checked(words)
        try:
            found, unknown = self.parse_known_intermixed_args(words)
        except UsageError as error:
            raise self._in_our_words(str(error)) from None
        if unknown:
            raise self._unknown(unknown[0])
        return found

    def _names(self) -> list[str]:
        return [name for action in self._actions for name in action.option_strings]

    def _checked(self, words: list[str]) -> list[str]:
        """Finds unknown options and forgotten values, which argparse would take for something else."""
        takes_value = {name for a in self._actions for name in a.option_strings if a.nargs != 0}
        long_name = {name: a.option_strings[-1] for a in self._actions for name in a.option_strings}
        before = ""
        for word in words:
            name = word.partition("=")[0]
            is_option = name in self._names()
            if before in takes_value:
                if word == "":
                    raise UsageError(f"{self.prog}: {long_name[before]}: the value is empty")
                if is_option:
                    raise UsageError(f"{self.prog}: {long_name[before]}: a value is missing before {word}")
            elif word.startswith("-") and len(word) > 1 and not is_option and not self._is_short_with_value(word):
                raise self._unknown(word)
            before = word if is_option and "=" not in word else ""
        return words

    def _is_short_with_value(self, word: str) -> bool:
        return not word.startswith("--") and word[:2] in self._names()

    def _unknown(self, word: str) -> UsageError:
        if not word.startswith("-"):
            return UsageError(f"'{word}' is one file too many for {self.prog}")
        option, names = word.partition("=")[0], self._names()
        nearest = (
            [_ELSEWHERE[option]] if _ELSEWHERE.get(option) in names else difflib.get_close_matches(option, names, 1)
        )
        hint = f"did you mean '{nearest[0]}'?" if nearest else f"{self.prog} --help lists them"
        return UsageError(f"{self.prog} has no option '{option}'; {hint}")

    def _in_our_words(self, message: str) -> UsageError:
        text = message.removeprefix(f"{self.prog}: ")
        if required := re.fullmatch(r"the following arguments are required: (\S+).*", text):
            return UsageError(f"{self.prog}: {required[1]} is required; {self.prog} --help says more")
        if argument := re.fullmatch(r"argument (?:\S+/)?(\S+?): (.*)", text, re.DOTALL):
            name, what = argument[1], argument[2]
            if what.startswith("expected"):
                metavar = next((a.metavar for a in self._actions if name in a.option_strings), None)
                return UsageError(f"{self.prog}: {name} needs a value: {metavar or 'TEXT'}")
            return UsageError(f"{self.prog}: {name}: {what}")
        return UsageError(message)
