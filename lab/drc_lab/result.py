"""The results of a comparison of renderers: plain data that the bench stores and its page shows."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from .budget import Budget

NOT_MEASURED = math.nan
OPPONENT = "path+oidn"  # other methods are compared with path tracing and Open Image Denoise in any mode
MOST_DISPLAYED_NOISE = 0.25  # the largest share of SSIM or FLIP that the references' noise may have


def number_from(value: float | None) -> float:
    """JSON has no NaN: null stands for it."""
    return NOT_MEASURED if value is None else float(value)


@dataclass
class Run:
    """One process and the errors of its picture. NaN: not measured, or not defined."""

    scene: str
    method: str
    budget: Budget
    repeat: int = 0  # from 0; also the seed
    failure: str = ""  # one line; empty if there is a picture. If not empty, nothing below is valid
    picture: str = ""  # EXR, linear; relative to the folder of the report
    oidn_mode: str = ""  # empty: Open Image Denoise was not used
    measured_against: str = ""  # the state of the references' files
    seconds: float = NOT_MEASURED  # wall clock of the whole process
    # Parts of `seconds`, and samples a pixel, if the program reports them.
    load_seconds: float = NOT_MEASURED
    render_seconds: float = NOT_MEASURED
    denoise_seconds: float = NOT_MEASURED
    write_seconds: float = NOT_MEASURED
    cpu_seconds: float = NOT_MEASURED  # of all threads and child processes, user and system
    peak_mb: float = NOT_MEASURED  # largest resident set, in units of 10^6 bytes
    spp: float = NOT_MEASURED
    # Against a pair of references: cross errors with standard errors. Against a single one: relMSE of pixels and of
    # blocks, which includes the reference's noise; no trimmed error, no standard errors.
    error: float = NOT_MEASURED
    error_se: float = NOT_MEASURED
    trimmed_error: float = NOT_MEASURED
    trimmed_error_se: float = NOT_MEASURED
    block_error: float = NOT_MEASURED
    block_error_se: float = NOT_MEASURED
    ssim: float = NOT_MEASURED  # against the reference, or the mean of the pair
    flip: float = NOT_MEASURED
    png_kb: float = NOT_MEASURED  # of the 8-bit sRGB picture, in units of 1000 bytes
    entropy: float = NOT_MEASURED  # of its luminance's 256 levels, in bits a pixel
    mean_ratio: list[float] = field(default_factory=lambda: [NOT_MEASURED] * 3)  # R, G, B: picture / reference


# The numbers of a run, in the order of the JSON.
QUANTITIES = (
    "seconds", "load_seconds", "render_seconds", "denoise_seconds", "write_seconds", "cpu_seconds", "peak_mb", "spp",
    "error", "error_se", "trimmed_error", "trimmed_error_se", "block_error", "block_error_se", "ssim", "flip", "png_kb",
    "entropy",
)  # fmt: skip


@dataclass
class Scene:
    name: str
    file: str
    # EXR; relative to the folder of the report, or absolute. The page shows `reference`: for a pair it is the mean.
    reference: str = ""
    pair: list[str] = field(default_factory=list)  # two independent references; empty if there is only one
    reference_origin: str = ""  # "given", or how they were rendered
    width: int = 0
    height: int = 0
    reference_png_kb: float = NOT_MEASURED
    reference_entropy: float = NOT_MEASURED
    reference_noise: float = NOT_MEASURED  # of each reference of a pair, in the norm of the errors
    # How far a perfect picture is from SSIM 1 and FLIP 0, because of the noise of the pair's mean.
    ssim_noise: float = NOT_MEASURED
    flip_noise: float = NOT_MEASURED


@dataclass
class Report:
    version: str = ""
    processor: str = ""
    threads: int = 0
    scenes: list[Scene] = field(default_factory=list)
    methods: list[str] = field(default_factory=list)  # in the order in which they were asked for
    budgets: list[Budget] = field(default_factory=list)  # also in that order
    runs: list[Run] = field(default_factory=list)


@dataclass
class Spread:
    """The spread of one quantity over the repeats of a run."""

    count: int = 0
    median: float = NOT_MEASURED
    # An interval that contains the true median with a probability of at least 95 % if there are six or more repeats
    # (order statistics, for any distribution); with fewer, the smallest and the largest value.
    low: float = NOT_MEASURED
    high: float = NOT_MEASURED


def spread_of(values: list[float]) -> Spread:
    values = sorted(x for x in values if not math.isnan(x))
    n = len(values)
    if n == 0:
        return Spread()
    # The median lies outside of [x_k, x_(n-1-k)] with probability 2 P(B <= k), B binomial of n throws and 1/2.
    outside = term = 2.0 * 2.0**-n
    k = 0
    while True:
        term *= (n - k) / (k + 1)
        if outside + term > 0.05 or 2 * (k + 1) >= n:
            break
        outside += term
        k += 1
    return Spread(n, (values[(n - 1) // 2] + values[n // 2]) / 2, values[k], values[n - 1 - k])


def all_runs_of(report: Report, scene: str, method: str, budget: Budget) -> list[Run]:
    return [run for run in report.runs if run.scene == scene and run.method == method and run.budget == budget]


def runs_of(report: Report, scene: str, method: str, budget: Budget) -> list[Run]:
    """The successful runs of this scene, method and budget."""
    return [run for run in all_runs_of(report, scene, method, budget) if not run.failure]


def failures_of(report: Report, scene: str, method: str, budget: Budget) -> list[Run]:
    return [run for run in all_runs_of(report, scene, method, budget) if run.failure]


def opponent_error(report: Report, scene: str, budget: Budget) -> float:
    """The smallest median error of the methods that are the opponent. NaN: there was none."""
    medians = [
        spread_of([run.error for run in runs_of(report, scene, method, budget)]).median
        for method in report.methods
        if method == OPPONENT or method.startswith(f"{OPPONENT}:")
    ]
    best = min((median for median in medians if not math.isnan(median)), default=NOT_MEASURED)
    return best if best > 0 else NOT_MEASURED  # a cross error of nearly nothing may be below zero


def is_noisy(value: float, perfect: float, noise: float) -> bool:
    """Whether the noise by which a perfect picture would miss `perfect` has a large share of the value."""
    return noise > MOST_DISPLAYED_NOISE * abs(value - perfect)
