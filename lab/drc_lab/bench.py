"""Compares methods: scenes x methods x budgets, each in a process that is measured, and their errors."""

from __future__ import annotations

import json
import math
import os
from dataclasses import dataclass, field
from pathlib import Path

from . import log
from .budget import SECONDS, Budget
from .errors import Error
from .files import file_name, make_folder, read_text, state_of, write_whole
from .interrupt import Cancel
from .method import Job, Method, OwnProgram
from .process import last_line, run_measured
from .program import Program
from .reference import ReferenceSettings, render_references
from .result import NOT_MEASURED, Report, Run, Scene
from .result_json import run_from_json, run_json
from .scene_references import describe, given_references, measure, size_of

_USERS_SIZE = 1280, 720  # smaller pictures have more samples a pixel than users' have
_MEASURING = "2"  # to be raised when what is measured of a picture changes


@dataclass
class BenchSettings:
    scenes: list[str]  # files
    methods: list[Method]  # with different names
    budgets: list[Budget]  # a method is left out of budgets that it cannot keep
    own: OwnProgram
    output: Path  # folder, created if need be, with runs/ and references/
    threads: int = 1
    repeats: int = 1  # each with a seed of its own, from 0
    references: str = ""  # folder (scene_references.py); empty: they are rendered
    reference: ReferenceSettings = field(default_factory=ReferenceSettings)
    width: int = 0  # 0: the references' if they are given, else 1280x720
    height: int = 0
    limit_seconds: float = 3600  # of a run without a budget in seconds


def scene_name(file: str) -> str:
    """The file's name without extension, or that of its folder if the file is called "scene"."""
    path = Path(os.path.abspath(file))
    return path.parent.name if path.stem == "scene" else path.stem


def _processor_name() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        lines = []
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), "unknown processor")


def _duration(seconds: float) -> str:
    s = round(seconds)
    if s < 60:
        return f"{s}s"
    return f"{s // 60}m{s % 60:02}s" if s < 3600 else f"{s // 3600}h{s // 60 % 60:02}m"


def _check_installed(method: Method) -> None:
    if not method.adapter or not method.adapter.check:
        return
    adapter = method.adapter
    try:
        use = run_measured(adapter.check, 120)
        if use.exit_code == 0:
            return
        what = last_line(use.output)
    except Error as error:
        what = str(error)
    raise Error(f"{adapter.name}: not installed ({what}). {adapter.install}")


def _read_timing(path: str, run: Run) -> None:
    """Reads the times and samples that a program reports; few programs tell."""
    try:
        told = json.loads(read_text(Path(path)))
    except (Error, ValueError):
        return
    if not isinstance(told, dict):
        return
    for name in ("load_seconds", "render_seconds", "denoise_seconds", "write_seconds", "spp"):
        value = told.get(name)
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            setattr(run, name, float(value))


def _found(run: Run) -> str:
    error = f"{run.error:.5f}" + ("" if math.isnan(run.error_se) else f" +- {run.error_se:.5f}")
    return f"{run.seconds:.1f} s, error {error}, SSIM {run.ssim:.4f}, FLIP {run.flip:.4f}"


class _Bench:
    def __init__(self, settings: BenchSettings, cancel: Cancel | None) -> None:
        self._s, self._cancel = settings, cancel
        self._program = Program(settings.own.path)
        self._number = 0
        self._report = Report(
            version=self._program.version(),
            processor=_processor_name(),
            threads=settings.threads,
            methods=[method.name for method in settings.methods],
            budgets=settings.budgets,
        )
        make_folder(settings.output)

    def run(self) -> Report:
        for method in self._s.methods:
            _check_installed(method)
        names = [scene_name(file) for file in self._s.scenes]
        for name in names:
            if names.count(name) > 1:
                raise Error(f"two scenes are called {name}; give one of them another file name")
        self._announce()
        for file in self._s.scenes:
            if not self._cancelled():
                self._prepare(file)
        count = self._count(len(self._report.scenes))
        # Methods that are compared run side by side.
        for repeat in range(self._s.repeats):
            for scene in self._report.scenes:
                for budget in self._s.budgets:
                    for method in self._s.methods:
                        if method.keeps(budget.unit) and not self._cancelled():
                            self._add_run(scene, method, budget, repeat, count)
        return self._report

    def _cancelled(self) -> bool:
        return self._cancel is not None and self._cancel.cancelled

    def _kept(self) -> list[Budget]:
        """The budget of each run of a scene's repeat."""
        return [budget for budget in self._s.budgets for method in self._s.methods if method.keeps(budget.unit)]

    def _count(self, scenes: int) -> int:
        return len(self._kept()) * self._s.repeats * scenes

    def _announce(self) -> None:
        seconds = sum(budget.amount for budget in self._kept() if budget.unit == SECONDS)
        seconds *= self._s.repeats * len(self._s.scenes)
        count = self._count(len(self._s.scenes))
        text = f"{count} render{'' if count == 1 else 's'}"
        if seconds > 0:
            text += f", {_duration(seconds)} with a budget in seconds together"
        if not self._s.references:
            text += f"; before them two references of each scene, of at most {self._s.reference.max_spp} spp"
        log.info(f"{text}, to {self._s.output}")

    def _prepare(self, file: str) -> None:
        scene = Scene(scene_name(file), file, width=self._s.width, height=self._s.height)
        folder = self._s.output / "references"
        if self._s.references:
            paths, scene.reference_origin = given_references(self._s.references, scene.name), "given"
        else:
            if scene.width == 0:
                scene.width, scene.height = _USERS_SIZE
            make_folder(folder)
            rendered = render_references(
                self._program, file, file_name(scene.name), scene.width, scene.height, folder, state_of(file),
                self._s.reference, self._cancel,
            )  # fmt: skip
            if rendered is None:
                return
            paths = [os.path.relpath(path, self._s.output) for path in (rendered.first, rendered.second)]
            scene.reference_origin = rendered.origin
        scene.pair = paths if len(paths) == 2 else []
        scene.reference = paths[0]
        width, height = size_of(self._program, self._absolute(paths)[0])
        if scene.width == 0:
            scene.width, scene.height = width, height
        if (width, height) != (scene.width, scene.height):
            wanted = f"{scene.width}x{scene.height} are wanted"
            raise Error(f"{scene.reference}: the reference has {width}x{height} pixels, {wanted}")
        if scene.pair:
            make_folder(folder)
            mean = folder / f"{file_name(scene.name)}-{width}x{height}-mean.exr"
            self._program.average(self._absolute(paths), mean)
            scene.reference = os.path.relpath(mean, self._s.output)
        describe(self._program, self._absolute(paths), self._absolute([scene.reference])[0], scene)
        self._report.scenes.append(scene)

    def _absolute(self, files: list[str]) -> list[str]:
        return [str(self._s.output / file) for file in files]

    def _references_of(self, scene: Scene) -> list[str]:
        return self._absolute(scene.pair or [scene.reference])

    def _state_of_references(self, scene: Scene) -> str:
        """When it changes, pictures are measured anew."""
        return " ".join([_MEASURING, *map(state_of, self._references_of(scene))])

    def _key_of(self, method: Method, job: Job) -> str:
        anywhere = Job(**{**job.__dict__, "output": "", "timing": ""})  # the folder may be moved
        words = "".join(word + "\n" for word in method.command(anywhere, self._s.own))
        return words + ("" if method.adapter else state_of(self._s.own.path)) + "\n" + state_of(job.scene)

    def _add_run(self, scene: Scene, method: Method, budget: Budget, repeat: int, count: int) -> None:
        self._number += 1
        place = Path("runs", file_name(scene.name), file_name(method.name), f"{budget.name.replace(' ', '')}-{repeat}")
        stem = str(self._s.output / place)
        job = Job(
            scene=scene.file, output=f"{stem}.exr", timing=f"{stem}.timing.json",
            width=scene.width, height=scene.height, threads=self._s.threads, seed=repeat, budget=budget,
        )  # fmt: skip
        key, record = self._key_of(method, job), Path(f"{stem}.json")
        if known := self._known_run(record, key, job.output, scene):
            self._report.runs.append(known)
            return
        run = Run(scene.name, method.name, budget, repeat, picture=f"{place}.exr")
        if mode := method.oidn_mode(job):
            run.oidn_mode = mode.name
        make_folder(record.parent)
        for old in (record, Path(job.output), Path(job.timing)):
            old.unlink(missing_ok=True)
        name = f"{self._number}/{count} {run.scene}, {run.method}, {budget.name}"
        log.info(f"{name}: rendering")
        if not self._measure(method, job, scene, run):
            return
        write_whole(record, run_json(run, key))
        log.info(f"{name}: {'failed: ' + run.failure if run.failure else _found(run)}")
        self._report.runs.append(run)

    def _known_run(self, record: Path, key: str, picture: str, scene: Scene) -> Run | None:
        """The result of an earlier call, measured anew if the references have changed since."""
        if not record.exists() or not os.path.exists(picture):
            return None
        known = run_from_json(read_text(record), key)
        if known is None or known.failure:
            return None
        if known.measured_against != self._state_of_references(scene):
            try:
                self._measure_picture(picture, scene, known)
            except Error:  # damaged: as if it were not there
                return None
            write_whole(record, run_json(known, key))
        return known

    def _measure(self, method: Method, job: Job, scene: Scene, run: Run) -> bool:
        """False if it was cancelled."""
        command = method.command(job, self._s.own)
        log.debug(" ".join(command))
        # A method that overruns is judged by what it took; this ends what hangs.
        limit = 4 * job.budget.amount + 120 if job.budget.unit == SECONDS else self._s.limit_seconds
        try:
            use = run_measured(command, limit, self._cancel)
            if self._cancelled():
                return False
            if use.stopped:
                raise Error(f"still running after {limit:.0f} s")
            if use.exit_code != 0:
                raise Error(last_line(use.output) if use.output else f"exit code {use.exit_code}")
            if not os.path.exists(job.output):
                raise Error("ended without a picture")
            run.seconds, run.cpu_seconds, run.peak_mb = use.seconds, use.cpu_seconds, use.peak_mb
            _read_timing(job.timing, run)
            if not method.adapter:
                self._read_own_metadata(job.output, run)
            self._measure_picture(job.output, scene, run)
        except Error as error:
            run.failure = last_line(str(error))
        return True

    def _read_own_metadata(self, picture: str, run: Run) -> None:
        if math.isnan(run.denoise_seconds) and not math.isnan(run.render_seconds):
            run.denoise_seconds = 0  # our own program says how long it denoised, if it did
        try:
            run.spp = float(self._program.metadata(picture).get("drc:spp", run.spp))
        except ValueError:
            run.spp = NOT_MEASURED

    def _measure_picture(self, picture: str, scene: Scene, run: Run) -> None:
        measure(self._program, self._references_of(scene), scene, picture, run)
        run.measured_against = self._state_of_references(scene)


def run_bench(settings: BenchSettings, cancel: Cancel | None = None) -> Report:
    """Runs everything that has no result in the output yet, and returns all results.

    A result is valid as long as the command, the program (ours: drc itself) and the scene's file are unchanged; if
    references have changed, its picture is measured again. A method that fails leaves a Run with its message, and is
    tried again the next time. Stops early on `cancel`, and returns the results so far. Raises Error if the whole
    comparison makes no sense: a scene or a reference cannot be read, an external program is not installed, or two
    scenes have one name.
    """
    return _Bench(settings, cancel).run()
