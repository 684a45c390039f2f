"""Surfaces and worlds that are not the same for all rays: Light Path."""

import math

from stage import feature


def told(s, owner, *names):
    """The largest of these outputs of a Light Path node."""
    node = s.node(owner, "LightPath")
    outputs = [next(o for o in node.outputs if o.name == name) for name in names]
    largest = outputs[0]
    for other in outputs[1:]:
        largest = s.node(owner, "Math", {"operation": "MAXIMUM"}, i0=largest, i1=other).outputs[0]
    return largest


def mixed(s, material, factor, first, second):
    """A Mix Shader of two nodes as the material's surface."""
    s.shader(material, "MixShader", i0=factor, i1=first.outputs[0], i2=second.outputs[0])


def make_window_glass(s, material, *names, colour=(1, 1, 1)):
    """Glass to all rays but those named, to which it is nothing."""
    glass = s.node(material, "BsdfGlass", Color=colour, Roughness=0.0, IOR=1.45)
    mixed(s, material, told(s, material, *names), glass, s.node(material, "BsdfTransparent", Color=(1, 1, 1)))


@feature("Light Path: glass without a shadow", lit=False)
def _(s):
    # Lights that paths do not meet: the rest of their light would come through the glass once more.
    s.light("POINT", 400, (1.5, -2, 3.5), shadow_soft_size=0.0)
    s.light("SUN", 1, (-2, -3, 4), angle=0.0)
    make_window_glass(s, s.ball.active_material, "Is Shadow Ray")


@feature("Light Path: a lighter shadow", lit=False)
def _(s):
    s.light("POINT", 400, (1.5, -2, 3.5), shadow_soft_size=0.0)
    m = s.ball.active_material
    half = s.node(m, "Math", {"operation": "MULTIPLY"}, i0=told(s, m, "Is Shadow Ray"), i1=0.6)
    mixed(
        s,
        m,
        half.outputs[0],
        s.node(m, "BsdfDiffuse", Color=(0.7, 0.3, 0.2)),
        s.node(m, "BsdfTransparent", Color=(1, 1, 1)),
    )


@feature("Light Path: window")
def _(s):
    pane = s.cube("pane", 1.0, (0.2, -0.9, 0.9), s.material("pane"))
    pane.scale = (2.6, 0.04, 1.8)
    make_window_glass(s, pane.active_material, "Is Shadow Ray", "Is Diffuse Ray", colour=(0.7, 0.9, 0.8))


@feature("Light Path: hidden from the camera")
def _(s):
    m = s.ball.active_material
    mixed(
        s,
        m,
        told(s, m, "Is Camera Ray"),
        s.node(m, "BsdfDiffuse", Color=(0.7, 0.3, 0.2)),
        s.node(m, "BsdfTransparent", Color=(1, 1, 1)),
    )


@feature("hidden from diffuse and shadow rays")
def _(s):
    s.shader(s.ball.active_material, "BsdfGlass", Color=(1, 1, 1), Roughness=0.0, IOR=1.45)
    s.ball.visible_diffuse = s.ball.visible_shadow = False


def backdrop(s, seen, lighting):
    """A world that the camera sees and one that lights."""
    world = s.scene.world
    first = s.node(world, "Background", Color=lighting)
    second = s.node(world, "Background", Color=seen)
    mix = s.node(world, "MixShader", i0=told(s, world, "Is Camera Ray"), i1=first.outputs[0], i2=second.outputs[0])
    output = next(n for n in world.node_tree.nodes if n.type == "OUTPUT_WORLD")
    world.node_tree.links.new(mix.outputs[0], output.inputs["Surface"])
    s.aim(s.camera, (0, 0, 1.6))


@feature("world, one for the camera", lit=False)
def _(s):
    s.shader(s.ball.active_material, "BsdfAnisotropic", Color=(0.9, 0.9, 0.9), Roughness=0.0)
    s.box.active_material = s.principled("glass", Base_Color=(1, 1, 1), Transmission_Weight=1.0, Roughness=0.0)
    s.box.location.z = 0.65  # glass whose lower face is the floor is what the rounding makes of it
    backdrop(s, (0.2, 0.5, 1.0), (1.0, 0.8, 0.6))


@feature("world, a sky for the camera", lit=False)
def _(s):
    sky = s.node(s.scene.world, "TexSky")
    sky.sun_elevation, sky.sun_rotation, sky.sun_disc = math.radians(25), math.radians(-140), False
    backdrop(s, sky.outputs[0], (0.5, 0.45, 0.4))
    for node in s.scene.world.node_tree.nodes:
        if node.type == "BACKGROUND" and node.inputs["Color"].is_linked:
            node.inputs["Strength"].default_value = 0.2
