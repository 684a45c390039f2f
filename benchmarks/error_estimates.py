#!/usr/bin/env python3
"""How near `drc render --noise-threshold` comes to the true error of the denoised picture.

    benchmarks/error_estimates.py --references DIR SCENE...

DIR has NAME-1.exr and NAME-2.exr for each scene, path traced without denoising from different seeds (`drc render
--integrator path --denoise off --seed 1`), which set the size; NAME is the scene's folder. For each scene and number of
samples: the true relative error (the square root of `drc compare`'s error), the estimate, and their ratio; then, for
thresholds, the samples at which the render stopped and what its error really was. Prints Markdown.
"""
import argparse
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import common


def metadata(picture, key):
    text = subprocess.run([common.DRC, "image", "info", picture], check=True, capture_output=True, text=True).stdout
    return re.search(rf"{key} = (\S+)", text).group(1)


def true_error(references, picture):
    command = [common.DRC, "compare", "--json", *map(str, references), picture]
    result = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    # Of a nearly perfect picture it may be below zero.
    return math.sqrt(max(0, result["error"])), result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+", type=pathlib.Path)
    parser.add_argument("--references", required=True, type=pathlib.Path)
    parser.add_argument("--spp", default="8,32,128", help="samples a pixel to estimate after")
    parser.add_argument("--thresholds", default="", help="thresholds to stop at")
    args = parser.parse_args()
    spps = [int(n) for n in args.spp.split(",") if n]
    thresholds = [float(e) for e in args.thresholds.split(",") if e]
    head = ["scene"]
    head += [f"{n} spp: {what}" for n in spps for what in ("true", "estimate", "ratio")]
    head += [f"threshold {e:g}: {what}" for e in thresholds for what in ("spp", "true")]
    rows, ratios = [], []
    with tempfile.TemporaryDirectory() as folder:
        picture = str(pathlib.Path(folder) / "picture.exr")
        for scene in args.scenes:
            name = scene.parent.name
            references = [args.references / f"{name}-{i}.exr" for i in (1, 2)]
            options = ["--resolution", common.resolution(references[0])]
            row = [name]
            for spp in spps:
                common.render(scene, picture, *options, "--spp", spp, "--noise-threshold", 0)
                true, result = true_error(references, picture)
                estimate = float(metadata(picture, "drc:error"))
                row += [f"{true:.4f}", f"{estimate:.4f}", f"{estimate / true:.2f}" if true > 0 else "-"]
                ratios += [estimate / true] if true > 0 else []
                print(f"{name} {spp} spp: squared error {result['error']:.6f} +- {result['error_se']:.6f}, references' "
                      f"noise {result['reference_noise']:.4f}, estimate {estimate:.4f}", file=sys.stderr)
            for threshold in thresholds:
                common.render(scene, picture, *options, "--noise-threshold", threshold, "--spp", 4096)
                true, _ = true_error(references, picture)
                row += [metadata(picture, "drc:spp"), f"{true:.4f}"]
            rows.append(row)
    print(common.table(head, rows))
    if ratios:
        print(f"\nEstimate / true error: {min(ratios):.2f} to {max(ratios):.2f}")


if __name__ == "__main__":
    main()
