#!/usr/bin/env python3
"""Kills a render at random moments, lets it go on from its checkpoint, and compares the end with a render that was not killed.

    tests/kill_a_render.py DRC [SCENE] [--kills 20] [--seed 1]

A moment is anywhere from the start of the process to three seconds later: while it reads the scene, samples, or saves.
By hand, since how long it takes depends on the machine: tests/checkpoint_test.cpp has a few kills for every run.
"""
import argparse
import json
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("drc")
    parser.add_argument("scene", nargs="?", default=ROOT / "scenes" / "quickstart" / "scene.pbrt")
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--resolution", default="320x180")
    args = parser.parse_args()
    moments = random.Random(args.seed)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        state, picture = folder / "state", folder / "picture.exr"

        def command(spp, *options):
            return [args.drc, "render", str(args.scene), "--resolution", args.resolution, "--denoise", "off", "--quiet",
                    "--spp", str(spp), "-o", str(picture), *options]

        def resumed():
            return ["--resume", str(state)] if state.exists() else []

        for kill in range(args.kills):
            process = subprocess.Popen(command(1 << 20, "--checkpoint", str(state), "--every", "1s", *resumed()))
            after = moments.uniform(0, 3)
            time.sleep(after)
            if process.poll() is not None:
                sys.exit(f"the render ended by itself with {process.returncode}, {after:.2f} s after its start")
            process.send_signal(signal.SIGKILL)
            process.wait()
            saved = subprocess.run(command(1, *resumed()), check=True) and subprocess.run(
                [args.drc, "image", "info", picture], check=True, capture_output=True, text=True).stdout
            spp = int(saved.split("drc:spp = ")[1].split()[0])
            print(f"killed {kill + 1}: {after:.2f} s after its start; {spp if state.exists() else 0} spp are saved", flush=True)
        subprocess.run(command(spp + 5, *resumed()), check=True)
        picture.rename(folder / "resumed.exr")
        subprocess.run(command(spp + 5), check=True)
        difference = json.loads(subprocess.run([args.drc, "compare", "--json", picture, folder / "resumed.exr"], check=True,
                                               capture_output=True, text=True).stdout)["l1"]
        if difference != 0:
            sys.exit(f"{spp + 5} spp: the mean difference from a render that was not killed is {difference}")
        print(f"{spp + 5} spp: every pixel has the value that it has in a render that was not killed")


if __name__ == "__main__":
    main()
