"""Small Blender scenes for tests: a floor, a ball and a box before a camera, and helpers to change them."""

import math

import bpy
from mathutils import Vector

WIDTH, HEIGHT = 128, 96

FEATURES = {}


def feature(name, lit=True, reason=None, spp=256, mean=0.02, block=1e-3):
    """Makes a function that changes a Stage a scene of FEATURES, to be compared with Cycles. reason: why the two pictures
    cannot agree, where they cannot; mean, block: how far they may be apart."""

    def add(function):
        def build():
            stage = Stage(lit)
            function(stage)
            bpy.context.view_layer.update()
            return stage

        FEATURES[name] = dict(build=build, reason=reason, spp=spp, mean=mean, block=block)
        return function

    return add


class Stage:
    """A fresh scene. lit: with a square lamp and a grey world; else both are black, for scenes that light themselves."""

    def __init__(self, lit=True):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.scene = scene = bpy.context.scene
        scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = WIDTH, HEIGHT, 100
        scene.view_settings.view_transform = "Raw"
        scene.world = bpy.data.worlds.new("world")
        scene.world.use_nodes = True
        self.light_world((0.3, 0.35, 0.4) if lit else (0, 0, 0))
        self.camera = self.object("camera", bpy.data.cameras.new("camera"), (3.2, -5.0, 2.6))
        self.aim(self.camera, (0, 0, 0.7))
        self.camera.data.lens = 40
        scene.camera = self.camera
        self.floor = self.plane("floor", 12, (0, 0, 0), self.material("floor", (0.5, 0.5, 0.5)))
        self.ball = self.sphere("ball", 0.9, (-0.7, 0.1, 0.9), self.material("ball", (0.7, 0.3, 0.2)))
        self.box = self.cube("box", 1.1, (1.2, 0.4, 0.55), self.material("box", (0.2, 0.4, 0.7)))
        self.box.rotation_euler = (0, 0, 0.5)
        if lit:
            self.lamp = self.light("AREA", 300, (2.5, -2.5, 4.5), (0, 0, 0.5), size=1.5)

    def light_world(self, colour, strength=1.0):
        """colour: of the world, or an output of a node of its tree."""
        background = self.scene.world.node_tree.nodes["Background"]
        self.set(self.scene.world.node_tree, background.inputs["Color"], colour)
        background.inputs["Strength"].default_value = strength

    def object(self, name, data, location=(0, 0, 0)):
        made = bpy.data.objects.new(name, data)
        made.location = location
        self.scene.collection.objects.link(made)
        return made

    @staticmethod
    def aim(object_, target):
        way = Vector(target) - object_.location
        object_.rotation_euler = way.to_track_quat("-Z", "Y").to_euler()

    def light(self, kind, energy, location=(0, 0, 3), target=(0, 0, 0), **settings):
        made = self.object(kind.lower(), bpy.data.lights.new(kind.lower(), kind), location)
        made.data.energy = energy
        for name, value in settings.items():
            setattr(made.data, name, value)
        self.aim(made, target)
        return made

    # Materials

    def material(self, name, colour=(0.8, 0.8, 0.8)):
        made = bpy.data.materials.new(name)
        made.use_nodes = True
        self.shader(made, "BsdfDiffuse", Color=colour)
        return made

    def principled(self, name, **inputs):
        made = self.material(name)
        self.shader(made, "BsdfPrincipled", **inputs)
        return made

    def emission(self, name, colour, strength):
        made = self.material(name)
        self.shader(made, "Emission", Color=colour, Strength=strength)
        return made

    @staticmethod
    def set(tree, socket, value):
        if hasattr(value, "is_output"):
            tree.links.new(value, socket)
        elif isinstance(value, tuple) and len(value) == 3 and socket.type == "RGBA":
            socket.default_value = value + (1,)
        else:
            socket.default_value = value

    def node(self, owner, kind, settings=(), **inputs):
        """A node in a material's or world's tree; inputs by name, with _ for spaces, or by number, as i2."""
        tree = owner.node_tree
        made = tree.nodes.new("ShaderNode" + kind)
        for name, value in dict(settings).items():
            setattr(made, name, value)
        for name, value in inputs.items():
            if name[0] == "i" and name[1:].isdigit():
                socket = made.inputs[int(name[1:])]
            else:
                # Blender 5 calls factors Factor that were Fac before.
                names = {"Fac", "Factor"} if name == "Fac" else {name.replace("_", " ")}
                socket = next(s for s in made.inputs if s.name in names and s.enabled)
            self.set(tree, socket, value)
        return made

    def shader(self, material, kind, settings=(), **inputs):
        """Makes a node the material's surface."""
        made = self.node(material, kind, settings, **inputs)
        self.surface(material, made.outputs[0])
        return made

    @staticmethod
    def surface(material, output):
        tree = material.node_tree
        end = next((n for n in tree.nodes if n.type == "OUTPUT_MATERIAL"), None) or tree.nodes.new(
            "ShaderNodeOutputMaterial"
        )
        tree.links.new(output, end.inputs["Surface"])

    # Shapes

    def mesh(self, name, vertices, faces, material, location=(0, 0, 0), uvs=None):
        data = bpy.data.meshes.new(name)
        data.from_pydata(vertices, [], faces)
        if uvs is not None:
            layer = data.uv_layers.new(name="UVMap")
            layer.uv.foreach_set("vector", [c for uv in uvs for c in uv])
        if material is not None:
            data.materials.append(material)
        return self.object(name, data, location)

    def plane(self, name, size, location, material):
        h = size / 2
        return self.mesh(
            name,
            [(-h, -h, 0), (h, -h, 0), (h, h, 0), (-h, h, 0)],
            [(0, 1, 2, 3)],
            material,
            location,
            [(0, 0), (1, 0), (1, 1), (0, 1)],
        )

    def _primitive(self, name, location, material, smooth):
        made = bpy.context.object
        made.name = made.data.name = name
        if smooth:
            made.data.shade_smooth()
        made.data.materials.clear()
        made.data.materials.append(material)
        made.location = location
        return made

    def sphere(self, name, radius, location, material, segments=96):
        bpy.ops.mesh.primitive_uv_sphere_add(radius=radius, segments=segments, ring_count=segments // 2)
        return self._primitive(name, location, material, True)

    def cube(self, name, size, location, material):
        bpy.ops.mesh.primitive_cube_add(size=size)
        return self._primitive(name, location, material, False)

    # Images

    def texture(self, material, image, vector=None):
        """The colour of an image's node; vector: where it is looked up, None for the mesh's own coordinates."""
        inputs = {} if vector is None else {"Vector": vector}
        return self.node(material, "TexImage", {"image": image}, **inputs).outputs[0]

    def striped(self, colourspace="sRGB"):
        return self.image("stripes", 128, 128, stripes, colourspace)

    @staticmethod
    def image(name, width, height, value, colourspace="sRGB", is_float=False):
        """value(u, v) gives a pixel's colour, as it is stored."""
        made = bpy.data.images.new(name, width, height, alpha=False, float_buffer=is_float)
        pixels = []
        for y in range(height):
            for x in range(width):
                pixels += [*value((x + 0.5) / width, (y + 0.5) / height), 1.0]
        made.colorspace_settings.name = colourspace  # first: it clears the pixels
        made.pixels.foreach_set(pixels)
        made.update()
        return made


def stripes(u, v):
    """Smooth enough that ways to interpolate and filter do not matter."""
    return (
        0.5 + 0.35 * math.sin(8 * math.pi * u),
        0.5 + 0.35 * math.sin(6 * math.pi * v),
        0.3 + 0.2 * math.cos(4 * math.pi * (u + v)),
    )
