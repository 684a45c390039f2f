"""Modifiers, instances, materials of parts, kinds of objects."""

import bpy

from stage import feature


@feature("modifiers: Subdivision, Bevel")
def _(s):
    s.box.modifiers.new("bevel", "BEVEL").width = 0.15
    s.box.modifiers.new("subdivision", "SUBSURF").render_levels = 3
    s.box.modifiers["subdivision"].levels = 3


@feature("instances of a collection, mirrored")
def _(s):
    collection = bpy.data.collections.new("parts")
    for o in (s.ball, s.box):
        s.scene.collection.objects.unlink(o)
        collection.objects.link(o)
    for i, scale in enumerate((0.5, 0.7, -0.6)):
        empty = s.object(f"instance{i}", None, (-1.5 + 1.5 * i, 0.3 * i, 0))
        empty.instance_type, empty.instance_collection = "COLLECTION", collection
        empty.scale = (scale, abs(scale), abs(scale))


@feature("several materials, sharp edges")
def _(s):
    s.box.data.materials.append(s.material("second", (0.9, 0.8, 0.1)))
    for i, face in enumerate(s.box.data.polygons):
        face.material_index, face.use_smooth = i % 2, True
    for i, edge in enumerate(s.box.data.edges):
        edge.use_edge_sharp = i % 3 != 0


@feature("text and curve")
def _(s):
    text = bpy.data.curves.new("text", "FONT")
    text.body, text.extrude, text.size = "DRC", 0.1, 0.8
    made = s.object("text", text, (-0.6, -1.4, 0.05))
    made.rotation_euler = (1.2, 0, 0.3)
    text.materials.append(s.material("text", (0.8, 0.6, 0.1)))


@feature("hidden objects")
def _(s):
    s.box.hide_render = True
