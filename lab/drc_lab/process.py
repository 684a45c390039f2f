"""Runs a program to its end and measures it."""

from __future__ import annotations

import json
import os
import selectors
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from .errors import Error
from .interrupt import Cancel

_LAUNCHER = Path(__file__).with_name("launcher.py")
_KEPT_OUTPUT = 1 << 16
_MERCY_SECONDS = 2  # between asking a program to end and killing it
_STEP_SECONDS = 0.05  # between looks at the limit and at `cancel`


@dataclass
class ProcessUse:
    seconds: float = 0  # wall clock, from before the start to after the end
    cpu_seconds: float = 0  # user and system, of the program and of children that it waited for
    peak_mb: float = 0  # largest resident set of any of them, in 10^6 bytes; not below the launcher's 10
    exit_code: int = 0  # 128 + signal if a signal ended it
    stopped: bool = False  # we ended it, at the limit or on `cancel`
    output: str = ""  # the end of its standard output and error together


def run_measured(command: list[str], limit_seconds: float | None = None, cancel: Cancel | None = None) -> ProcessUse:
    """Looks command[0] up in PATH. The program leads a process group of its own, and reads nothing from the terminal.

    After `limit_seconds`, or when `cancel` is raised, the group is asked to end, and killed two seconds later. Raises
    Error if the program cannot be started at all.
    """
    if not command:
        raise Error("a command must have at least a program's name")
    report, tell = os.pipe()
    try:
        launcher = subprocess.Popen(
            [sys.executable, "-I", "-S", str(_LAUNCHER), str(tell), *command],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            pass_fds=[tell],
            process_group=0,  # Ctrl-C reaches us alone, and we end the program
        )
    finally:
        os.close(tell)
    run = _Run(command[0], launcher, report)
    try:
        return run.follow(limit_seconds, cancel)
    finally:
        run.close()


class _Run:
    def __init__(self, program: str, launcher: subprocess.Popen, report: int) -> None:
        self._program, self._launcher, self._report = program, launcher, report
        self._group = 0  # of the program; 0: not known yet
        self._lines, self._output = b"", b""
        self._use: ProcessUse | None = None
        os.set_blocking(report, False)
        os.set_blocking(launcher.stdout.fileno(), False)
        self._selector = selectors.DefaultSelector()
        self._selector.register(report, selectors.EVENT_READ, self._read_report)
        self._selector.register(launcher.stdout, selectors.EVENT_READ, self._read_output)

    def follow(self, limit_seconds: float | None, cancel: Cancel | None) -> ProcessUse:
        begin, asked_to_end = time.monotonic(), None
        while self._use is None:
            for key, _ in self._selector.select(_STEP_SECONDS):
                key.data()
            now = time.monotonic()
            too_long = limit_seconds is not None and now > begin + limit_seconds
            if asked_to_end is None and self._group and (too_long or (cancel and cancel.cancelled)):
                self._signal(signal.SIGTERM)
                asked_to_end = now
            elif asked_to_end is not None and now > asked_to_end + _MERCY_SECONDS:
                self._signal(signal.SIGKILL)
        if asked_to_end is not None:
            self._signal(signal.SIGKILL)  # ends what the program may have left behind
        self._read_output()
        self._use.stopped = asked_to_end is not None
        self._use.output = self._output[-_KEPT_OUTPUT:].decode("utf-8", "replace")
        return self._use

    def close(self) -> None:
        if self._use is None and self._group:  # an exception came between
            self._signal(signal.SIGKILL)
        self._selector.close()
        os.close(self._report)
        self._launcher.stdout.close()
        self._launcher.wait()

    def _signal(self, number: int) -> None:
        try:
            os.killpg(self._group, number)
        except (ProcessLookupError, PermissionError):
            pass

    def _read_output(self) -> None:
        while chunk := _read(self._launcher.stdout.fileno()):
            self._output = (self._output + chunk)[-2 * _KEPT_OUTPUT :]
        if chunk == b"":  # all writers have closed it: it would be ready for ever
            self._forget(self._launcher.stdout)

    def _read_report(self) -> None:
        while chunk := _read(self._report):
            self._lines += chunk
        *lines, self._lines = self._lines.split(b"\n")
        for line in lines:
            self._take(json.loads(line))
        if chunk == b"" and self._use is None:
            raise Error(f"{self._program}: the process that watched it has gone")

    def _take(self, told: dict) -> None:
        if "errno" in told:
            raise Error(f"{self._program}: cannot be started: {os.strerror(told['errno'])}")
        if "pid" in told:
            self._group = told["pid"]
            return
        status = told["status"]
        code = status if status >= 0 else 128 - status
        self._use = ProcessUse(told["seconds"], told["cpu_seconds"], told["peak_mb"], code)

    def _forget(self, file: object) -> None:
        if file in (key.fileobj for key in self._selector.get_map().values()):
            self._selector.unregister(file)


def _read(descriptor: int) -> bytes | None:
    """Reads as much as there is: empty at the end, None if there is nothing yet."""
    try:
        return os.read(descriptor, 1 << 16)
    except BlockingIOError:
        return None


def last_line(output: str) -> str:
    """The last line that is not blank, trimmed: where programs usually report errors.

    If the output ends with a line of a scene's file and a caret below it, as our own errors do, it is the line before
    these two.
    """
    lines = [line.strip() for line in output.replace("\r", "\n").split("\n") if line.strip()]
    if len(lines) > 2 and lines[-1] == "^":
        return lines[-3]
    return lines[-1] if lines else ""
