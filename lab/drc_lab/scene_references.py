"""The references that a scene's pictures are compared with: two independent ones, or one."""

from __future__ import annotations

import os

from .errors import Error
from .program import Program
from .result import Run, Scene, number_from


def given_references(folder: str, name: str) -> list[str]:
    """NAME-1.exr and NAME-2.exr in the folder, else NAME.exr. Raises Error if there are none, or only one of a pair."""
    single, first, second = (os.path.abspath(os.path.join(folder, name + end)) for end in (".exr", "-1.exr", "-2.exr"))
    there = [path for path in (first, second) if os.path.exists(path)]
    if len(there) == 2:
        return there
    if there:
        other = second if there[0] == first else first
        raise Error(f"{there[0]} is there, but not {other}: a pair of references needs both")
    if os.path.exists(single):
        return [single]
    raise Error(f"--references {folder}: there is neither {name}.exr nor {name}-1.exr with {name}-2.exr")


def size_of(program: Program, picture: str) -> tuple[int, int]:
    info = program.info(picture)
    return info["width"], info["height"]


def describe(program: Program, references: list[str], shown: str, scene: Scene) -> None:
    """Fills in the noise and the file size of references. shown: the only one, or the mean of a pair."""
    told = program.compare(references, shown)
    scene.reference_png_kb = number_from(told["png_kb"][0])
    scene.reference_entropy = number_from(told.get("entropy", [None])[0])
    if len(references) == 2:
        scene.reference_noise = number_from(told["reference_noise"])
        scene.ssim_noise, scene.flip_noise = number_from(told["ssim_noise"]), number_from(told["flip_noise"])


def measure(program: Program, references: list[str], scene: Scene, picture: str, run: Run) -> None:
    """Fills in the errors of a picture. Raises Error if it has another size or is not a picture."""
    width, height = size_of(program, picture)
    if (width, height) != (scene.width, scene.height):
        raise Error(f"wrote {width}x{height} pixels, not {scene.width}x{scene.height}")
    told = program.compare(references, picture)
    if len(references) == 2:
        for name in ("error", "trimmed_error", "block_error"):
            setattr(run, name, number_from(told[name]))
            setattr(run, f"{name}_se", number_from(told[f"{name}_se"]))
    else:
        run.error, run.block_error = number_from(told["relmse"]), number_from(told["block_relmse"])
    run.ssim, run.flip = number_from(told["ssim"]), number_from(told["flip"])
    run.png_kb = number_from(told["png_kb"][1])
    run.entropy = number_from(told.get("entropy", [None, None])[1])
    run.mean_ratio = [number_from(ratio) for ratio in told["mean_ratio"]]
