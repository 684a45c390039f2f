#!/usr/bin/env python3
"""DRC against path tracing and what denoisers make of it, all given the same wall-clock time for the whole process.

    benchmarks/equal_time.py --seconds 30 --references DIR SCENE.pbrt ...

A scene's reference is DIR/NAME.exr, NAME being the scene's folder; the picture has the reference's size. Prints a
Markdown table; keeps the pictures in --output.
"""
import argparse
import os

from common import compare, render, resolution, table


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--references", required=True)
    parser.add_argument("--seconds", type=float, default=30)
    parser.add_argument("--output", default="out/equal_time")
    parser.add_argument("--methods", default="drc,path",
                        help="drc, path, bdpt, direct; drc:ENHANCER or drc:NETWORK for another one (gaussian; drc); with "
                             "+DENOISER, as path+oidn or drc+off")
    parser.add_argument("--oidn-library", help="libOpenImageDenoise.so, where the system does not find it by itself")
    parser.add_argument("options", nargs="*", help="after --: passed on to drc render")
    args = parser.parse_args()
    os.makedirs(args.output, exist_ok=True)
    rows = []
    for scene in args.scenes:
        name = os.path.basename(os.path.dirname(os.path.abspath(scene)))
        reference = os.path.join(args.references, name + ".exr")
        for method in args.methods.split(","):
            tracing, _, denoiser = method.partition("+")
            integrator, _, enhancer = tracing.partition(":")
            picture = os.path.join(args.output, f"{name}-{method.replace(':', '-').replace('/', '_')}.exr")
            options = ["--integrator", integrator, "--time", args.seconds, "--resolution", resolution(reference),
                       "-o", picture[:-4] + ".png"]
            if enhancer:
                options += ["--enhancer" if enhancer in ("none", "gaussian", "oracle") else "--weights", enhancer]
            if denoiser:
                options += ["--denoise", denoiser]
                if args.oidn_library and denoiser.startswith("oidn"):
                    options += ["--oidn-library", args.oidn_library]
            seconds = render(scene, picture, *options)
            m = compare(reference, picture, "--diff", picture[:-4] + "-diff.png")
            rows.append([name, method, f"{seconds:.1f}", f"{m['ssim']:.4f}", f"{m['flip']:.4f}", f"{m['relmse']:.5f}",
                         " ".join(f"{r:.3f}" for r in m["mean_ratio"])])
            print("  ".join(rows[-1]), flush=True)
    print()
    print(table(["scene", "method", "seconds", "SSIM", "FLIP", "relMSE", "mean ratio RGB"], rows))


main()
