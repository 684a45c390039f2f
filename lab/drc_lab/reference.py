"""Renders the two references of a scene, until their noise is small enough to measure with, and keeps them."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from . import log
from .errors import Error
from .files import make_folder
from .interrupt import Cancel
from .process import last_line, run_measured
from .program import Program

if TYPE_CHECKING:
    import numpy as np

_KEY, _ORIGIN, _ERROR = "drc:bench_key", "drc:bench_origin", "drc:bench_error"
_SPP, _PARTS = "drc:bench_spp", "drc:bench_parts"
_STREAMS = ("1a", "1b", "2a", "2b")  # first and second half of the first reference, then of the second
_FIRST_SPP = 32  # of a stream's first part; each later one adds half of what there is
_FIRST_SEED = 1 << 20  # far from the seeds of the runs that are compared


@dataclass
class ReferenceSettings:
    integrator: str = "path"  # or bdpt
    # The standard error that the references' noise may leave in the cross error of a perfect picture. The default is a
    # fiftieth of an error of .001.
    error: float = 2e-5
    max_spp: int = 1 << 16  # samples a pixel of each reference at which rendering stops, whatever its noise
    threads: int = 0


@dataclass
class RenderedReferences:
    first: Path
    second: Path
    origin: str  # "path, 2 x 96 spp, noise 2.3e-02, standard error about 1.2e-05"


def _metadata_of(program: Program, path: Path, key: str) -> dict[str, str] | None:
    """Metadata of a file that was written with this key; none if there is no such file, or a damaged one."""
    try:
        metadata = program.metadata(str(path)) if path.exists() else {}
    except Error:
        return None
    return metadata if metadata.get(_KEY) == key else None


class _Stream:
    """The mean of parts of different seeds; a file that is replaced as it grows."""

    def __init__(self, program: Program, path: Path, number: int, key: str) -> None:
        self.number, self._path, self._key = number, path, key
        self.mean: np.ndarray | None = None
        self.spp = self.parts = 0
        metadata = _metadata_of(program, path, key)
        if metadata and metadata.get(_SPP, "").isdigit() and metadata.get(_PARTS, "").isdigit():
            self.mean = program.pixels(str(path))
            self.spp, self.parts = int(metadata[_SPP]), int(metadata[_PARTS])

    @property
    def next_spp(self) -> int:
        return self.spp // 2 if self.spp else _FIRST_SPP

    @property
    def next_seed(self) -> int:
        return _FIRST_SEED + len(_STREAMS) * self.parts + self.number

    def add(self, part: np.ndarray) -> None:
        from .exr_file import write_exr

        samples = self.next_spp
        self.mean = part if self.mean is None else _weighted_mean(self.mean, self.spp, part, samples)
        self.spp, self.parts = self.spp + samples, self.parts + 1
        write_exr(self._path, self.mean, {_KEY: self._key, _SPP: str(self.spp), _PARTS: str(self.parts)})


def _weighted_mean(a: np.ndarray, weight_a: float, b: np.ndarray, weight_b: float) -> np.ndarray:
    mean = (a.astype("f8") * weight_a + b.astype("f8") * weight_b) / (weight_a + weight_b)
    return mean.astype("f4")


class _Rendering:
    def __init__(
        self, program: Program, scene: str, name: str, size: str, folder: Path, key: str, settings: ReferenceSettings
    ) -> None:
        self._program, self._scene, self._name, self._size = program, scene, name, size
        self._folder, self._key, self._settings = folder, key, settings
        self._streams = [_Stream(program, folder / f"{s}.exr", i, key) for i, s in enumerate(_STREAMS)]
        self._noise = self._error = float("inf")

    def render(self, cancel: Cancel | None) -> bool:
        """Adds samples until the pair is good enough, or has all the samples that it may have. False if cancelled."""
        while True:
            if self._is_complete():
                self._judge()
                first = self._streams[0]
                if self._error <= self._settings.error or 2 * (first.spp + first.next_spp) > self._settings.max_spp:
                    return True
                log.info(
                    f"references of {self._name}: 2 x {2 * first.spp} spp so far, noise {self._noise:.1e}, "
                    f"standard error about {self._error:.1e}"
                )
            stream = min(self._streams, key=lambda s: s.parts)
            if stream.parts == 0 and 2 * _FIRST_SPP > self._settings.max_spp:
                raise Error(f"the references of {self._name}: at least {2 * _FIRST_SPP} spp are needed")
            if not self._render_part(stream, cancel):
                return False

    def write(self, first: Path, second: Path) -> str:
        from .exr_file import write_exr

        spp = 2 * self._streams[0].spp
        if not self._error <= self._settings.error:
            log.warning(
                f"the references of {self._name} leave a standard error of about {self._error:.1e} after "
                f"2 x {spp} spp; {self._settings.error:.1e} was wanted"
            )
        origin = (
            f"{self._settings.integrator}, 2 x {spp} spp, noise {self._noise:.1e}, "
            f"standard error about {self._error:.1e}"
        )
        metadata = {_KEY: self._key, _ORIGIN: origin, _ERROR: f"{self._error:.6e}"}
        for path, mean in zip((first, second), self._means()):
            write_exr(path, mean, metadata)
        return origin

    def _is_complete(self) -> bool:
        parts = {stream.parts for stream in self._streams}
        return len(parts) == 1 and 0 not in parts

    def _means(self) -> list[np.ndarray]:
        halves = [stream.mean for stream in self._streams]
        return [_weighted_mean(halves[i], 1, halves[i + 1], 1) for i in (0, 2)]

    def _judge(self) -> None:
        from .reference_noise import reference_noise, standard_error

        self._error = standard_error([stream.mean for stream in self._streams])
        self._noise = reference_noise(*self._means())

    def _render_part(self, stream: _Stream, cancel: Cancel | None) -> bool:
        log.info(
            f"references of {self._name}: rendering {stream.next_spp} spp, "
            f"picture {stream.number + 1} of {len(_STREAMS)}"
        )
        raw = self._folder / "part.exr"
        command = [self._program.path, "render", self._scene, "--integrator", self._settings.integrator]
        command += ["--spp", str(stream.next_spp), "--seed", str(stream.next_seed), "--resolution", self._size]
        command += ["--nthreads", str(self._settings.threads), "--denoise", "off", "--quiet", "-o", str(raw)]
        use = run_measured(command, cancel=cancel)
        if cancel and cancel.cancelled:
            return False
        if use.exit_code != 0:
            raise Error(f"the references of {self._name} could not be rendered: {last_line(use.output)}")
        stream.add(self._program.pixels(str(raw)))
        os.unlink(raw)
        return True


def render_references(
    program: Program,
    scene: str,
    name: str,
    width: int,
    height: int,
    folder: Path,
    key: str,
    settings: ReferenceSettings,
    cancel: Cancel | None = None,
) -> RenderedReferences | None:
    """`folder`/NAME-WIDTHxHEIGHT-1.exr and -2.exr, if they have the key and are good enough; else they are rendered.

    Each is the mean of two halves, so there are four streams of samples with different seeds, kept in
    `folder`/NAME-WIDTHxHEIGHT: after an interruption, or for a smaller error, rendering continues there. None if
    cancelled. Raises Error if the program fails.
    """
    size, whole_key = f"{width}x{height}", f"{settings.integrator}\n{key}"
    first, second = (folder / f"{name}-{size}-{i}.exr" for i in (1, 2))
    known = [_metadata_of(program, path, whole_key) for path in (first, second)]
    if all(known) and known[0].get(_ORIGIN) == known[1].get(_ORIGIN):
        try:
            good_enough = float(known[0].get(_ERROR, "inf")) <= settings.error
        except ValueError:
            good_enough = False
        if good_enough:
            return RenderedReferences(first, second, known[0].get(_ORIGIN, ""))
    parts = folder / f"{name}-{size}"
    make_folder(parts)
    rendering = _Rendering(program, scene, name, size, parts, whole_key, settings)
    if not rendering.render(cancel):
        return None
    return RenderedReferences(first, second, rendering.write(first, second))
