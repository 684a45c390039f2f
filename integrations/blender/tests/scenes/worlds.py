"""Worlds that light the scene alone."""

import math

from stage import feature


@feature("world, constant", lit=False)
def _(s):
    s.light_world((0.5, 0.7, 1.0), 0.8)


def sky_image(s):
    return s.image(
        "sky",
        256,
        128,
        lambda u, v: (
            0.3 + 0.2 * math.sin(2 * math.pi * u) + (8 if abs(u - 0.3) < 0.03 and abs(v - 0.8) < 0.05 else 0),
            0.4 + 0.3 * v,
            0.2 + 0.8 * v,
        ),
        "Non-Color",
        True,
    )


@feature("world, environment image", lit=False)
def _(s):
    s.light_world(s.node(s.scene.world, "TexEnvironment", {"image": sky_image(s)}).outputs[0])


@feature("world, environment image, turned", lit=False)
def _(s):
    world = s.scene.world
    coordinates = s.node(world, "TexCoord")
    mapping = s.node(world, "Mapping", Vector=coordinates.outputs["Generated"], Rotation=(0.2, -0.1, 1.2))
    image = s.node(world, "TexEnvironment", {"image": sky_image(s)}, Vector=mapping.outputs[0])
    s.light_world(image.outputs[0], 0.7)


@feature("world, sky texture", lit=False)
def _(s):
    add_sky(s, False)


@feature("world, sky texture with sun", lit=False)
def _(s):
    add_sky(s, True)


def add_sky(s, disc):
    sky = s.node(s.scene.world, "TexSky")
    sky.sun_elevation, sky.sun_rotation = math.radians(35), math.radians(-140)
    sky.sun_disc = disc
    s.light_world(sky.outputs[0], 0.2)
