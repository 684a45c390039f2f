"""Three furnished rooms, made of what the other scenes have one by one."""

import math

import bpy

from stage import feature

from .light_paths import backdrop, make_window_glass


class Room:
    """4 x 5 x 2.6 m, with a camera at the wall of least y."""

    def __init__(self, stage, walls, window=False):
        self.s = s = stage
        for made in (s.floor, s.ball, s.box):
            bpy.data.objects.remove(made)
        s.camera.location, s.camera.data.lens = (0.4, -2.3, 1.5), 20
        s.aim(s.camera, (-0.2, 2, 1.0))
        self.walls = s.material("walls", walls)
        self.wood = s.material("wood")
        self.box("floor", (4, 5, 0.1), (0, 0, -0.05), self.wood)
        self.box("ceiling", (4, 5, 0.1), (0, 0, 2.65), self.walls)
        self.box("back", (4.2, 0.1, 2.6), (0, 2.55, 1.3), self.walls)
        self.box("front", (4.2, 0.1, 2.6), (0, -2.55, 1.3), self.walls)
        self.box("right", (0.1, 5, 2.6), (2.05, 0, 1.3), self.walls)
        if window:
            for name, size, at in (
                ("sill", (0.1, 5, 0.9), (-2.05, 0, 0.45)),
                ("lintel", (0.1, 5, 0.4), (-2.05, 0, 2.4)),
                ("side", (0.1, 2.0, 1.3), (-2.05, -1.5, 1.55)),
                ("other side", (0.1, 1.0, 1.3), (-2.05, 2.0, 1.55)),
            ):
                self.box(name, size, at, self.walls)
        else:
            self.box("left", (0.1, 5, 2.6), (-2.05, 0, 1.3), self.walls)

    def box(self, name, size, at, material, bevel=0.0):
        made = self.s.cube(name, 1.0, at, material)
        made.scale = size
        if bevel:
            made.modifiers.new("bevel", "BEVEL").width = bevel
        return made

    def table(self, at, material):
        x, y = at
        self.box("table", (1.2, 0.7, 0.05), (x, y, 0.72), material)
        for i in (-0.5, 0.5):
            for j in (-0.28, 0.28):
                self.box("leg", (0.05, 0.05, 0.7), (x + i, y + j, 0.35), material)


@feature("room by day", lit=False, spp=1024)
def _(s):
    room = Room(s, (0.75, 0.72, 0.68), window=True)
    noise = s.node(room.wood, "TexNoise", Scale=6.0, Detail=4.0)
    ramp = s.node(room.wood, "ValToRGB", Fac=noise.outputs[0])
    ramp.color_ramp.elements[0].color, ramp.color_ramp.elements[1].color = (0.18, 0.08, 0.03, 1), (0.5, 0.3, 0.15, 1)
    s.shader(room.wood, "BsdfPrincipled", Base_Color=ramp.outputs[0], Roughness=0.4)
    s.light_world((0.6, 0.8, 1.0), 4.0)
    s.light("SUN", 12, (-5, 1, 4.5), angle=math.radians(0.5))
    room.table((0.7, 1.2), s.principled("oak", Base_Color=(0.4, 0.22, 0.1), Roughness=0.3))
    s.sphere(
        "vase",
        0.16,
        (0.6, 1.2, 0.91),
        s.principled("vase", Base_Color=(0.1, 0.2, 0.6), Coat_Weight=1.0, Roughness=0.4),
        48,
    )
    room.box(
        "sofa",
        (0.9, 1.8, 0.45),
        (-1.2, 0.7, 0.3),
        s.principled("cloth", Base_Color=(0.5, 0.12, 0.1), Sheen_Weight=0.6, Roughness=0.9),
        0.06,
    )


@feature("room with glass in its window", lit=False, spp=1024)
def _(s):
    room = Room(s, (0.75, 0.72, 0.68), window=True)
    s.shader(room.wood, "BsdfPrincipled", Base_Color=(0.35, 0.2, 0.1), Roughness=0.4)
    s.camera.location = (1.7, -2.2, 1.5)
    s.aim(s.camera, (-1.6, 1.2, 1.1))
    backdrop(s, (0.5, 0.8, 1.0), (2.4, 3.2, 4.0))
    s.aim(s.camera, (-1.6, 1.2, 1.1))
    s.light("SUN", 12, (-5, 1, 4.5), angle=0.0)  # no paths find it by chance, in the pane's reflection
    pane = room.box("pane", (0.02, 2.0, 1.3), (-2.03, 0.5, 1.55), s.material("glass"))
    make_window_glass(s, pane.active_material, "Is Shadow Ray", "Is Diffuse Ray")
    room.table((0.2, 1.2), s.principled("oak", Base_Color=(0.4, 0.22, 0.1), Roughness=0.3))
    mirror = s.material("mirror")
    s.shader(mirror, "BsdfAnisotropic", Color=(0.9, 0.9, 0.9), Roughness=0.0)
    room.box("mirror", (1.2, 0.04, 1.0), (0.8, 2.47, 1.4), mirror)


@feature("room in the evening", lit=False, spp=1024)
def _(s):
    room = Room(s, (0.6, 0.65, 0.7))
    checker = s.node(
        room.wood,
        "TexChecker",
        Vector=s.node(room.wood, "TexCoord").outputs["Object"],
        Color1=(0.7, 0.7, 0.65),
        Color2=(0.1, 0.1, 0.12),
        Scale=9.3,
    )
    s.shader(room.wood, "BsdfPrincipled", Base_Color=checker.outputs[0], Roughness=0.25)
    s.light("AREA", 40, (0, -1.6, 2.58), (0, -1.6, 0), size=0.8)  # out of sight
    s.sphere("lampshade", 0.18, (1.3, 1.8, 1.4), s.emission("glow", (1.0, 0.7, 0.4), 6.0), 32)
    mirror = s.material("mirror")
    s.shader(mirror, "BsdfAnisotropic", Color=(0.9, 0.9, 0.9), Roughness=0.0)
    room.box("mirror", (1.2, 0.04, 1.0), (-0.8, 2.47, 1.4), mirror)
    room.table((-0.6, 1.2), s.principled("steel", Base_Color=(0.7, 0.7, 0.72), Metallic=1.0, Roughness=0.35))


@feature("bathroom", lit=False, spp=1024)
def _(s):
    room = Room(s, (0.8, 0.8, 0.8))
    bricks = s.node(
        room.walls,
        "TexBrick",
        Vector=s.node(room.walls, "TexCoord").outputs["UV"],
        Color1=(0.7, 0.8, 0.8),
        Color2=(0.5, 0.65, 0.7),
        Mortar=(0.3, 0.3, 0.3),
        Scale=4.0,
        Mortar_Size=0.01,
    )
    s.shader(room.walls, "BsdfPrincipled", Base_Color=bricks.outputs[0], Roughness=0.3)
    s.shader(room.wood, "BsdfPrincipled", Base_Color=(0.35, 0.35, 0.37), Roughness=0.5)
    for x in (-1, 1):
        s.light(
            "SPOT", 120, (x, 0.8, 2.55), (x, 0.9, 0), shadow_soft_size=0.0, spot_size=math.radians(110), spot_blend=0.6
        )
    s.light("POINT", 30, (0, -0.5, 2.2), shadow_soft_size=0.0)
    room.box(
        "tub",
        (0.8, 1.7, 0.55),
        (1.5, 1.5, 0.28),
        s.principled("enamel", Base_Color=(0.85, 0.85, 0.85), Roughness=0.1),
        0.1,
    )
    room.box(
        "screen",
        (0.02, 1.4, 1.9),
        (-0.7, 1.7, 1.0),
        s.principled("glass", Base_Color=(1, 1, 1), Transmission_Weight=1.0, Roughness=0.0),
    )
    s.sphere(
        "tap",
        0.1,
        (1.2, 0.7, 0.66),
        s.principled("chrome", Base_Color=(0.9, 0.9, 0.9), Metallic=1.0, Roughness=0.15),
        32,
    )
