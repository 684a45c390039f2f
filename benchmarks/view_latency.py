#!/usr/bin/env python3
"""How soon `drc view` shows something: from its start, and after its camera has moved.

    benchmarks/view_latency.py --drc build/release/drc SCENE...

For each scene, at 1280x720: the seconds from the start of the program to the first frame, of which so many were spent
reading the scene; from the beginning of the render to the first frame and to the first one with a sample in every
pixel; and the milliseconds from a movement of the camera to its first frame at 640x360, the median and the worst of 20,
as the page sees them: with the request, the event and the picture's transfer.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import time
import urllib.request


def get(url, data=None):
    with urllib.request.urlopen(url, data=data, timeout=120) as response:
        return response.read()


def state(url):
    return json.loads(get(url + "state"))


def wait(url, condition):
    while not condition(now := state(url)):
        time.sleep(0.002)
    return now


def measure(drc, scene):
    start = time.monotonic()
    process = subprocess.Popen([drc, "view", scene, "--resolution", "1280x720"], stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, text=True)
    url = process.stdout.readline().strip()
    reading = time.monotonic() - start
    try:
        first = wait(url, lambda s: "number" in s)
        shown = time.monotonic() - start
        whole = wait(url, lambda s: s.get("samples", 0) > 0)
        # While it refines, as a user would.
        time.sleep(3)
        home, delays = first["home"], []
        for i in range(20):
            # A small step around what the camera looks at.
            turned = [home["eye"][k] + 0.02 * (i % 5 - 2) * (home["look"][(k + 1) % 3] - home["eye"][(k + 1) % 3])
                      for k in range(3)]
            before = state(url)["view"]
            moved = time.monotonic()
            get(url + "camera", json.dumps({**home, "eye": turned, "width": 640, "height": 360, "moving": True}).encode())
            wait(url, lambda s: s.get("view", 0) > before)
            get(url + "frame?layer=beauty")
            delays.append(1000 * (time.monotonic() - moved))
            time.sleep(0.1)
        return reading, shown, first["seconds"], whole["seconds"], statistics.median(delays), max(delays)
    finally:
        process.terminate()
        process.wait()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--drc", default="build/release/drc")
    parser.add_argument("scenes", nargs="+", type=pathlib.Path)
    args = parser.parse_args()
    print("| scene | program to first frame, s | of which reading, s | render to first frame, s | to 1 spp, s | "
          "moved to frame, median, ms | worst, ms |")
    print("|---|---|---|---|---|---|---|")
    for scene in args.scenes:
        reading, shown, first, whole, median, worst = measure(args.drc, scene)
        name = scene.parent.name if scene.stem == "scene" else scene.stem
        print(f"| {name} | {shown:.2f} | {reading:.2f} | {first:.2f} | {whole:.2f} | {median:.0f} | {worst:.0f} |", flush=True)


if __name__ == "__main__":
    main()
