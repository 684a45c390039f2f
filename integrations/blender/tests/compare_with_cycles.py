#!/usr/bin/env python3
"""Small scenes, one for each feature, rendered by Blender's Cycles and by DRC from what the add-on exports.

    integrations/blender/tests/compare_with_cycles.py --drc build/release/drc [--spp N] [--keep FOLDER] [NAME ...]

Run it with a Python that has Blender's module bpy; without it the test is skipped: it ends with status 77. The mean of
each channel must be within 2 per cent, and the mean over squares of 8 x 8 pixels of the relative squared difference
within 1e-3, unless the scene has a reason (scenes/). Prints a Markdown table. Ends with 1 if a scene is too far
apart.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
BLOCK = 8


def set_up_cycles(scene, spp):
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.seed = "CPU", spp, 1
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.blur_glossy = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    for bounces in ("max", "diffuse", "glossy", "transmission", "transparent_max"):
        setattr(cycles, bounces + "_bounces", 32)
    cycles.pixel_filter_type = "BOX"
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"


def quietly(function):
    """With what Cycles prints on its way left out."""
    with open(os.devnull, "w") as quiet:
        kept = os.dup(1)
        os.dup2(quiet.fileno(), 1)
        try:
            return function()
        finally:
            os.dup2(kept, 1)
            os.close(kept)


def read(path):
    """height x width x 3, from the top."""
    import bpy
    import numpy as np

    image = bpy.data.images.load(path)
    image.colorspace_settings.name = "Non-Color"
    width, height = image.size
    values = np.empty(width * height * image.channels, dtype=np.float32)
    image.pixels.foreach_get(values)
    bpy.data.images.remove(image)
    return values.reshape(height, width, -1)[::-1, :, :3]


def blocks(picture):
    height, width = (n // BLOCK * BLOCK for n in picture.shape[:2])
    return picture[:height, :width].reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK, 3).mean(axis=(1, 3))


def difference(ours, theirs):
    """(relative difference of each channel's mean, mean of the blocks' relative squared differences)"""
    means = ours.mean(axis=(0, 1)), theirs.mean(axis=(0, 1))
    a, b = blocks(ours), blocks(theirs)
    floor = (0.05 * float(theirs.mean())) ** 2  # for blocks that are as good as black
    return means[0] / means[1] - 1, float(((a - b) ** 2 / (b * b + floor)).mean())


def render_both(drc, feature, folder, spp):
    """(our picture, Cycles' picture, the exporter's report)"""
    import bpy

    from drc_blender.export.scene import SceneExporter, Settings

    stage = feature["build"]()
    scene = stage.scene
    spp = spp or feature["spp"]
    set_up_cycles(scene, spp)
    theirs, ours = os.path.join(folder, "cycles.exr"), os.path.join(folder, "drc.exr")
    scene.render.filepath = theirs
    quietly(lambda: bpy.ops.render.render(write_still=True))
    shutil.rmtree(os.path.join(folder, "scene"), ignore_errors=True)
    exporter = SceneExporter(os.path.join(folder, "scene"), Settings(max_depth=32, filter_kind="BOX", filter_width=1.0))
    depsgraph = bpy.context.evaluated_depsgraph_get()
    made = exporter.export(depsgraph, set_frame=lambda f, s: scene.frame_set(f, subframe=s))
    done = subprocess.run(
        [
            drc,
            "render",
            made.path,
            "--integrator",
            "path",
            "--spp",
            str(spp),
            "--denoise",
            "off",
            "--quiet",
            "-o",
            ours,
        ],
        capture_output=True,
        text=True,
    )
    if done.returncode:
        raise RuntimeError(done.stderr.strip() or f"drc ended with {done.returncode}")
    return read(ours), read(theirs), made.report.lines() + done.stderr.strip().splitlines()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--drc", required=True, help="the program")
    parser.add_argument("--spp", type=int, help="samples of a pixel, of both renderers (default: as the scene needs)")
    parser.add_argument("--keep", help="a folder for the pictures and exported scenes")
    parser.add_argument("--verbose", action="store_true", help="also print what the exporter reports")
    parser.add_argument("names", nargs="*", metavar="NAME", help="scenes, by a part of their names (default: all)")
    args = parser.parse_args()
    try:
        import bpy
    except ImportError:
        print("skipped: this Python has no bpy")
        return SKIPPED
    from scenes import FEATURES

    chosen = {n: f for n, f in FEATURES.items() if not args.names or any(part in n for part in args.names)}
    wrong = 0
    print(f"Blender {bpy.app.version_string}, {len(chosen)} scenes\n")
    print("| scene | red | green | blue | squares | |\n|---|---|---|---|---|---|", flush=True)
    for name, feature in chosen.items():
        with tempfile.TemporaryDirectory() as folder:
            if args.keep:
                folder = os.path.join(args.keep, "".join(c if c.isalnum() else "_" for c in name))
                os.makedirs(folder, exist_ok=True)
            try:
                ours, theirs, report = render_both(os.path.abspath(args.drc), feature, folder, args.spp)
                if ours.shape != theirs.shape:
                    raise RuntimeError(f"sizes differ: {ours.shape} and {theirs.shape}")
                means, square = difference(ours, theirs)
                bad = not (abs(means).max() <= feature["mean"] and square <= feature["block"])
                note = feature["reason"] or "" if bad else ""
                failed = bad and not feature["reason"]
                print(
                    f"| {name} | "
                    + " | ".join(f"{m:+.1%}" for m in means)
                    + f" | {square:.1e} | {'**too far apart**' if failed else note} |",
                    flush=True,
                )
            except Exception as error:  # the next scenes are rendered all the same
                failed, report = True, []
                print(f"| {name} | | | | | **{type(error).__name__}: {error}** |", flush=True)
                if args.verbose:
                    import traceback

                    traceback.print_exc()
        wrong += failed
        if args.verbose:
            for line in report:
                print("    " + line, flush=True)
    print(f"\n{wrong} of {len(chosen)} too far apart")
    return 1 if wrong else 0


if __name__ == "__main__":
    status = main()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)  # bpy 4.5 does not end by itself
