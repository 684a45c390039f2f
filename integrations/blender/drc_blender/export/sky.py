"""Sky textures as pictures, which a second Blender renders; kept by their settings."""

import json
import math
import os
import subprocess
import sys
import tempfile

import numpy as np

from ..materials.image_lookup import Pixels
from .cache import digest

WIDTH = 2048
PATIENCE = 300  # seconds
_baked = {}


def settings_of(node):
    """What decides how the sky looks; sun: the direction of the sun's middle, where there is a disk."""
    names = [
        p.identifier
        for p in node.bl_rna.properties
        if p.identifier.startswith(("sun_", "air_", "dust_", "ozone_", "aerosol_"))
        or p.identifier in ("sky_type", "altitude", "turbidity", "ground_albedo", "sun_direction")
    ]
    values = {}
    for name in sorted(names):
        value = getattr(node, name)
        values[name] = list(value) if hasattr(value, "__len__") and not isinstance(value, str) else value
    if node.sky_type in ("PREETHAM", "HOSEK_WILKIE"):
        values["sun_disc"] = False
    up, turn = values.get("sun_elevation", 0.0), values.get("sun_rotation", 0.0)
    # Blender turns the sun clockwise from +y.
    sun = [math.cos(up) * math.sin(turn), math.cos(up) * math.cos(turn), math.sin(up)]
    # sun_view: the angle of the picture of the sun, which is 10 degrees at least.
    return {
        "node": values,
        "sun": sun,
        "sun_view": max(math.radians(10), 1.2 * values.get("sun_size", 0.0)),
        "width": WIDTH,
    }


class Sky:
    """pixels: by longitude and latitude, without the sun; sun_radiance: mean over the sun's disk, or None."""

    def __init__(self, pixels, sun_direction, sun_angle, sun_radiance):
        self.pixels = pixels
        self.sun_direction, self.sun_angle, self.sun_radiance = sun_direction, sun_angle, sun_radiance


def bake(node):
    """Raises OSError or RuntimeError, with one line, if the second Blender fails."""
    settings = settings_of(node)
    key = digest(json.dumps(settings, sort_keys=True))
    if key not in _baked:
        _baked[key] = _bake(settings)
    return _baked[key]


def _bake(settings):
    import bpy

    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "sky_bake.py")
    with tempfile.TemporaryDirectory() as folder:
        files = [os.path.join(folder, name) for name in ("settings.json", "sky.npy", "sun.npy")]
        with open(files[0], "w", encoding="utf-8") as f:
            json.dump(settings, f)
        if bpy.app.binary_path:
            command = [bpy.app.binary_path, "--background", "--factory-startup", "--python", script, "--", *files]
        else:
            command = [sys.executable, script, *files]
        done = subprocess.run(
            command, capture_output=True, text=True, errors="replace", timeout=PATIENCE, stdin=subprocess.DEVNULL
        )
        if not os.path.exists(files[1]):
            said = [line for line in (done.stderr + done.stdout).splitlines() if line.strip()]
            raise RuntimeError("the sky could not be rendered: " + (said[-1] if said else f"status {done.returncode}"))
        sky = np.load(files[1])
        values = settings["node"]
        radiance = None
        if values.get("sun_disc") and os.path.exists(files[2]):
            radiance = _disk_mean(np.load(files[2])[..., :3], settings["sun_view"], values["sun_size"])
        return Sky(Pixels(sky, False), np.array(settings["sun"]), values.get("sun_size", 0.0), radiance)


def _disk_mean(picture, fov, angle):
    """Radiance that, over the disk alone, is what the disk adds to the sky around it."""
    side = picture.shape[0]
    centre = ((np.arange(side) + 0.5) / side - 0.5) * fov
    distance = np.hypot(*np.meshgrid(centre, centre))
    ring = (distance > 0.52 * angle) & (distance < fov / 2)
    background = np.median(picture[ring], axis=0) if ring.any() else np.zeros(3)
    near = distance < 0.52 * angle
    pixel = (fov / side) ** 2
    added = ((picture[near] - background).sum(axis=0)) * pixel
    return np.maximum(added / (math.pi * (angle / 2) ** 2), 0)
