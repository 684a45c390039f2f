"""Hair: Curves objects and particle systems."""

import bpy
import numpy as np

from stage import feature


def tufts(count, seed=1, size=2.5, height=0.5, bend=0.25):
    """Strands of nine keys that grow from the floor and bend: strands x keys x 3."""
    rng = np.random.default_rng(seed)
    root = np.column_stack([rng.uniform(-size, size, (count, 2)), np.zeros(count)])
    t = np.linspace(0, 1, 9)[None, :, None]
    lean = np.column_stack([rng.normal(0, bend, (count, 2)), np.full(count, -0.1)])
    return root[:, None] + t * np.array([0, 0, height]) + t * t * lean[:, None]


def curves(s, name, keys, radii, material, uv=None):
    """radii: strands x keys, or None for none."""
    data = bpy.data.hair_curves.new(name)
    data.add_curves([keys.shape[1]] * len(keys))
    data.attributes["position"].data.foreach_set("vector", keys.reshape(-1).astype(np.float32))
    if radii is not None:
        made = data.attributes.get("radius") or data.attributes.new("radius", "FLOAT", "POINT")
        made.data.foreach_set("value", np.broadcast_to(radii, keys.shape[:2]).reshape(-1).astype(np.float32))
    if uv is not None:
        made = data.attributes.new("surface_uv_coordinate", "FLOAT2", "CURVE")
        made.data.foreach_set("vector", uv.reshape(-1).astype(np.float32))
    data.materials.append(material)
    return s.object(name, data)


WIDE = np.linspace(0.02, 0.005, 9)


@feature("hair: curves")
def _(s):
    curves(s, "tufts", tufts(900), WIDE, s.material("hair", (0.6, 0.5, 0.3)))


@feature("hair: thick curves, turned and stretched")
def _(s):
    s.scene.cycles_curves.shape = "THICK"
    made = curves(s, "tufts", tufts(900), 0.6 * WIDE, s.material("hair", (0.6, 0.5, 0.3)))
    made.rotation_euler, made.scale, made.location = (0.2, 0.1, 0.5), (1.2, 1.2, 1.2), (0.2, 0, 0)


@feature("hair: curves without radii")
def _(s):
    curves(s, "tufts", tufts(3000), None, s.material("hair", (0.6, 0.5, 0.3)))


@feature("hair: bellied strands")
def _(s):
    curves(s, "tufts", tufts(600), [0.01, 0.03, 0.04, 0.03, 0.01, 0.03, 0.02, 0.01, 0], s.material("hair", (0.3, 0.6, 0.3)))


@feature("hair: Principled")
def _(s):
    curves(s, "tufts", tufts(900), WIDE, s.principled("hair", Base_Color=(0.1, 0.3, 0.6), Roughness=0.3))


def principled_hair(s, parametrization, **inputs):
    made = s.material("hair")
    settings = {"parametrization": parametrization, "model": "CHIANG"}
    s.shader(made, "BsdfHairPrincipled", settings, **inputs)
    return made


@feature("hair: Principled Hair, colour", spp=512)
def _(s):
    curves(s, "tufts", tufts(900), WIDE, principled_hair(s, "COLOR", Color=(0.6, 0.3, 0.1)))


@feature("hair: Principled Hair, melanin", spp=512)
def _(s):
    curves(
        s, "tufts", tufts(900), WIDE, principled_hair(s, "MELANIN", Melanin=0.4, Melanin_Redness=0.7, Tint=(0.9, 0.8, 1))
    )


@feature("hair: Principled Hair, absorption", spp=512)
def _(s):
    curves(
        s,
        "tufts",
        tufts(900),
        WIDE,
        principled_hair(s, "ABSORPTION", Absorption_Coefficient=(0.3, 0.6, 1.2), Roughness=0.5, Radial_Roughness=0.6),
    )


@feature("hair: texture at the roots")
def _(s):
    keys = tufts(900)
    hair = s.material("hair")
    s.shader(hair, "BsdfDiffuse", Color=s.texture(hair, s.striped()))
    curves(s, "tufts", keys, WIDE, hair, keys[:, 0, :2] / 5 + 0.5)


@feature("hair: from the root to the tip")
def _(s):
    hair = s.material("hair")
    ramp = s.node(hair, "ValToRGB", Fac=s.node(hair, "HairInfo").outputs["Intercept"])
    ramp.color_ramp.elements[0].color, ramp.color_ramp.elements[1].color = (0.05, 0.2, 0.6, 1), (0.9, 0.7, 0.2, 1)
    s.shader(hair, "BsdfDiffuse", Color=ramp.outputs[0])
    curves(s, "tufts", tufts(900), WIDE, hair)


def particles(s, object_, material, count, **settings):
    modifier = object_.modifiers.new("hair", "PARTICLE_SYSTEM")
    system = modifier.particle_system.settings
    system.type, system.count, system.hair_length = "HAIR", count, 0.4
    system.render_step = system.display_step = 3
    system.root_radius, system.tip_radius, system.radius_scale = 1.0, 0.2, 0.05
    for name, value in settings.items():
        setattr(system, name, value)
    object_.data.materials.append(material)
    system.material = len(object_.data.materials)
    return system


@feature("hair: particles")
def _(s):
    particles(s, s.ball, s.material("hair", (0.6, 0.5, 0.3)), 400)


@feature("hair: particles, children, close tips, shape", reason=None)
def _(s):
    particles(
        s,
        s.floor,
        s.material("hair", (0.6, 0.5, 0.3)),
        300,
        child_type="INTERPOLATED",
        rendered_child_count=10,
        child_percent=10,
        shape=0.5,
        use_close_tip=True,
        brownian_factor=0.05,
    )


@feature("hair: particles, texture, without their mesh")
def _(s):
    hair = s.material("hair")
    s.shader(hair, "BsdfDiffuse", Color=s.texture(hair, s.striped()))
    particles(s, s.floor, hair, 2000)
    s.plane("below", 12, (0, 0, -0.01), s.material("below", (0.3, 0.3, 0.3)))
    s.floor.show_instancer_for_render = s.floor.show_instancer_for_viewport = False
