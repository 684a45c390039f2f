#!/usr/bin/env python3
"""What a camera sample costs, and how noisy it is, as a room's lamps become more.

    benchmarks/many_lights.py --spp 16 --counts 10,100,1000,10000

A hall, seen from under its lamps, is lit by so many small triangles under its ceiling, of random sizes and colours, all together always as strong:
each an area light of its own, or all one mesh that emits. Prints a Markdown table: nanoseconds a camera sample by the
render's own clock, the same as a ratio to the first count's, and the relMSE to a picture of many samples.
"""
import argparse
import os
import random
import subprocess
import tempfile

from common import DRC, compare, table

HALL = [((-8, -8, 0), (8, -8, 0), (8, 8, 0), (-8, 8, 0)), ((-8, -8, 4), (-8, 8, 4), (8, 8, 4), (8, -8, 4)),
        ((-8, 8, 0), (8, 8, 0), (8, 8, 4), (-8, 8, 4)), ((-8, -8, 0), (-8, -8, 4), (8, -8, 4), (8, -8, 0)),
        ((-8, -8, 0), (-8, 8, 0), (-8, 8, 4), (-8, -8, 4)), ((8, -8, 0), (8, -8, 4), (8, 8, 4), (8, 8, 0))]


def mesh(points, indices):
    return (f'Shape "trianglemesh" "point P" [{" ".join(f"{x:.5g}" for p in points for x in p)}] '
            f'"integer indices" [{" ".join(map(str, indices))}]\n')


def hall(count, as_mesh):
    rng = random.Random(1)
    text = ('LookAt 0 -7.8 3  0 0 0.5  0 0 1\nCamera "perspective" "float fov" 32\n'
            'Film "image" "integer xresolution" 240 "integer yresolution" 135\nWorldBegin\n'
            'Material "matte" "rgb Kd" [.6 .6 .6]\n')
    text += "".join(mesh(wall, [0, 1, 2, 0, 2, 3]) for wall in HALL)
    for _ in range(40):
        x, y, h, r = rng.uniform(-7, 7), rng.uniform(-5, 7), rng.uniform(.3, 2.5), rng.uniform(.2, .8)
        top = [(x - r, y - r, h), (x + r, y - r, h), (x + r, y + r, h), (x - r, y + r, h)]
        text += mesh(top + [(a, b, 0) for a, b, _ in top], [0, 1, 2, 0, 2, 3] + [
            k for i in range(4) for k in (i, i + 4, (i + 1) % 4, (i + 1) % 4, i + 4, (i + 1) % 4 + 4)])
    triangles = []
    for _ in range(count):
        x, y, z = rng.uniform(-7.9, 7.9), rng.uniform(-7.9, 7.9), rng.uniform(3.2, 3.95)
        s = rng.uniform(.5, 2) * .5 / count ** .5
        triangles.append(([(x, y + s, z), (x + s, y - s, z), (x - s, y - s, z)], [rng.uniform(.3, 1) for _ in range(3)]))
    if as_mesh:
        points = [p for t, _ in triangles for p in t]
        return (text + 'AreaLightSource "diffuse" "rgb L" [65 65 65]\nMaterial "matte" "rgb Kd" [0 0 0]\n' +
                mesh(points, range(len(points))) + "WorldEnd\n")
    for t, c in triangles:
        text += ('AttributeBegin\nAreaLightSource "diffuse" "rgb L" [' + " ".join(f"{100 * x:.4g}" for x in c) +
                 ']\nMaterial "matte" "rgb Kd" [0 0 0]\n' + mesh(t, [0, 1, 2]) + "AttributeEnd\n")
    return text + "WorldEnd\n"


def render(scene, picture, spp, seed, threads):
    """The seconds of all threads that the samples took."""
    out = subprocess.run([DRC, "render", scene, "-o", picture, "--integrator", "path", "--spp", str(spp), "--seed",
                          str(seed), "--nthreads", str(threads), "--denoise", "off", "--quiet", "--stats"], check=True,
                         capture_output=True, text=True).stdout
    (line,) = [line for line in out.splitlines() if line.startswith("path samples")]
    return float(line.split()[2]) * threads


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--counts", default="10,100,1000,10000")
    parser.add_argument("--spp", type=int, default=16)
    parser.add_argument("--reference-spp", type=int, default=1024)
    parser.add_argument("--rounds", type=int, default=3, help="of which the fastest counts")
    parser.add_argument("--threads", type=int, default=2)
    args = parser.parse_args()
    rows = []
    for kind in "lights", "mesh":
        first = None
        for count in map(int, args.counts.split(",")):
            with tempfile.TemporaryDirectory() as folder:
                scene, picture, reference = (os.path.join(folder, f) for f in ("hall.pbrt", "hall.exr", "reference.exr"))
                with open(scene, "w") as f:
                    f.write(hall(count, kind == "mesh"))
                render(scene, reference, args.reference_spp, 2, args.threads)
                seconds = min(render(scene, picture, args.spp, 1, args.threads) for _ in range(args.rounds))
                nanoseconds = 1e9 * seconds / (240 * 135 * args.spp)
                first = first or nanoseconds
                rows.append([f"{count} {'lights' if kind == 'lights' else 'triangles of a light'}", f"{nanoseconds:.0f}",
                             f"{nanoseconds / first:.2f}", f"{compare(reference, picture)['relmse']:.5f}"])
            print("  ".join(rows[-1]), flush=True)
    print()
    print(table(["hall lit by", "ns a camera sample", "to the first", "relMSE"], rows))


main()
