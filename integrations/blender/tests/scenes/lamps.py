"""Lamps, and meshes that shine."""

import math

import bpy

from stage import feature, stripes


@feature("point, no radius", lit=False)
def _(s):
    s.light("POINT", 400, (1.5, -2, 3.5), shadow_soft_size=0.0)


@feature("point, radius 0.3", lit=False)
def _(s):
    s.light("POINT", 400, (1.5, -2, 4.0), shadow_soft_size=0.3)


@feature("point, coloured, temperature", lit=False)
def _(s):
    lamp = s.light("POINT", 300, (1.5, -2, 4.0), shadow_soft_size=0.1)
    lamp.data.color = (1.0, 0.8, 0.6)
    if hasattr(lamp.data, "use_temperature"):
        lamp.data.use_temperature, lamp.data.temperature = True, 3200
        lamp.data.exposure = 0.5


@feature("sun, no angle", lit=False)
def _(s):
    s.light("SUN", 3, (2, -3, 4), angle=0.0)


@feature("sun, 0.5 degrees", lit=False)
def _(s):
    s.light("SUN", 3, (2, -3, 4), angle=math.radians(0.526))


@feature("sun, 20 degrees", lit=False)
def _(s):
    s.light("SUN", 3, (2, -3, 4), angle=math.radians(20))


@feature("spot, blend 0.15", lit=False)
def _(s):
    s.light("SPOT", 800, (2, -2.5, 4), (0.2, 0, 0.5), shadow_soft_size=0.0, spot_size=math.radians(40), spot_blend=0.15)


@feature("spot, blend 1", lit=False)
def _(s):
    s.light("SPOT", 800, (2, -2.5, 4), (0.2, 0, 0.5), shadow_soft_size=0.0, spot_size=math.radians(60), spot_blend=1.0)


@feature("spot, radius 0.2", lit=False)
def _(s):
    s.light("SPOT", 800, (2, -2.5, 4), (0.2, 0, 0.5), shadow_soft_size=0.2, spot_size=math.radians(40), spot_blend=0.15)


@feature("area, square", lit=False)
def _(s):
    s.light("AREA", 200, (2, -2.5, 4.5), size=1.2)


@feature("area, rectangle", lit=False)
def _(s):
    s.light("AREA", 200, (2, -2.5, 4.5), shape="RECTANGLE", size=2.0, size_y=0.4)


@feature("area, disk", lit=False)
def _(s):
    s.light("AREA", 200, (2, -2.5, 4.5), shape="DISK", size=1.2)


@feature("area, ellipse, scaled", lit=False)
def _(s):
    lamp = s.light("AREA", 200, (2, -2.5, 4.5), shape="ELLIPSE", size=1.6, size_y=0.6)
    lamp.scale = (1.5, 0.7, 1)


@feature("area, spread 60 degrees", lit=False)
def _(s):
    s.light("AREA", 200, (2, -2.5, 4.5), size=1.0, spread=math.radians(60))


@feature("lamps before the camera", lit=False)
def _(s):
    s.light("AREA", 60, (-0.6, -0.8, 2.2), size=0.8)
    s.light("POINT", 60, (0.8, -0.6, 1.2), shadow_soft_size=0.3, use_soft_falloff=False)


def downlight():
    """A photometric file of a lamp that is brighter to one side. It has many angles, because Cycles takes what is beyond
    the first and the last for dark where it interpolates."""
    down, around = (0, 10, 20, 30, 45, 60, 75, 90), range(0, 361, 10)
    below = (900, 860, 600, 300, 100, 40, 10, 0)
    rows = [" ".join(f"{c * (1 + 0.5 * math.sin(math.radians(a))):.1f}" for c in below) for a in around]
    sizes = f"1 1000 1.5 {len(down)} {len(around)} 1 2 0 0 0"
    angles = [" ".join(map(str, down)), " ".join(map(str, around))]
    return "\n".join(["IESNA:LM-63-2002", "[TEST] lamps", "TILT=NONE", sizes, "1 1 50", *angles, *rows]) + "\n"


def measured(s, lamp):
    lamp.data.use_nodes = True
    emission = next(n for n in lamp.data.node_tree.nodes if n.type == "EMISSION")
    file = bpy.data.texts.new("downlight.ies")
    file.write(downlight())
    profile = s.node(lamp.data, "TexIES", {"mode": "INTERNAL", "ies": file}, Strength=0.02)
    lamp.data.node_tree.links.new(profile.outputs[0], emission.inputs["Strength"])


@feature("point: IES Texture", lit=False)
def _(s):
    lamp = s.light("POINT", 150, (0.3, -0.6, 3.4), shadow_soft_size=0)
    lamp.rotation_euler = (0.2, 0.1, 0.8)
    lamp.data.color = (1, 0.8, 0.6)
    measured(s, lamp)


@feature("spot: IES Texture", lit=False)
def _(s):
    lamp = s.light("SPOT", 400, (1.5, -2.5, 3.5), (0, 0, 0.4), spot_size=1.0, spot_blend=0.4, shadow_soft_size=0)
    measured(s, lamp)


@feature("emissive mesh", lit=False)
def _(s):
    s.sphere("lamp", 0.4, (0.6, -1.4, 0.5), s.emission("glow", (1.0, 0.8, 0.5), 8.0), 48)


@feature("textured emissive mesh", lit=False)
def _(s):
    glow = s.material("glow")
    image = s.texture(glow, s.image("screen", 64, 64, stripes))
    s.shader(glow, "Emission", Color=image, Strength=6.0)
    screen = s.plane("screen", 2.0, (0.2, 1.6, 1.1), glow)
    screen.rotation_euler = (math.pi / 2, 0, 0)
