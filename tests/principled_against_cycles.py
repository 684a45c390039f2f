#!/usr/bin/env python3
"""Spheres of the material "principled" beside Blender's Cycles with the same parameters: the mean of each, and a table.

    tests/principled_against_cycles.py --drc build/release/drc [--spp N] [NAME ...]

Run it with a Python that has Blender's module bpy (4.2 to 4.5); without it the test is skipped: it ends with status 77.
Each sphere lies in an even grey-blue surrounding with a square lamp beside the camera. The mean over its disk must be
within 2 per cent of Cycles', beyond the noise of both, and a channel's within 3. Ends with 1 if one is not.
"""
import argparse
import os
import subprocess
import sys
import tempfile

SKIPPED = 77
SIZE = 96
WORLD = (0.3, 0.4, 0.5)
LAMP = [(1.0, 3.0, 3.5), (3.0, 1.0, 3.5), (2.2, 0.2, 4.7), (0.2, 2.2, 4.7)]
LAMP_RADIANCE = 12.0
VIEW = 1.1  # half the width of the picture; the sphere's radius is 1
MEAN_BOUND, CHANNEL_BOUND = 0.02, 0.03

GOLD = (1.0, 0.72, 0.32)
ORANGE = (0.8, 0.35, 0.1)
SPHERES = {
    "default": {},
    "orange plastic": dict(basecolor=ORANGE, roughness=0.2),
    "rough plastic": dict(basecolor=ORANGE, roughness=1.0),
    "polished plastic": dict(basecolor=ORANGE, roughness=0.0),
    "white diffuse": dict(basecolor=(1, 1, 1), specularlevel=0.0),
    "strong specular": dict(basecolor=(0.1, 0.2, 0.3), specularlevel=1.0, roughness=0.3),
    "high index": dict(basecolor=(0.1, 0.2, 0.3), ior=2.4, roughness=0.4),
    "tinted specular": dict(basecolor=(0.05, 0.05, 0.05), speculartint=(1, 0.4, 0.2), specularlevel=1.0, roughness=0.3),
    "mirror": dict(basecolor=(0.9, 0.9, 0.9), metallic=1.0, roughness=0.0),
    "gold": dict(basecolor=GOLD, metallic=1.0, roughness=0.3),
    "rough gold": dict(basecolor=GOLD, metallic=1.0, roughness=0.9),
    "edge tint": dict(basecolor=GOLD, metallic=1.0, roughness=0.4, speculartint=(0.3, 0.6, 1.0)),
    "brushed metal": dict(basecolor=(0.8, 0.8, 0.8), metallic=1.0, roughness=0.4, anisotropic=0.7),
    "half metal": dict(basecolor=GOLD, metallic=0.5, roughness=0.4),
    "clear glass": dict(basecolor=(1, 1, 1), transmission=1.0, roughness=0.0, ior=1.45),
    "green glass": dict(basecolor=(0.3, 0.8, 0.4), transmission=1.0, roughness=0.0),
    "frosted glass": dict(basecolor=(0.9, 0.95, 1), transmission=1.0, roughness=0.5),
    "very rough glass": dict(basecolor=(0.9, 0.9, 0.9), transmission=1.0, roughness=0.9),
    "half glass": dict(basecolor=(0.7, 0.8, 0.9), transmission=0.5, roughness=0.3),
    "car paint": dict(basecolor=(0.6, 0.05, 0.05), coat=1.0, coatroughness=0.03, roughness=0.5),
    "rough coat on metal": dict(basecolor=GOLD, metallic=1.0, roughness=0.5, coat=1.0, coatroughness=0.4),
    "tinted coat": dict(basecolor=(0.8, 0.8, 0.8), coat=1.0, coattint=(0.9, 0.5, 0.3), coatior=1.6),
    "velvet": dict(basecolor=(0.2, 0.05, 0.3), sheen=1.0, sheenroughness=0.5, roughness=0.8),
    "tinted sheen": dict(basecolor=(0.3, 0.3, 0.3), sheen=0.8, sheenroughness=0.3, sheentint=(1, 0.6, 0.4)),
}
SOCKETS = {
    "basecolor": "Base Color", "metallic": "Metallic", "roughness": "Roughness", "ior": "IOR",
    "specularlevel": "Specular IOR Level", "speculartint": "Specular Tint", "anisotropic": "Anisotropic",
    "anisotropicrotation": "Anisotropic Rotation", "transmission": "Transmission Weight", "coat": "Coat Weight",
    "coatroughness": "Coat Roughness", "coatior": "Coat IOR", "coattint": "Coat Tint", "sheen": "Sheen Weight",
    "sheenroughness": "Sheen Roughness", "sheentint": "Sheen Tint", "subsurface": "Subsurface Weight",
}


def numbers(values):
    return " ".join(f"{v:g}" for v in values)


def pbrt_scene(material):
    """In pbrt-v4's dialect. The mirrored axis makes pbrt's left-handed camera show what Blender's does."""
    params = "".join(f' "rgb {k}" [{numbers(v)}]' if isinstance(v, tuple) else f' "float {k}" {v:g}'
                     for k, v in material.items())
    corners = " ".join(numbers(p) for p in LAMP)
    return f"""Scale -1 1 1
LookAt 0 0 6  0 0 0  0 1 0
Camera "orthographic" "float screenwindow" [{-VIEW} {VIEW} {-VIEW} {VIEW}]
Film "rgb" "integer xresolution" {SIZE} "integer yresolution" {SIZE}
PixelFilter "box"
WorldBegin
LightSource "infinite" "rgb L" [{numbers(WORLD)}]
AttributeBegin
  AreaLightSource "diffuse" "rgb L" [{numbers([LAMP_RADIANCE] * 3)}] "bool twosided" true
  Material "diffuse" "rgb reflectance" [0 0 0]
  Shape "trianglemesh" "point3 P" [{corners}] "integer indices" [0 1 2 0 2 3]
AttributeEnd
Material "principled"{params}
Shape "sphere"
"""


class Cycles:
    def __init__(self, bpy, spp):
        self.bpy = bpy
        bpy.ops.wm.read_factory_settings(use_empty=True)
        scene = self.scene = bpy.context.scene
        scene.render.engine = "CYCLES"
        cycles = scene.cycles
        cycles.device, cycles.samples, cycles.seed = "CPU", spp, 1
        cycles.use_adaptive_sampling = cycles.use_denoising = False
        cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.blur_glossy = 0
        for bounces in ("max", "diffuse", "glossy", "transmission", "transparent_max"):
            setattr(cycles, bounces + "_bounces", 64)
        scene.render.resolution_x = scene.render.resolution_y = SIZE
        scene.render.image_settings.file_format = "OPEN_EXR"
        scene.render.image_settings.color_depth = "32"
        scene.world = bpy.data.worlds.new("world")
        scene.world.use_nodes = True
        scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = WORLD + (1,)
        camera = bpy.data.cameras.new("camera")
        camera.type, camera.ortho_scale = "ORTHO", 2 * VIEW
        self.link(camera).location = (0, 0, 6)
        scene.camera = bpy.data.objects["camera"]
        lamp = bpy.data.meshes.new("lamp")
        lamp.from_pydata(LAMP, [], [(0, 1, 2, 3)])
        shine = bpy.data.materials.new("shine")
        shine.use_nodes = True
        tree = shine.node_tree
        tree.nodes.clear()
        emission = tree.nodes.new("ShaderNodeEmission")
        emission.inputs["Strength"].default_value = LAMP_RADIANCE
        tree.links.new(emission.outputs[0], tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
        lamp.materials.append(shine)
        self.link(lamp)
        bpy.ops.mesh.primitive_uv_sphere_add(segments=256, ring_count=128)
        self.sphere = bpy.context.object
        bpy.ops.object.shade_smooth()

    def link(self, data):
        made = self.bpy.data.objects.new(data.name, data)
        self.scene.collection.objects.link(made)
        return made

    def render(self, material, path):
        made = self.bpy.data.materials.new("sphere")
        made.use_nodes = True
        inputs = made.node_tree.nodes["Principled BSDF"].inputs
        for name, value in material.items():
            inputs[SOCKETS[name]].default_value = value + (1,) if isinstance(value, tuple) else value
        self.sphere.data.materials.clear()
        self.sphere.data.materials.append(made)
        self.scene.render.filepath = path
        self.bpy.ops.render.render(write_still=True)


def disk_mean(bpy, path):
    """The mean colour over the middle nine tenths of the sphere's disk in a picture."""
    image = bpy.data.images.load(path)
    image.colorspace_settings.name = "Non-Color"
    pixels = list(image.pixels)
    bpy.data.images.remove(image)
    sums, count = [0.0] * 3, 0
    for y in range(SIZE):
        for x in range(SIZE):
            u, v = ((2 * c + 1) / SIZE * VIEW - VIEW for c in (x, y))
            if u * u + v * v > 0.95 * 0.95:
                continue
            count += 1
            for c in range(3):
                sums[c] += pixels[4 * (y * SIZE + x) + c]
    return [s / count for s in sums]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--drc", required=True, help="the program")
    parser.add_argument("--spp", type=int, default=256, help="samples of a pixel, of both renderers")
    parser.add_argument("names", nargs="*", metavar="NAME", help="spheres (default: all)")
    args = parser.parse_args()
    try:
        import bpy
    except ImportError:
        print("skipped: this Python has no bpy")
        return SKIPPED
    if not (4, 2) <= bpy.app.version[:2] <= (4, 5):
        print(f"skipped: bpy is of Blender {bpy.app.version_string}, not 4.2 to 4.5")
        return SKIPPED
    wrong = 0
    cycles = Cycles(bpy, args.spp)
    print(f"Cycles of Blender {bpy.app.version_string}, {args.spp} samples a pixel")
    print("| sphere | drc | Cycles | mean | red | green | blue |\n|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for name in args.names or SPHERES:
            scene, ours, theirs = (os.path.join(folder, f) for f in ("sphere.pbrt", "ours.exr", "theirs.exr"))
            with open(scene, "w") as f:
                f.write(pbrt_scene(SPHERES[name]))
            subprocess.run([args.drc, "render", scene, "--integrator", "path", "--spp", str(args.spp), "--max-depth", "64", "--denoise", "off", "--quiet",
                            "-o", ours], check=True, stdout=subprocess.DEVNULL)
            with open(os.devnull, "w") as quiet:
                kept = os.dup(1)
                os.dup2(quiet.fileno(), 1)  # Cycles reports its progress there
                try:
                    cycles.render(SPHERES[name], theirs)
                finally:
                    os.dup2(kept, 1)
                    os.close(kept)
            a, b = disk_mean(bpy, ours), disk_mean(bpy, theirs)
            apart = [x / y - 1 for x, y in zip(a, b)]
            mean = sum(a) / sum(b) - 1
            # A channel that has little of the light counts less.
            channels = [d * min(1, y / (sum(b) / 3)) for d, y in zip(apart, b)]
            bad = abs(mean) > MEAN_BOUND or max(map(abs, channels)) > CHANNEL_BOUND
            wrong += bad
            print(f"| {name}{' **' if bad else ''} | {sum(a) / 3:.4f} | {sum(b) / 3:.4f} | {mean:+.1%} | "
                  + " | ".join(f"{d:+.1%}" for d in apart) + " |", flush=True)
    print(f"{wrong} of {len(args.names or SPHERES)} too far apart")
    return 1 if wrong else 0


sys.exit(main())
