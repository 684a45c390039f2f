"""The command line of `drc bench`."""

from __future__ import annotations

import argparse
import os
import re
from pathlib import Path

from .adapter import Adapter, read_adapter
from .arguments import (
    ExtendLists, Parser, comma_list, number_above, one_of, seconds_of_work, threads_number, whole_number_in,
)  # fmt: skip
from .bench import BenchSettings
from .budget import SECONDS, SPP, TASKS, Budget, parse_budgets
from .errors import Error, UsageError
from .method import INTEGRATORS, Method, OwnProgram
from .program import find_program
from .reference import ReferenceSettings
from .threads import available_cores

DEFAULT_SECONDS = 10  # the budget if none is given
_DEFAULT_METHODS = ["drc", "path"]
_LARGEST_SIDE = 1 << 16
_LEAST_SIDE = 11  # SSIM needs them
_MOST_SPP = 1 << 24

_FOOTER = """\
Example: drc bench scene.pbrt --methods drc,path+oidn --seconds 10,30,60
After an interruption, which ends it with 130 (Ctrl-C), 143 (SIGTERM) or 129 (SIGHUP), the same command
continues where it stopped."""


def bench_parser() -> Parser:
    parser = Parser(
        "drc bench",
        usage="drc bench [OPTIONS] SCENE...",
        description="Compare renderers: scenes x methods x budgets, as a page with tables",
        epilog=_FOOTER,
    )
    add = parser.add_argument
    add("scenes", metavar="SCENE", nargs="+", help="Scene files, pbrt-v3 or pbrt-v4")
    add(
        "-o",
        "--output",
        metavar="TEXT",
        default="out/bench",
        help="Folder for index.html, bench.json, bench.md and all pictures. Default: out/bench",
    )
    add(
        "--methods",
        metavar="TEXT",
        nargs="+",
        type=comma_list,
        action=ExtendLists,
        help=f"With commas between: {', '.join(INTEGRATORS)}, drc-maps:MAP-DENOISER (none, gaussian, oracle), "
        "drc-maps:NETWORK, or the name of an adapter (cycles, mitsuba3, pbrt-v3, pbrt-v4); each with +DENOISER, as "
        "path+oidn: Open Image Denoise in its best mode for the budget, or in one that is named: path+oidn:high, "
        ":balanced, :high-raw, :balanced-raw, :fast-raw; raw: albedo and normal are not filtered first. "
        "Default: drc,path",
    )
    add(
        "--method",
        metavar="TEXT",
        nargs="+",
        action=ExtendLists,
        dest="named_methods",
        help="NAME=OPTIONS: our own renderer with these options of drc render; may be repeated",
    )
    add(
        "--adapter",
        metavar="TEXT",
        nargs="+",
        action=ExtendLists,
        dest="adapters",
        help="Adapter file of another program, or its folder; may be repeated. The adapter's name is then a method",
    )
    add(
        "--seconds",
        metavar="TEXT",
        nargs="+",
        type=comma_list,
        action=ExtendLists,
        help=f"Wall-clock budgets of the whole process, as 10,30. Default, if no budget is given: {DEFAULT_SECONDS}",
    )
    add(
        "--spp",
        metavar="TEXT",
        nargs="+",
        type=comma_list,
        action=ExtendLists,
        help="Budgets in samples a pixel, as 1..256: adapters and ours without radiance maps",
    )
    add(
        "--tasks",
        metavar="TEXT",
        nargs="+",
        type=comma_list,
        action=ExtendLists,
        help="Budgets in indirect tasks, as 1..256: drc-maps",
    )
    add(
        "--direct-spp",
        metavar="INT",
        type=whole_number_in(1, _MOST_SPP),
        default=16,
        help="Samples a pixel of direct light where the budget is in tasks. Default: 16",
    )
    add(
        "--repeats",
        metavar="INT",
        type=whole_number_in(1, 1000, "Value {} not in range {} to {}"),
        default=1,
        help="Number of runs of each method, from 1 to 1000, each with its own seed. Default: 1",
    )
    add(
        "--references",
        metavar="TEXT",
        default="",
        help="Folder with NAME-1.exr and NAME-2.exr for each scene, of different seeds, or with NAME.exr, whose noise "
        "is then part of the errors. NAME is that of the scene file, or of its folder if the file is called "
        "scene.pbrt. Default: pairs are rendered, and kept in the output folder",
    )
    add(
        "--reference-error",
        metavar="FLOAT",
        type=number_above(0),
        default=ReferenceSettings.error,
        help="Standard error that the noise of rendered references may leave in an error. Default: 2e-05",
    )
    add(
        "--reference-integrator",
        metavar="TEXT",
        type=one_of("path", "bdpt"),
        default=ReferenceSettings.integrator,
        help="path or bdpt. Default: path",
    )
    add(
        "--reference-spp",
        metavar="INT",
        type=whole_number_in(1, _MOST_SPP),
        default=ReferenceSettings.max_spp,
        help="Samples a pixel of each reference at which rendering it stops, whatever its noise. Default: 65536",
    )
    add(
        "--resolution",
        metavar="TEXT",
        default="",
        help="WIDTHxHEIGHT in pixels. Default: the given references', else 1280x720",
    )
    add(
        "--limit",
        metavar="FLOAT",
        type=seconds_of_work,
        default=3600,
        help="Seconds after which a run without a budget in seconds is ended. Default: 3600",
    )
    add(
        "--nthreads",
        metavar="INT",
        type=threads_number(),
        default=0,
        help="Number of threads; 0, the default: one for each core that the affinity mask and the control group give",
    )
    add(
        "--oidn-library",
        metavar="TEXT",
        default="",
        help="Path of libOpenImageDenoise.so, if the system does not find it by itself",
    )
    add("--quiet", action="store_true", help="Print only the table, warnings and errors")
    add("-v", "--verbose", action="store_true", help="Print more messages, among them the command lines")
    add("--drc", metavar="PROGRAM", help="The drc that renders and measures. Default: the one that was called")
    return parser  # fmt: skip


def _shipped_adapters() -> list[Path]:
    """The folders where adapters may be: above lab/ in the source tree, or beside it in an installation."""
    here = Path(__file__).resolve().parents[2]
    return [here / "integrations", Path("integrations")]


def _find_adapter(name: str, given: list[Adapter]) -> Adapter | None:
    for adapter in given:
        if adapter.name == name:
            return adapter
    for folder in _shipped_adapters():
        if name and (folder / name / "adapter.json").exists():
            return read_adapter(str(folder / name))
    return None


def _methods(options: argparse.Namespace) -> list[Method]:
    adapters = [read_adapter(path) for path in options.adapters or []]
    for text in options.methods or []:
        if "=" in text:
            raise UsageError(f"--methods {text}: give a method with options of its own by --method")
    for text in options.named_methods or []:
        if "=" not in text:
            raise UsageError(f"--method {text}: give NAME=OPTIONS, the options being those of drc render")
    methods: list[Method] = []
    # A list is given, or the default holds; methods with options of their own come on top.
    for text in (options.methods or _DEFAULT_METHODS) + (options.named_methods or []):
        try:
            methods.append(Method(text, lambda name: _find_adapter(name, adapters)))
        except Error as error:
            raise UsageError(str(error)) from None
        if methods[-1].name in [method.name for method in methods[:-1]]:
            raise UsageError(f"two methods are called {methods[-1].name}")
    return methods


def _resolution(text: str) -> tuple[int, int]:
    if not text:
        return 0, 0
    sides = re.fullmatch(r"(\d{1,6})x(\d{1,6})", text, re.ASCII)
    width, height = map(int, sides.groups()) if sides else (0, 0)
    if not (1 <= width <= _LARGEST_SIDE and 1 <= height <= _LARGEST_SIDE):
        raise UsageError(
            f"--resolution {text}: give width and height in pixels, at most {_LARGEST_SIDE} each, as 1280x720"
        )
    if min(width, height) < _LEAST_SIDE:
        raise UsageError(f"--resolution {text}: pictures are compared from {_LEAST_SIDE} pixels upwards")
    return width, height


def bench_settings(options: argparse.Namespace) -> BenchSettings:
    methods, budgets = _methods(options), []
    for unit, texts in ((SECONDS, options.seconds), (SPP, options.spp), (TASKS, options.tasks)):
        budgets += parse_budgets(texts or [], unit, f"--{unit}")
    budgets = budgets or [Budget(SECONDS, DEFAULT_SECONDS)]
    for method in methods:
        if not any(method.keeps(budget.unit) for budget in budgets):
            raise UsageError(f"method {method.name} keeps none of the budgets that are asked for")
    width, height = _resolution(options.resolution)
    threads = options.nthreads or available_cores()
    return BenchSettings(
        scenes=options.scenes,
        methods=methods,
        budgets=budgets,
        own=OwnProgram(find_program(options.drc), options.direct_spp, options.oidn_library),
        output=Path(os.path.normpath(options.output)),
        threads=threads,
        repeats=options.repeats,
        references=options.references,
        reference=ReferenceSettings(
            options.reference_integrator, options.reference_error, options.reference_spp, threads
        ),
        width=width,
        height=height,
        limit_seconds=options.limit,
    )
