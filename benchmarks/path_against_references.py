#!/usr/bin/env python3
"""The path tracer against references by another renderer.

    benchmarks/path_against_references.py --spp 1024 --references DIR SCENE.pbrt ...

Renders each scene twice with different seeds at the reference's size. If both renderers agree, the reference differs
from one of ours by no more noise than ours differ from each other (times the ratio of their variances, if the
reference has other spp; --reference-spp NAME=SPP says so).
"""
import argparse
import os

from common import compare, render, resolution, table


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--references", required=True)
    parser.add_argument("--spp", type=int, default=1024)
    parser.add_argument("--reference-spp", action="append", default=[], metavar="NAME=SPP")
    parser.add_argument("--output", default="out/path")
    parser.add_argument("--resume", action="store_true", help="take the pictures that are already in --output")
    args = parser.parse_args()
    os.makedirs(args.output, exist_ok=True)
    spp_of = dict(pair.split("=") for pair in args.reference_spp)
    rows = []
    for scene in args.scenes:
        name = os.path.basename(os.path.dirname(os.path.abspath(scene)))
        reference = os.path.join(args.references, name + ".exr")
        spp = int(spp_of.get(name, args.spp))
        pictures = []
        for seed in (1, 2):
            picture = os.path.join(args.output, f"{name}-{seed}.exr")
            if not (args.resume and os.path.exists(picture)):
                render(scene, picture, "--integrator", "path", "--spp", spp, "--seed", seed, "--resolution",
                       resolution(reference), "-o", picture[:-4] + ".png")
            pictures.append(picture)
        m = compare(reference, pictures[0], "--diff", pictures[0][:-4] + "-diff.png")
        own = compare(pictures[1], pictures[0])
        rows.append([name, spp, " ".join(f"{r:.4f}" for r in m["mean_ratio"]), f"{m['relmse']:.5f}", f"{own['relmse']:.5f}",
                     f"{m['relmse'] / own['relmse']:.2f}"])
        print("  ".join(map(str, rows[-1])), flush=True)
    print()
    print(table(["scene", "spp", "mean ratio RGB", "relMSE to reference", "relMSE between two of ours", "ratio"], rows))


main()
