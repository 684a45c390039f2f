#!/usr/bin/env python3
"""The picture of the documentation: the three rooms, above by DRC, below by Cycles, in the same time.

    python3 integrations/blender/tests/rooms_beside_cycles.py --drc build/release/drc [--seconds 20] PICTURE.jpg

Both denoise with Open Image Denoise, which takes DRC a part of its time and Cycles more time after it; both trace paths of
12 bounces at most. Needs Blender's module bpy.
"""

import argparse
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
import bpy
import numpy as np

from compare_with_cycles import quietly, read, set_up_cycles
from drc_blender.export.scene import SceneExporter, Settings
from scenes import FEATURES

ROOMS = ("room by day", "room in the evening", "bathroom")
WIDTH, HEIGHT, GAP = 420, 315, 6
BOUNCES = 12
MIDDLE = 0.35  # what the median of Cycles' picture becomes, before the curve
WHITE = 4.0  # what becomes white


def by_cycles(scene, seconds, folder):
    set_up_cycles(scene, 65536)
    cycles = scene.cycles
    cycles.max_bounces, cycles.time_limit, cycles.use_denoising = BOUNCES, seconds, True
    cycles.pixel_filter_type = "BLACKMAN_HARRIS"
    scene.render.filepath = os.path.join(folder, "cycles.exr")
    quietly(lambda: bpy.ops.render.render(write_still=True))
    return read(scene.render.filepath)


def by_drc(drc, seconds, folder):
    exporter = SceneExporter(os.path.join(folder, "scene"), Settings(max_depth=BOUNCES))
    made = exporter.export(bpy.context.evaluated_depsgraph_get())
    path = os.path.join(folder, "drc.exr")
    subprocess.run([drc, "render", made.path, "--time", str(seconds), "-o", path, "--quiet"], check=True)
    return read(path)


def displayed(linear, scale):
    """By Reinhard's curve with a white, and sRGB."""
    x = linear * scale
    x = np.clip(x * (1 + x / WHITE**2) / (1 + x), 0, 1)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * np.maximum(x, 1e-6) ** (1 / 2.4) - 0.055)


def save(picture, path):
    """height x width x 3, from the top, as it is displayed."""
    height, width = picture.shape[:2]
    image = bpy.data.images.new("rooms", width, height)
    image.colorspace_settings.name = "sRGB"
    opaque = np.concatenate([picture[::-1], np.ones((height, width, 1))], axis=-1)
    image.pixels.foreach_set(opaque.astype(np.float32).ravel())
    image.filepath_raw, image.file_format = path, "JPEG"
    image.save(quality=88)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--drc", required=True, help="the program")
    parser.add_argument("--seconds", type=int, default=20, help="for each picture")
    parser.add_argument("picture", help="the JPEG file to write")
    args = parser.parse_args()
    above, below = [], []
    for name in ROOMS:
        scene = FEATURES[name]["build"]().scene
        scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
        with tempfile.TemporaryDirectory() as folder:
            theirs = by_cycles(scene, args.seconds, folder)
            ours = by_drc(os.path.abspath(args.drc), args.seconds, folder)
        scale = MIDDLE / np.median(theirs.mean(axis=2))
        above.append(displayed(ours, scale))
        below.append(displayed(theirs, scale))
    rows = []
    for row in (above, below):
        gap = np.ones((HEIGHT, GAP, 3))
        rows.append(np.concatenate([row[0], gap, row[1], gap, row[2]], axis=1))
    save(np.concatenate([rows[0], np.ones((GAP, *rows[0].shape[1:])), rows[1]]), os.path.abspath(args.picture))


if __name__ == "__main__":
    main()
    sys.stdout.flush()
    os._exit(0)  # bpy 4.5 does not end by itself
