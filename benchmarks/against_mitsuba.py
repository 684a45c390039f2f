#!/usr/bin/env python3
"""Camera samples per second of our path tracer and of Mitsuba 3's, in turns within one run.

    benchmarks/against_mitsuba.py --scene cornell-box/scene.pbrt --spp 256 --resolution 256x256 --rounds 5

The scene is the Cornell box of Bitterli's collection: ours reads the pbrt-v3 file, Mitsuba gets the same scene as it is
written by hand below. All have the same number of threads and samples, the same filter, longest path and roulette,
and no clamping. Needs mitsuba in the Python that runs this and, for llvm_ad_rgb, LLVM's shared library; if it is not
found, or too old a one is, DRJIT_LIBLLVM_PATH says which to take.

Prints a Markdown table of medians, in millions of camera samples per second. "Render" is what each program measures
itself, without loading and writing; "process" is from start to end, for Mitsuba with Python. LLVM compiles its kernel
at the first picture, with an empty cache; a second picture in the same process is without that. "Cores had" is the
processor time of the process per second: if it is well below the number of threads, something else was running. "Per
core" is by the process's processor time, and the only figure to trust then. Ratios are medians of those of the rounds.

Pictures are compared with ours of the first round; our own row compares another seed's, which says what noise alone
makes of it. If the means do not agree, neither do the scenes, and the speeds mean nothing.

What differs: our samples are Owen-scrambled Sobol points, which cost more than Mitsuba's independent ones. We choose
each sample's place by the filter and count it in one pixel; Mitsuba adds each to every pixel that the filter reaches,
which costs more, lowers the noise of single pixels and makes neighbours' alike. All compute in single precision, but
our pixels' sums are in double, and all trace rays with Embree. llvm_ad_rgb follows as many paths at a time as vectors
are wide, the others one.
"""
import argparse
import json
import os
import site
import statistics
import subprocess
import sys
import tempfile
import time

import common

ROULETTE_DEPTH = 3  # of our path tracer, which has no option for it
TOLERANCE = 0.005   # of a channel's mean

# Colours, and quads by their corners, counter-clockwise as seen from the side that matters.
GREY, RED, GREEN, BLACK = [0.725, 0.71, 0.68], [0.63, 0.065, 0.05], [0.14, 0.45, 0.091], [0, 0, 0]
RADIANCE = [17, 12, 4]


def box(height, corners):
    """The six sides of a box on the floor, from the (x, z) of its corners."""
    low, high = [(x, 0, z) for x, z in corners], [(x, height, z) for x, z in corners]
    sides = [(low[i - 1], low[i], high[i], high[i - 1]) for i in range(4)]
    return [high, low[::-1]] + sides


SHAPES = {
    "floor": (GREY, [[(-1, 0, -1), (-1, 0, 1), (1, 0, 1), (1, 0, -1)]]),
    "ceiling": (GREY, [[(1, 2, 1), (-1, 2, 1), (-1, 2, -1), (1, 2, -1)]]),
    "back": (GREY, [[(-1, 0, -1), (1, 0, -1), (1, 2, -1), (-1, 2, -1)]]),
    "right": (GREEN, [[(1, 0, -1), (1, 0, 1), (1, 2, 1), (1, 2, -1)]]),
    "left": (RED, [[(-1, 0, 1), (-1, 0, -1), (-1, 2, -1), (-1, 2, 1)]]),
    "short": (GREY, box(0.6, [(-0.04607531, 0.5730067), (0.5330087, 0.7460793),
                              (0.7033373, 0.1761773), (0.1242533, 0.0031047)])),
    "tall": (GREY, box(1.2, [(-0.720444, -0.4738826), (-0.523986, 0.0906494),
                             (0.049566, -0.1089474), (-0.146892, -0.6734794)])),
    "light": (BLACK, [[(-0.24, 1.98, -0.22), (0.23, 1.98, -0.22), (0.23, 1.98, 0.16), (-0.24, 1.98, 0.16)]]),
}


def mitsuba_scene(mi, folder, width, height, depth):
    """The scene as a dict. Meshes, which Embree knows itself, are faster than Mitsuba's rectangles."""
    scene = {
        "type": "scene",
        # Mitsuba counts the segments of a path, we count bounces.
        "integrator": {"type": "path", "max_depth": depth + 1, "rr_depth": ROULETTE_DEPTH, "hide_emitters": False},
        "sensor": {
            "type": "perspective", "fov": 19.5, "fov_axis": "smaller",
            "to_world": mi.ScalarTransform4f().look_at(origin=[0, 1, 6.8], target=[0, 1, 0], up=[0, 1, 0]),
            "sampler": {"type": "independent"},
            "film": {"type": "hdrfilm", "width": width, "height": height, "pixel_format": "rgb",
                     "component_format": "float32", "rfilter": {"type": "tent", "radius": 1.0}},
        },
    }
    for name, (colour, quads) in SHAPES.items():
        path = os.path.join(folder, name + ".ply")
        with open(path, "w") as f:
            f.write(f"ply\nformat ascii 1.0\nelement vertex {4 * len(quads)}\nproperty float x\nproperty float y\n"
                    f"property float z\nelement face {2 * len(quads)}\nproperty list uchar int vertex_indices\n"
                    "end_header\n")
            f.writelines(f"{x} {y} {z}\n" for quad in quads for x, y, z in quad)
            f.writelines(f"3 {i} {i + 1} {i + 2}\n3 {i} {i + 2} {i + 3}\n" for i in range(0, 4 * len(quads), 4))
        scene[name] = {"type": "ply", "filename": path, "face_normals": True,
                       "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": colour}}}
    scene["light"]["emitter"] = {"type": "area", "radiance": {"type": "rgb", "value": RADIANCE}}
    return scene


def mitsuba_process(args):
    """What the process of one variant does: one picture, or two if it compiles; prints wall and processor seconds."""
    import drjit as dr
    import mitsuba as mi
    mi.set_variant(args.variant)
    dr.set_thread_count(args.threads)
    width, height = map(int, args.resolution.split("x"))
    with tempfile.TemporaryDirectory() as folder:
        scene = mi.load_dict(mitsuba_scene(mi, folder, width, height, args.depth))
    seconds = []
    for i in range(2 if "llvm" in args.variant else 1):
        wall, cpu = time.monotonic(), time.process_time()
        scene.integrator().render(scene, seed=2 * args.seed + i, spp=args.spp, evaluate=True)
        dr.sync_thread()
        seconds.append((time.monotonic() - wall, time.process_time() - cpu))
    scene.sensors()[0].film().bitmap().write(args.output)
    print(json.dumps(seconds))


def timed(command, environment=None):
    """Runs a command: its output (none if it failed), its wall-clock seconds and its processor seconds."""
    before = os.times()
    done = subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, text=True, env=environment)
    after = os.times()
    cpu = after.children_user + after.children_system - before.children_user - before.children_system
    return done.stdout if done.returncode == 0 else None, after.elapsed - before.elapsed, cpu


def run_ours(args, seed, picture):
    """By name: seconds of rendering, of the whole process, and its processor seconds."""
    out, process, cpu = timed([args.drc, "render", args.scene, "-o", picture, "--integrator", "path", "--seed", seed,
                               "--spp", args.spp, "--resolution", args.resolution, "--max-depth", args.depth,
                               "--nthreads", args.threads, "--denoise", "off", "--quiet", "--stats"])
    if out is None:
        sys.exit(f"{args.drc} failed")
    (line,) = [line for line in out.splitlines() if line.startswith("path samples")]
    return {"drc path": (float(line.split()[2]), process, cpu)}


def run_mitsuba(args, variant, seed, picture):
    # A home of its own, where compiled kernels are kept from one run to the next; packages stay where they are.
    with tempfile.TemporaryDirectory() as home:
        environment = dict(os.environ, HOME=home, DRJIT_CACHE_DIR=home, PYTHONUSERBASE=site.getuserbase())
        out, process, cpu = timed([sys.executable, os.path.abspath(__file__), "--variant", variant, "--seed", seed,
                                   "--spp", args.spp, "--resolution", args.resolution, "--depth", args.depth,
                                   "--threads", args.threads, "--output", picture, "--scene", args.scene], environment)
    if out is None:
        hint = ("; it needs LLVM's shared library, for Mitsuba 3.9 a later one than 16 (Debian 12 has "
                "libllvm19): DRJIT_LIBLLVM_PATH says which to take")
        sys.exit(f"Mitsuba's {variant} failed" + (hint if "llvm" in variant else ""))
    seconds = json.loads(out.splitlines()[-1])
    if len(seconds) == 1:
        return {variant: (seconds[0][0], process, cpu)}
    first, second = seconds
    return {f"{variant}, compiled before": (second[0], process - first[0], cpu - first[1]),
            f"{variant}, with compiling": (first[0], process - second[0], cpu - second[1])}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scene", required=True, help="cornell-box/scene.pbrt")
    parser.add_argument("--spp", type=int, default=256)
    parser.add_argument("--resolution", default="256x256")
    parser.add_argument("--depth", type=int, default=64, help="longest path, in bounces")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--drc", default=common.DRC, help="our program")
    parser.add_argument("--output", default="out/against_mitsuba", help="folder for the pictures")
    parser.add_argument("--variant", help=argparse.SUPPRESS)  # how this script runs itself
    parser.add_argument("--seed", type=int, default=0, help=argparse.SUPPRESS)
    args = parser.parse_args()
    try:
        import mitsuba
    except ImportError as error:
        sys.exit(f"mitsuba cannot be imported ({error}): pip install mitsuba, and run this with the same Python")
    if args.variant:
        return mitsuba_process(args)

    common.DRC = args.drc
    os.makedirs(args.output, exist_ok=True)
    runs, picture_of = {}, {}
    for i in range(1, args.rounds + 1):
        for program in ["drc", "scalar_rgb", "llvm_ad_rgb"]:
            picture = os.path.join(args.output, f"{program}-{i}.exr")
            done = run_ours(args, i, picture) if program == "drc" else run_mitsuba(args, program, i, picture)
            for name, values in done.items():
                runs.setdefault(name, []).append(values)
                picture_of[name] = picture
                print(f"round {i}  {name}: render {values[0]:.2f} s, process {values[1]:.2f} s", flush=True)

    width, height = map(int, args.resolution.split("x"))
    samples = width * height * args.spp
    reference = os.path.join(args.output, "drc-1.exr")
    rows, apart = [], []
    for name, values in runs.items():
        cells = []
        for column in range(3):
            rates = [samples / v[column] / 1e6 for v in values]
            cells.append([f"{statistics.median(rates):.3f}", f"{min(rates):.3f} to {max(rates):.3f}",
                          f"{statistics.median(o[column] / v[column] for o, v in zip(runs['drc path'], values)):.2f}"])
        (render, span, to_render), (process, _, to_process), (core, _, to_core) = cells
        cores = statistics.median(cpu / process for _, process, cpu in values)
        ratios, relmse = "-", "-"
        if picture_of[name] != reference:
            m = common.compare(reference, picture_of[name], "--diff", picture_of[name][:-4] + "-diff.png")
            ratios, relmse = " ".join(f"{r:.4f}" for r in m["mean_ratio"]), f"{m['relmse']:.5f}"
            if not all(abs(r - 1) <= TOLERANCE for r in m["mean_ratio"]):
                apart.append(name)
        rows.append([name, render, span, to_render, process, to_process, f"{cores:.2f}", core, to_core, ratios, relmse])
    print(f"\nMitsuba {mitsuba.__version__}; {args.resolution}, {args.spp} spp, depth {args.depth}, "
          f"{args.threads} threads, {args.rounds} rounds; millions of camera samples per second\n")
    print(common.table(["path tracer", "render", "of the rounds", "to ours", "process", "to ours", "cores had",
                        "per core", "to ours", "mean ratio RGB", "relMSE to ours"], rows))
    if apart:
        sys.exit(f"\nMeans differ from ours by more than {TOLERANCE:.1%}, so not the same scene: {', '.join(apart)}")


main()
