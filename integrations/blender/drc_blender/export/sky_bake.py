"""Renders the sky of a Sky Texture with Cycles: a program of its own, which the exporter starts.

    blender --background --factory-startup --python sky_bake.py -- SETTINGS.json SKY.npy SUN.npy
    python sky_bake.py SETTINGS.json SKY.npy SUN.npy            (with Blender's module bpy)

SKY: all directions by longitude and latitude, without the sun's disk. SUN: a part of the sky around the middle of the disk,
if there is one. Both are linear RGBA, with rows from the bottom.
"""

import json
import math
import os
import sys


def main(settings_file, sky_file, sun_file):
    import bpy
    import numpy as np

    bpy.ops.wm.read_factory_settings(use_empty=True)
    with open(settings_file, encoding="utf-8") as f:
        settings = json.load(f)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.pixel_filter_type = "CPU", "BOX"
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"
    scene.view_settings.view_transform = "Raw"
    world = scene.world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    sky = world.node_tree.nodes.new("ShaderNodeTexSky")
    for name, value in settings["node"].items():
        if hasattr(sky, name):
            setattr(sky, name, value)
    world.node_tree.links.new(sky.outputs[0], world.node_tree.nodes["Background"].inputs["Color"])
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    scene.camera = camera
    camera.data.type = "PANO"
    panorama = camera.data if hasattr(camera.data, "panorama_type") else camera.data.cycles

    def render(width, height, samples, path):
        scene.render.resolution_x, scene.render.resolution_y = width, height
        scene.cycles.samples = samples
        scene.render.filepath = path + ".exr"
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(scene.render.filepath)
        image.colorspace_settings.name = "Non-Color"
        values = np.empty(width * height * image.channels, dtype=np.float32)
        image.pixels.foreach_get(values)
        np.save(path, values.reshape(height, width, image.channels))

    panorama.panorama_type = "EQUIRECTANGULAR"
    camera.rotation_euler = (math.pi / 2, 0, -math.pi / 2)  # its middle looks along +x, as that of environment images
    disc = settings["node"].get("sun_disc", False)
    if disc:
        sky.sun_disc = False
    render(settings["width"], settings["width"] // 2, 4, sky_file)
    if disc:
        sky.sun_disc = True
        # An equidistant fisheye with the sun in its middle.
        panorama.panorama_type = "FISHEYE_EQUIDISTANT"
        panorama.fisheye_fov = settings["sun_view"]
        from mathutils import Vector

        camera.rotation_euler = Vector(settings["sun"]).to_track_quat("-Z", "Y").to_euler()
        render(1024, 1024, 4, sun_file)


if __name__ == "__main__":
    arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else sys.argv[1:]
    main(*arguments)
    sys.stdout.flush()
    os._exit(0)  # the module of Blender 4.5 does not end by itself
