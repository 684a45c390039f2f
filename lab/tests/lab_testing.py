"""Shared by the tests: programs, pictures, and reports with given numbers."""

import html.parser
import os
import tempfile
import unittest
from pathlib import Path

import numpy as np
from drc_lab.budget import SECONDS, SPP, TASKS, Budget
from drc_lab.errors import Error
from drc_lab.exr_file import write_exr
from drc_lab.program import Program, find_program
from drc_lab.result import NOT_MEASURED, Report, Run, Scene


def seconds(amount):
    return Budget(SECONDS, amount)


def spp(amount):
    return Budget(SPP, amount)


def tasks(amount):
    return Budget(TASKS, amount)


def the_program():
    """drc; skips the test where there is none."""
    try:
        return Program(find_program(os.environ.get("DRC_PROGRAM")))
    except Error as error:
        raise unittest.SkipTest(str(error))


def flat(value, width=16, height=12):
    return np.full((height, width, 3), value, dtype=np.float32)


def picture_of(seed, width=16, height=12):
    """A picture that differs from that of any other seed."""
    y, x = np.mgrid[:height, :width].astype(np.float32) / 16
    return np.stack([x, y, np.full_like(x, (seed % 64) / 64)], axis=2)


class FolderTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="drc-lab-test-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, text, executable=False):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        if executable:
            path.chmod(0o755)
        return str(path)

    def assert_error(self, call, *parts):
        """call raises Error, one line that has all of these parts."""
        with self.assertRaises(Error) as caught:
            call()
        for part in parts:
            self.assertIn(part, str(caught.exception))
        self.assertNotIn("\n", str(caught.exception))


class ReportBuilder:
    """A report that grows with its runs: scenes, methods and budgets have the order in which they first appear."""

    def __init__(self, folder=None):
        self.folder = folder  # of pictures; none: they are not written
        self.report = Report(version="9.8.7", processor="some processor", threads=3)
        self._pictures = 0

    def add(self, scene, method, budget, error, ssim=0.5, **values):
        """Adds a run that took as long as its budget in seconds, or one second."""
        report = self.report
        if all(known.name != scene for known in report.scenes):
            report.scenes.append(
                Scene(scene, "scene.pbrt", self.picture(), reference_origin="given", width=16, height=12)
            )
        for known, item in ((report.methods, method), (report.budgets, budget)):
            if item not in known:
                known.append(item)
        repeat = sum((run.scene, run.method, run.budget) == (scene, method, budget) for run in report.runs)
        run = Run(
            scene, method, budget, repeat, picture=self.picture(), error=error, ssim=ssim, flip=error / 2, png_kb=10
        )
        run.seconds = budget.amount if budget.unit == SECONDS else 1
        run.cpu_seconds, run.peak_mb = 2 * run.seconds, 100
        for name, value in values.items():
            setattr(run, name, value)
        report.runs.append(run)
        return run

    def add_failure(self, scene, method, budget, failure):
        self.add(scene, method, budget, NOT_MEASURED, NOT_MEASURED, failure=failure, picture="")

    def picture(self):
        self._pictures += 1
        name = f"picture-{self._pictures}.exr"
        if self.folder:
            write_exr(Path(self.folder, name), picture_of(self._pictures), {})
        return name


class _Nesting(html.parser.HTMLParser):
    _VOID = {"meta", "img", "input", "br"}

    def __init__(self):
        super().__init__()
        self.open, self.fault = [], ""

    def handle_starttag(self, tag, attributes):
        if tag not in self._VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        pass

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.fault = self.fault or f"</{tag}> at line {self.getpos()[0]} closes nothing that is open"


def broken_nesting(text):
    """The first error in the nesting of tags; empty if there is none."""
    parser = _Nesting()
    parser.feed(text)
    return parser.fault or (f"<{parser.open[-1]}> is not closed" if parser.open else "")


def between(text, start, end):
    """The text from the first occurrence of `start` to the next one of `end`."""
    begin = text.index(start)
    return text[begin : text.index(end, begin + len(start))]
