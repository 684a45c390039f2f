"""A sheet of textures that Cycles and the add-on evaluate at the same points.

Each texture is shone by a tile of a sheet that an orthographic camera sees; Cycles renders the sheet with a sample a
pixel, and once more the coordinates of the same samples, at which the add-on then evaluates the same nodes.
"""

import os
import tempfile

import bpy
import numpy as np

from compare_with_cycles import quietly, read, set_up_cycles
from drc_blender.export.report import Report
from drc_blender.materials.node_links import Socket
from drc_blender.materials.points import Points
from drc_blender.materials.reader import Reader
from stage import Stage

TILE = 24  # pixels of its side
SHIFT, SCALE = 2.0, 0.25  # what is shone is the texture's value by this scale and shift: light is not negative


class Sheet:
    """Tiles of unit size, each with a texture of its own. report: of what was read for the comparison."""

    def __init__(self):
        self.stage = Stage(lit=False)
        for thing in list(self.stage.scene.objects):
            bpy.data.objects.remove(thing)
        self.names, self.outputs, self.materials = [], [], []
        self.report = Report()

    def add(self, name, kind, settings=(), output=None, **inputs):
        """A tile of a texture node. output: its name or number, else the first that is enabled. inputs: values, or functions
        of the stage, the material and its output of positions that make nodes and return an output."""
        material = self.stage.material(name)
        position = self.stage.node(material, "NewGeometry").outputs["Position"]
        node = self.stage.node(material, kind, settings)
        for wanted, value in {
            "Vector": self.stage.node(
                material, "VectorMath", {"operation": "ADD"}, i0=position, i1=(-0.3, 0.2, 0.37)
            ).outputs[0],
            **inputs,
        }.items():
            socket = next((s for s in node.inputs if s.name == wanted.replace("_", " ") and s.enabled), None)
            if socket is not None:
                self.stage.set(
                    material.node_tree, socket, value(self.stage, material, position) if callable(value) else value
                )
        made = node.outputs[output] if output not in (None, 0) else next(s for s in node.outputs if s.enabled)
        self._shine(material, made)
        self.names.append(name)
        self.outputs.append(made)
        self.materials.append(material)

    def _shine(self, material, value):
        shone = self.stage.node(
            material, "VectorMath", {"operation": "MULTIPLY_ADD"}, i0=value, i1=(SCALE,) * 3, i2=(SHIFT,) * 3
        ).outputs[0]
        self.stage.shader(material, "Emission", Color=shone, Strength=1.0)

    def compared(self):
        """For each tile (name, our values, Cycles' values), n x 3."""
        count = len(self.names)
        across = int(np.ceil(np.sqrt(count)))
        down = -(-count // across)
        for i, material in enumerate(self.materials):
            y, x = divmod(i, across)
            corners = [(0, 0, 0), (1, 0, 0.3), (1, 1, 0.8), (0, 1, 0.5)]  # so that no coordinate is constant
            self.stage.mesh("tile", corners, [(0, 1, 2, 3)], material, (x, y, 0))
        camera = self.stage.object("above", bpy.data.cameras.new("above"), (across / 2, down / 2, 2))
        camera.data.type, camera.data.ortho_scale = "ORTHO", max(across, down)
        scene = self.stage.scene
        scene.camera = camera
        scene.render.resolution_x, scene.render.resolution_y = across * TILE, down * TILE
        set_up_cycles(scene, 1)
        shone = self._rendered()
        places = self.stage.material("places")
        self._shine(places, self.stage.node(places, "NewGeometry").outputs["Position"])
        bpy.context.view_layer.material_override = places
        where = self._rendered()
        for i, (name, output) in enumerate(zip(self.names, self.outputs)):
            y, x = divmod(i, across)
            part = slice(y * TILE, (y + 1) * TILE), slice(x * TILE, (x + 1) * TILE)
            position = where[part].reshape(-1, 3)
            value = Reader(self.report).value(Socket(output.links[0].to_socket))
            ours = value(Points(len(position), position=position))
            yield name, np.broadcast_to(ours, position.shape), shone[part].reshape(-1, 3)

    def _rendered(self):
        """height x width x 3 from below."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "sheet.exr")
            self.stage.scene.render.filepath = path
            quietly(lambda: bpy.ops.render.render(write_still=True))
            return ((read(path)[::-1].astype(np.float64) - SHIFT) / SCALE).astype(np.float32)


# Inputs that change over the sheet


def sloping(stage, material, position):
    """A W that changes over the sheet."""
    return stage.node(material, "VectorMath", {"operation": "DOT_PRODUCT"}, i0=position, i1=(0.7, 0.31, 0.0)).outputs[
        "Value"
    ]


def gently(stage, material, position):
    """As sloping, where a greater slope would be chaos."""
    slope = sloping(stage, material, position)
    return stage.node(material, "Math", {"operation": "MULTIPLY_ADD"}, i0=slope, i1=0.05, i2=0.7).outputs[0]


def scaled(stage, material, _position, vector, scale):
    return stage.node(material, "VectorMath", {"operation": "SCALE"}, i0=vector, Scale=scale).outputs[0]


def stepped(stage, material, position):
    """Whole numbers, of which there are five a unit."""
    fifths = scaled(stage, material, position, position, 5.0)
    return stage.node(material, "VectorMath", {"operation": "FLOOR"}, i0=fifths).outputs[0]


def stepped_w(stage, material, position):
    return stage.node(material, "SeparateXYZ", Vector=stepped(stage, material, position)).outputs[0]
