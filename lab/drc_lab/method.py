"""A method that the bench compares: one of our own, or another program with an adapter."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from .adapter import Adapter
from .budget import SECONDS, SPP, TASKS, Budget
from .errors import Error
from .oidn_mode import MODES, OidnMode, best_mode, find_mode

# Integrators of drc render, and the one among them that has map passes.
INTEGRATORS = ("drc", "drc-maps", "path", "bdpt", "direct")
_WITH_MAPS = "drc-maps"
_DEFAULT_INTEGRATOR = "drc"
_MAP_DENOISERS = ("none", "gaussian", "oracle")
_DENOISERS = ("off", "surface", "oidn", "oidn-direct")

FindAdapter = Callable[[str], "Adapter | None"]


@dataclass
class Job:
    """The task of one run of a method."""

    scene: str
    output: str
    timing: str
    width: int
    height: int
    threads: int
    seed: int
    budget: Budget


@dataclass
class OwnProgram:
    """Settings that all of our own methods share."""

    path: str  # of drc
    direct_spp: int = 16  # samples a pixel of direct light if the budget is in tasks
    oidn_library: str = ""  # empty: the one that the system finds


class Method:
    """The method that `text` names.

    INTEGRATOR, drc-maps:MAP-DENOISER, drc-maps:WEIGHTS (a network's name, or a file), or the name of an adapter; each
    with +DENOISER. Without one, drc and drc-maps are denoised as by default, and the others are not. Ours take oidn and
    oidn-direct with a mode, as path+oidn:balanced-raw; without one they take the best mode for the budget. Or
    NAME=OPTIONS, with options of `drc render` separated by blanks. Raises Error that says what would be right.
    """

    def __init__(self, text: str, find_adapter: FindAdapter) -> None:
        self.name, equals, options = text.partition("=")
        self.adapter: Adapter | None = None
        self._denoiser = ""
        self._mode: OidnMode | None = None
        if equals:
            self._take_options(text, options.split())
            return
        way, plus, self._denoiser = text.partition("+")
        integrator, colon, map_denoiser = way.partition(":")
        if integrator not in INTEGRATORS:
            self._take_adapter(text, way, bool(plus), None if colon else find_adapter(way))
            return
        self._has_maps = integrator == _WITH_MAPS
        self._options = ["--integrator", integrator]
        if colon:
            if not self._has_maps or not map_denoiser:
                raise Error(f"method '{text}': only drc-maps takes a map denoiser or a network, as drc-maps:gaussian")
            self._options += ["--map-denoiser" if map_denoiser in _MAP_DENOISERS else "--weights", map_denoiser]
        if plus:
            self._take_denoiser(text)
        elif integrator != _DEFAULT_INTEGRATOR and not self._has_maps:
            # drc is what a user of it gets; the others are there to be compared with, and only with +DENOISER denoised.
            self._options += ["--denoise", "off"]

    def _take_options(self, text: str, options: list[str]) -> None:
        if not self.name:
            raise Error(f"method '{text}': has no name before the =")
        integrator = _DEFAULT_INTEGRATOR  # the last one that is named
        for i, option in enumerate(options):
            if option == "--integrator" and i + 1 < len(options):
                integrator = options[i + 1]
            if option.startswith("--integrator="):
                integrator = option.partition("=")[2]
        if integrator not in (*INTEGRATORS, "scene"):
            raise Error(f"no integrator '{integrator}'; there are {', '.join(INTEGRATORS)}")
        self._has_maps = integrator == _WITH_MAPS
        self._options = options

    def _take_adapter(self, text: str, way: str, has_denoiser: bool, adapter: Adapter | None) -> None:
        if adapter is None:
            raise Error(
                f"method '{text}': there are {', '.join(INTEGRATORS)}, drc-maps:MAP-DENOISER, drc-maps:NETWORK, "
                "NAME=OPTIONS, and what --adapter names"
            )
        if has_denoiser and self._denoiser not in adapter.denoisers:
            raise Error(f"method '{text}': {way} does not denoise by '{self._denoiser}'")
        self.adapter = adapter

    def _take_denoiser(self, text: str) -> None:
        self._denoiser, colon, mode = self._denoiser.partition(":")
        if colon:
            self._mode = find_mode(mode)
            if self._mode is None or not self._denoiser.startswith("oidn"):
                modes = ", ".join(known.name for known in MODES)
                raise Error(f"method '{text}': oidn and oidn-direct have the modes {modes}")
        if self._denoiser not in _DENOISERS:
            raise Error(f"method '{text}': denoisers are off, surface, oidn and oidn-direct")
        if not self._has_maps and self._denoiser in ("surface", "oidn-direct"):
            raise Error(f"method '{text}': {self._denoiser} filters the layers that only drc-maps has")
        self._options += ["--denoise", self._denoiser]

    def keeps(self, unit: str) -> bool:
        """Whether a budget can be kept in this unit: ours keep seconds, and tasks if they have maps, else spp."""
        if self.adapter:
            return unit in self.adapter.commands
        return unit == SECONDS or (unit == TASKS) == self._has_maps

    def oidn_mode(self, job: Job) -> OidnMode | None:
        """The mode of Open Image Denoise for a job of ours that asks for it by name."""
        if self.adapter or not self._denoiser.startswith("oidn"):
            return None
        if self._mode:
            return self._mode
        # Samples and tasks cost no time that denoising could take.
        seconds = job.budget.amount if job.budget.unit == SECONDS else math.inf
        return best_mode(seconds, job.width * job.height, job.threads)

    def command(self, job: Job, own: OwnProgram) -> list[str]:
        """The command line of a job, for a budget that the method keeps."""
        amount = f"{job.budget.amount:g}"
        if self.adapter:
            values = {"scene": job.scene, "output": job.output, "timing": job.timing, "denoiser": self._denoiser}
            values |= {"width": str(job.width), "height": str(job.height), "threads": str(job.threads)}
            values |= {"seed": str(job.seed), "seconds": amount, "spp": amount, "drc": own.path}
            return self.adapter.command(job.budget.unit, values)
        command = [own.path, "render", job.scene, *self._options]
        if own.oidn_library and self._denoiser.startswith("oidn"):
            command += ["--oidn-library", own.oidn_library]
        if mode := self.oidn_mode(job):
            command += ["--oidn-quality", mode.quality, "--oidn-prefilter", "on" if mode.prefilter else "off"]
        if job.budget.unit == TASKS:
            command += ["--indirect-tasks", amount, "--spp", str(own.direct_spp)]
        else:
            command += ["--spp" if job.budget.unit == SPP else "--time", amount]
        command += ["--resolution", f"{job.width}x{job.height}", "--nthreads", str(job.threads)]
        return command + ["--seed", str(job.seed), "--timing", job.timing, "--quiet", "-o", job.output]
