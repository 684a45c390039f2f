#!/usr/bin/env python3
"""The path tracer, or another integrator, against pbrt-v3, feature by feature of the scene format.

    tests/features_against_references.py SCENES REFERENCES

SCENES is a folder of small scenes, one for each feature, REFERENCES a folder of pictures of the same names that another
renderer made (path tracing, maxdepth 20). Renders all and prints for each the mean ratio (ours / reference) of each
channel, the relMSE of the means of 8x8 pixels, and whether both are within their limits. Where a folder is missing
there is nothing to compare: one line says so, and the status is 77 (skipped).

Pictures with caustics are noisy, references too, and have a wider limit. That more of our samples converge on one answer,
and that it is theirs, `--spp 4096 --seeds 2` shows for the scenes that --only names: the relMSE of blocks between our
two pictures (`own`) falls in proportion to 1/spp, that between ours and the reference to the reference's own noise.

Needs Python's standard library and a built drc (DRC=PATH says where, if not in build/release).
"""
import argparse
import glob
import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "benchmarks"))

from common import compare, render, resolution, table  # noqa: E402

SKIPPED = 77
MEAN_LIMIT = 0.015
BLOCK_LIMIT, CAUSTIC_BLOCK_LIMIT = 5e-3, 2e-2
CAUSTICS = ("glass", "mirror", "opacity", "transmission", "translucent", "metal")

# Intended deviations, explained in docs/decisions/: names of scenes, or prefixes of names.
DELIBERATE = {
    "texture-marble": "pbrt-v3's marble reflects up to 40 times what it receives: its picture diverges",
}


def limits(name):
    caustic = any(word in name for word in CAUSTICS)
    return MEAN_LIMIT, CAUSTIC_BLOCK_LIMIT if caustic else BLOCK_LIMIT


def within(name, comparison):
    """Whether the means and block means of a comparison are within the limits for its scene."""
    mean_limit, block_limit = limits(name)
    # NaN (from a black reference, for example) counts as outside the limits.
    return (all(r is not None and abs(r - 1) <= mean_limit for r in comparison["mean_ratio"])
            and comparison["block_relmse"] is not None and comparison["block_relmse"] <= block_limit)


def verdict(name, comparisons):
    if all(within(name, c) for c in comparisons):
        return "pass"
    for start, reason in DELIBERATE.items():
        if name.startswith(start):
            return "deliberate: " + reason
    return "FAIL"


def scenes_with_references(args):
    """Pairs of a scene and its reference; None, after printing the reason, if there is nothing to compare."""
    for what, folder in (("scenes", args.scenes), ("references", args.references)):
        if not os.path.isdir(folder):
            print(f"skipped: no folder of {what} at {folder}")
            return None
    pairs = []
    for scene in sorted(glob.glob(os.path.join(args.scenes, "*.pbrt"))):
        name = os.path.splitext(os.path.basename(scene))[0]
        reference = os.path.join(args.references, name + ".exr")
        if args.only and not any(word in name for word in args.only.split(",")):
            continue
        if os.path.exists(reference):
            pairs.append((name, scene, reference))
        else:
            print(f"{name}: no reference {reference}", file=sys.stderr)
    if not pairs:
        print(f"skipped: no scene in {args.scenes} has a reference in {args.references}")
        return None
    return pairs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", help="folder of scenes NAME.pbrt")
    parser.add_argument("references", help="folder of reference pictures NAME.exr")
    parser.add_argument("--spp", type=int, default=256)
    parser.add_argument("--integrator", default="path", choices=("path", "bdpt", "drc", "drc-maps"))
    parser.add_argument("--seeds", type=int, default=1, help="pictures per scene; with two, their difference is printed")
    parser.add_argument("--only", help="comma-separated words; only scenes whose name contains one of them")
    parser.add_argument("--output", default="out/features", help="folder for pictures and difference images")
    parser.add_argument("--resume", action="store_true", help="reuse the pictures that are already in --output")
    parser.add_argument("--nthreads", type=int, default=0, help="threads; 0: one per core")
    args = parser.parse_args()
    pairs = scenes_with_references(args)
    if pairs is None:
        sys.exit(SKIPPED)
    os.makedirs(args.output, exist_ok=True)
    rows, failed = [], 0
    for name, scene, reference in pairs:
        pictures = []
        for seed in range(1, args.seeds + 1):
            picture = os.path.join(args.output, f"{name}-{args.integrator}-{args.spp}-{seed}.exr")
            if not (args.resume and os.path.exists(picture)):
                render(scene, picture, "--integrator", args.integrator, "--spp", args.spp, "--seed", seed, "--resolution",
                       resolution(reference), "--nthreads", args.nthreads, "--denoise", "off")
            pictures.append(picture)
        comparisons = [compare(reference, p, "--diff", p[:-4] + "-diff.png") for p in pictures]
        own = compare(pictures[0], pictures[1])["block_relmse"] if len(pictures) > 1 else None
        result = verdict(name, comparisons)
        failed += result == "FAIL"
        for seed, c in enumerate(comparisons, 1):
            rows.append([name if seed == 1 else f"  seed {seed}",
                         " ".join("-" if r is None else f"{r:.4f}" for r in c["mean_ratio"]),
                         f"{c['block_relmse'] or 0:.6f}", "" if own is None else f"{own:.6f}", limits(name)[1],
                         result if seed == 1 else ""])
            print("  ".join(map(str, rows[-1])), flush=True)
    print()
    print(table(["scene", "mean ratio RGB", "block relMSE", "own", "limit", "result"], rows))
    print(f"\n{len(pairs) - failed} of {len(pairs)} scenes within their limits or different on purpose")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
