#!/usr/bin/env python3
"""The path tracer against references by another renderer.

    benchmarks/path_against_references.py --spp 1024 --references DIR SCENE.pbrt ...

Renders each scene with several seeds at the reference's size. If both renderers agree and are as noisy as each other,
the reference differs from one of ours by no more than ours differ from each other, and the ratio of the two is one; if
the reference's noise has another variance, it is the mean of one and of the ratio of the variances. (If the reference
has other spp, --reference-spp NAME=SPP says so.) Noise differs from pixel to pixel, errors do not: in the means of 8x8
pixels noise is 64 times less, and a difference of light that is spread over more than a few pixels stands out.
Fireflies make all figures uncertain: with more --seeds the table says how much, by the scatter among pictures and among
disjoint pairs.
"""
import argparse
import os
import statistics

from common import compare, render, resolution, table


def with_error(values):
    """The mean and, of more than one value, its standard error."""
    mean = f"{statistics.mean(values):.2e}"
    if len(values) < 2:
        return mean
    return f"{mean} +- {statistics.stdev(values) / len(values) ** 0.5:.0e}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--references", required=True)
    parser.add_argument("--spp", type=int, default=1024)
    parser.add_argument("--reference-spp", action="append", default=[], metavar="NAME=SPP")
    parser.add_argument("--output", default="out/path")
    parser.add_argument("--seeds", type=int, default=2, help="pictures of each scene, an even number")
    parser.add_argument("--resume", action="store_true", help="take the pictures that are already in --output")
    args = parser.parse_args()
    if args.seeds < 2 or args.seeds % 2:
        parser.error("--seeds must be an even number, 2 or more")
    os.makedirs(args.output, exist_ok=True)
    spp_of = dict(pair.split("=") for pair in args.reference_spp)
    rows = []
    for scene in args.scenes:
        name = os.path.basename(os.path.dirname(os.path.abspath(scene)))
        reference = os.path.join(args.references, name + ".exr")
        spp = int(spp_of.get(name, args.spp))
        pictures = []
        for seed in range(1, args.seeds + 1):
            picture = os.path.join(args.output, f"{name}-{seed}.exr")
            if not (args.resume and os.path.exists(picture)):
                render(scene, picture, "--integrator", "path", "--spp", spp, "--seed", seed, "--resolution",
                       resolution(reference), "-o", picture[:-4] + ".png", "--denoise", "off")
            pictures.append(picture)
        to_reference = [compare(reference, p, "--diff", p[:-4] + "-diff.png") for p in pictures]
        between = [compare(b, a) for a, b in zip(pictures[::2], pictures[1::2])]
        figures = []
        for key in "relmse", "block_relmse":
            theirs, own = [m[key] for m in to_reference], [m[key] for m in between]
            figures += [with_error(theirs), with_error(own), f"{statistics.mean(theirs) / statistics.mean(own):.2f}"]
        means = [statistics.mean(m["mean_ratio"][c] for m in to_reference) for c in range(3)]
        rows.append([name, spp, " ".join(f"{r:.4f}" for r in means), *figures])
        print("  ".join(map(str, rows[-1])), flush=True)
    print()
    heads = ["to reference", "between two of ours", "ratio"]
    print(table(["scene", "spp", "mean ratio RGB", *("relMSE " + h for h in heads), *("of 8x8 " + h for h in heads)], rows))


main()
