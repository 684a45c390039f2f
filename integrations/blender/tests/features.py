"""The feature scenes that are compared with Cycles: a name, a function that builds the scene, and, where the two
pictures cannot agree, the reason."""

import math

import bpy

from stage import Stage, stripes

FEATURES = {}


def feature(name, lit=True, reason=None, spp=256, mean=0.02, block=1e-3):
    def add(function):
        def build():
            stage = Stage(lit)
            function(stage)
            bpy.context.view_layer.update()
            return stage

        FEATURES[name] = dict(build=build, reason=reason, spp=spp, mean=mean, block=block)
        return function

    return add


# Lamps


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


@feature("hidden from the camera")
def _(s):
    s.ball.visible_camera = False


@feature("without a shadow", lit=False)
def _(s):
    s.ball.visible_shadow = False
    # Else Cycles loses a part of the light: the one that paths would have found, which the ball is not open to.
    s.light("AREA", 300, (2.5, -2.5, 4.5), (0, 0, 0.5), size=1.5).data.cycles.use_multiple_importance_sampling = False


@feature("world, hidden from the camera")
def _(s):
    s.scene.world.cycles_visibility.camera = False
    s.aim(s.camera, (0, 0, 2))


@feature("transparent film")
def _(s):
    s.scene.render.film_transparent = True
    s.aim(s.camera, (0, 0, 2))


@feature("emissive mesh", lit=False)
def _(s):
    glow = s.material("glow")
    s.shader(glow, "Emission", Color=(1.0, 0.8, 0.5), Strength=8.0)
    s.sphere("lamp", 0.4, (0.6, -1.4, 0.5), glow, 48)


@feature("textured emissive mesh", lit=False)
def _(s):
    glow = s.material("glow")
    image = s.node(glow, "TexImage", {"image": s.image("screen", 64, 64, stripes)})
    s.shader(glow, "Emission", Color=image.outputs[0], Strength=6.0)
    screen = s.plane("screen", 2.0, (0.2, 1.6, 1.1), glow)
    screen.rotation_euler = (math.pi / 2, 0, 0)


# Worlds


@feature("world, constant", lit=False)
def _(s):
    s.background.inputs["Color"].default_value = (0.5, 0.7, 1.0, 1)
    s.background.inputs["Strength"].default_value = 0.8


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
    image = s.node(s.scene.world, "TexEnvironment", {"image": sky_image(s)})
    s.set(s.scene.world.node_tree, s.background.inputs["Color"], image.outputs[0])


@feature("world, environment image, turned", lit=False)
def _(s):
    world = s.scene.world
    coordinates = s.node(world, "TexCoord")
    mapping = s.node(world, "Mapping", Vector=coordinates.outputs["Generated"], Rotation=(0.2, -0.1, 1.2))
    image = s.node(world, "TexEnvironment", {"image": sky_image(s)}, Vector=mapping.outputs[0])
    s.set(world.node_tree, s.background.inputs["Color"], image.outputs[0])
    s.background.inputs["Strength"].default_value = 0.7


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
    s.set(s.scene.world.node_tree, s.background.inputs["Color"], sky.outputs[0])
    s.background.inputs["Strength"].default_value = 0.2


# Materials


def on_ball(name, kind, settings=(), **inputs):
    options = {k: inputs.pop(k) for k in ("reason", "block", "mean") if k in inputs}

    @feature(name, **options)
    def _(s):
        s.shader(s.ball.data.materials[0], kind, settings, **inputs)


on_ball("Principled, plastic", "BsdfPrincipled", Base_Color=(0.8, 0.3, 0.1), Roughness=0.3)
on_ball("Principled, metal", "BsdfPrincipled", Base_Color=(1.0, 0.72, 0.32), Metallic=1.0, Roughness=0.3)
on_ball("Principled, glass", "BsdfPrincipled", Base_Color=(0.9, 0.95, 1.0), Transmission_Weight=1.0, Roughness=0.1)
on_ball("Principled, coat", "BsdfPrincipled", Base_Color=(0.6, 0.05, 0.05), Coat_Weight=1.0, Roughness=0.5)
on_ball("Principled, sheen", "BsdfPrincipled", Base_Color=(0.2, 0.2, 0.3), Sheen_Weight=1.0, Roughness=0.8)
on_ball("Principled, alpha 0.4", "BsdfPrincipled", Base_Color=(0.2, 0.6, 0.3), Alpha=0.4)
on_ball(
    "Principled, emission",
    "BsdfPrincipled",
    Base_Color=(0.2, 0.2, 0.2),
    Emission_Color=(0.3, 0.6, 1.0),
    Emission_Strength=2.0,
)
on_ball("Diffuse", "BsdfDiffuse", Color=(0.3, 0.7, 0.4))
on_ball("Diffuse, rough", "BsdfDiffuse", reason="it is as smooth as Lambert's", Color=(0.3, 0.7, 0.4), Roughness=0.8)
on_ball("Glossy, sharp", "BsdfAnisotropic", Color=(0.8, 0.7, 0.5), Roughness=0.0)
on_ball("Glossy, rough 0.4", "BsdfAnisotropic", Color=(0.8, 0.5, 0.3), Roughness=0.4)
on_ball("Metallic", "BsdfMetallic", Base_Color=(0.9, 0.6, 0.4), Edge_Tint=(0.7, 0.8, 1.0), Roughness=0.3)
on_ball("Glass, clear", "BsdfGlass", Color=(1.0, 1.0, 1.0), Roughness=0.0, IOR=1.5)
on_ball(
    "Glass, coloured, rough",
    "BsdfGlass",
    reason="reflections at its rim are not tinted",
    Color=(0.7, 0.9, 0.8),
    Roughness=0.3,
    IOR=1.4,
)
on_ball("Transparent, grey", "BsdfTransparent", Color=(0.6, 0.6, 0.6))
on_ball("Transparent, coloured", "BsdfTransparent", Color=(0.4, 0.8, 0.6))
on_ball("Translucent", "BsdfTranslucent", Color=(0.7, 0.6, 0.3))
on_ball("Sheen", "BsdfSheen", Color=(0.8, 0.7, 0.9), Roughness=0.5)


@feature("Mix Shader: Diffuse and Glossy")
def _(s):
    m = s.ball.data.materials[0]
    a = s.node(m, "BsdfDiffuse", Color=(0.7, 0.2, 0.2))
    b = s.node(m, "BsdfAnisotropic", Color=(0.9, 0.9, 0.9), Roughness=0.2)
    s.shader(m, "MixShader", i0=0.3, i1=a.outputs[0], i2=b.outputs[0])


@feature("Mix Shader: by Fresnel", reason="the nearest is a plastic of the principled material")
def _(s):
    m = s.ball.data.materials[0]
    a = s.node(m, "BsdfDiffuse", Color=(0.7, 0.2, 0.2))
    b = s.node(m, "BsdfAnisotropic", Color=(1.0, 1.0, 1.0), Roughness=0.1)
    s.shader(m, "MixShader", i0=s.node(m, "Fresnel", IOR=1.5).outputs[0], i1=a.outputs[0], i2=b.outputs[0])


@feature("Mix Shader: cut-out by an image")
def _(s):
    m = s.box.data.materials[0]
    image = s.node(
        m,
        "TexImage",
        {
            "image": s.image(
                "holes", 64, 64, lambda u, v: [1.0 if math.sin(12 * u) * math.sin(12 * v) > 0 else 0.0] * 3, "Non-Color"
            )
        },
    )
    s.shader(
        m,
        "MixShader",
        i0=image.outputs[0],
        i1=s.node(m, "BsdfTransparent").outputs[0],
        i2=s.node(m, "BsdfDiffuse", Color=(0.7, 0.6, 0.2)).outputs[0],
    )


@feature("Add Shader: Diffuse and Emission")
def _(s):
    m = s.ball.data.materials[0]
    s.shader(
        m,
        "AddShader",
        i0=s.node(m, "BsdfDiffuse", Color=(0.5, 0.2, 0.2)).outputs[0],
        i1=s.node(m, "Emission", Color=(0.1, 0.3, 0.8), Strength=0.5).outputs[0],
    )


@feature("Add Shader: Diffuse and Glossy")
def _(s):
    m = s.ball.data.materials[0]
    s.shader(
        m,
        "AddShader",
        i0=s.node(m, "BsdfDiffuse", Color=(0.4, 0.2, 0.2)).outputs[0],
        i1=s.node(m, "BsdfAnisotropic", Color=(0.3, 0.3, 0.3), Roughness=0.2).outputs[0],
    )


@feature("group of nodes")
def _(s):
    m = s.ball.data.materials[0]
    group = bpy.data.node_groups.new("paint", "ShaderNodeTree")
    group.interface.new_socket("Tint", in_out="INPUT", socket_type="NodeSocketColor")
    group.interface.new_socket("Shader", in_out="OUTPUT", socket_type="NodeSocketShader")
    inside, outside = group.nodes.new("NodeGroupInput"), group.nodes.new("NodeGroupOutput")
    shader = group.nodes.new("ShaderNodeBsdfDiffuse")
    group.links.new(inside.outputs[0], shader.inputs["Color"])
    group.links.new(shader.outputs[0], outside.inputs[0])
    node = m.node_tree.nodes.new("ShaderNodeGroup")
    node.node_tree = group
    node.inputs[0].default_value = (0.1, 0.6, 0.5, 1)
    s.surface(m, node.outputs[0])


# Textures


def textured(name, make, target="floor", **options):
    @feature(name, **options)
    def _(s):
        m = getattr(s, target).data.materials[0]
        s.shader(m, "BsdfDiffuse", Color=make(s, m))


def uv(s, m):
    return s.node(m, "TexCoord").outputs["UV"]


textured(
    "Image Texture", lambda s, m: s.node(m, "TexImage", {"image": s.image("stripes", 128, 128, stripes)}).outputs[0]
)
textured(
    "Image Texture, Non-Color",
    lambda s, m: s.node(m, "TexImage", {"image": s.image("stripes", 128, 128, stripes, "Non-Color")}).outputs[0],
)
textured(
    "Mapping: moved, scaled",
    lambda s, m: s.node(
        m,
        "TexImage",
        {"image": s.image("stripes", 128, 128, stripes)},
        Vector=s.node(m, "Mapping", Vector=uv(s, m), Location=(0.3, 0.1, 0), Scale=(3, 2, 1)).outputs[0],
    ).outputs[0],
)
textured(
    "Mapping: turned",
    lambda s, m: s.node(
        m,
        "TexImage",
        {"image": s.image("stripes", 128, 128, stripes)},
        Vector=s.node(m, "Mapping", Vector=uv(s, m), Rotation=(0, 0, 0.7), Scale=(1.5, 1.5, 1)).outputs[0],
    ).outputs[0],
)
textured("Noise Texture, generated", lambda s, m: s.node(m, "TexNoise", Scale=4.0).outputs[0], "ball")
textured(
    "Noise Texture, colours, UV",
    lambda s, m: s.node(m, "TexNoise", Vector=uv(s, m), Scale=8.0, Detail=3.5, Distortion=0.4).outputs["Color"],
)
textured(
    "Checker Texture",
    lambda s, m: s.node(
        m, "TexChecker", Vector=uv(s, m), Color1=(0.8, 0.7, 0.1), Color2=(0.1, 0.2, 0.5), Scale=9.0
    ).outputs[0],
)
textured("Gradient Texture", lambda s, m: s.node(m, "TexGradient", {"gradient_type": "EASING"}).outputs[0])
textured(
    "Brick Texture",
    lambda s, m: s.node(
        m, "TexBrick", Vector=uv(s, m), Color1=(0.7, 0.25, 0.15), Color2=(0.4, 0.15, 0.1), Scale=6.0
    ).outputs[0],
)
textured(
    "Object coordinates",
    lambda s, m: s.node(m, "TexChecker", Vector=s.node(m, "TexCoord").outputs["Object"], Scale=2.13).outputs[0],
    "box",
)


def ramp(s, m):
    node = s.node(m, "ValToRGB", Fac=s.node(m, "TexNoise", Vector=uv(s, m), Scale=5.0).outputs[0])
    node.color_ramp.elements[0].color, node.color_ramp.elements[1].color = (0.1, 0.3, 0.6, 1), (0.9, 0.7, 0.2, 1)
    node.color_ramp.elements[0].position, node.color_ramp.elements[1].position = 0.35, 0.65
    return node.outputs[0]


textured("Color Ramp", ramp)


def curves(s, m):
    node = s.node(
        m, "RGBCurve", Color=s.node(m, "TexImage", {"image": s.image("stripes", 128, 128, stripes)}).outputs[0]
    )
    node.mapping.curves[3].points.new(0.4, 0.7)
    node.mapping.update()
    return node.outputs[0]


textured("RGB Curves", curves)
textured(
    "Mix, Multiply",
    lambda s, m: s.node(
        m,
        "Mix",
        {"data_type": "RGBA", "blend_type": "MULTIPLY"},
        Factor=0.8,
        A=s.node(m, "TexImage", {"image": s.image("stripes", 128, 128, stripes)}).outputs[0],
        B=(0.9, 0.5, 0.3),
    ).outputs[2],
)
textured(
    "Math, Hue/Saturation",
    lambda s, m: s.node(
        m,
        "HueSaturation",
        Hue=0.6,
        Saturation=1.2,
        Value=s.node(m, "Math", {"operation": "MULTIPLY"}, i0=0.8, i1=1.1).outputs[0],
        Color=s.node(m, "TexImage", {"image": s.image("stripes", 128, 128, stripes)}).outputs[0],
    ).outputs[0],
)


def painted(s, m):
    attribute = s.ball.data.color_attributes.new("paint", "FLOAT_COLOR", "POINT")
    for vertex, value in zip(s.ball.data.vertices, attribute.data):
        value.color = (0.5 + 0.5 * vertex.co.x, 0.5 + 0.5 * vertex.co.y, 0.3, 1)
    return s.node(m, "VertexColor", {"layer_name": "paint"}).outputs[0]


textured("Color Attribute", painted, "ball")


@feature("Image Texture on roughness and metallic")
def _(s):
    m = s.floor.data.materials[0]
    image = s.node(
        m,
        "TexImage",
        {
            "image": s.image(
                "mask", 128, 128, lambda u, v: [0.5 + 0.4 * math.sin(10 * u) * math.sin(14 * v)] * 3, "Non-Color"
            )
        },
    )
    s.shader(m, "BsdfPrincipled", Base_Color=(0.6, 0.5, 0.3), Roughness=image.outputs[0], Metallic=image.outputs[0])


def wave_normals(u, v):
    x, y = 0.3 * math.sin(20 * math.pi * u), 0.3 * math.sin(14 * math.pi * v)
    return (0.5 + 0.5 * x, 0.5 + 0.5 * y, 0.5 + 0.5 * math.sqrt(1 - x * x - y * y))


@feature("Normal Map")
def _(s):
    m = s.floor.data.materials[0]
    image = s.node(m, "TexImage", {"image": s.image("normals", 256, 256, wave_normals, "Non-Color", True)})
    s.shader(
        m,
        "BsdfPrincipled",
        Base_Color=(0.5, 0.5, 0.5),
        Roughness=0.3,
        Normal=s.node(m, "NormalMap", Color=image.outputs[0]).outputs[0],
    )


@feature("Bump")
def _(s):
    m = s.floor.data.materials[0]
    image = s.node(
        m,
        "TexImage",
        {
            "image": s.image(
                "heights",
                512,
                512,
                lambda u, v: [0.5 + 0.25 * math.sin(20 * math.pi * u) + 0.25 * math.sin(14 * math.pi * v)] * 3,
                "Non-Color",
                True,
            )
        },
    )
    s.shader(
        m,
        "BsdfPrincipled",
        Base_Color=(0.5, 0.5, 0.5),
        Roughness=0.3,
        Normal=s.node(m, "Bump", Height=image.outputs[0], Strength=1.0, Distance=0.15).outputs[0],
    )


# Geometry


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


# Cameras


@feature("camera: wide, vertical fit, shifted")
def _(s):
    c = s.camera.data
    c.lens, c.sensor_fit, c.shift_x, c.shift_y = 22, "VERTICAL", 0.1, -0.08


@feature("camera: tall picture")
def _(s):
    s.scene.render.resolution_x, s.scene.render.resolution_y = 80, 128


@feature("camera: orthographic")
def _(s):
    s.camera.data.type, s.camera.data.ortho_scale = "ORTHO", 5.0


@feature("camera: panorama")
def _(s):
    bpy.data.objects.remove(s.lamp)  # which only DRC would show
    s.light("POINT", 400, (2.5, -2.5, 4.5), shadow_soft_size=0.0)
    s.camera.location = (0.3, -1.6, 1.2)
    s.camera.data.type = "PANO"
    if hasattr(s.camera.data, "panorama_type"):
        s.camera.data.panorama_type = "EQUIRECTANGULAR"
    else:
        s.camera.data.cycles.panorama_type = "EQUIRECTANGULAR"


@feature("camera: depth of field", spp=512)
def _(s):
    s.camera.data.dof.use_dof = True
    s.camera.data.dof.aperture_fstop, s.camera.data.dof.focus_object = 0.12, s.ball


@feature("camera: region")
def _(s):
    r = s.scene.render
    r.use_border, r.use_crop_to_border = True, True
    r.border_min_x, r.border_max_x, r.border_min_y, r.border_max_y = 0.25, 0.75, 0.2, 0.7


@feature("motion blur: object", spp=512)
def _(s):
    s.scene.render.use_motion_blur, s.scene.render.motion_blur_shutter = True, 0.8
    for frame, x in ((0, -1.2), (2, -0.2)):
        s.ball.location.x = x
        s.ball.keyframe_insert("location", frame=frame)
    for curve in curves_of(s.ball):
        for point in curve.keyframe_points:
            point.interpolation = "LINEAR"
    s.scene.frame_set(1)


@feature("motion blur: camera", spp=512)
def _(s):
    s.scene.render.use_motion_blur, s.scene.render.motion_blur_shutter = True, 0.8
    for frame, x in ((0, 3.0), (2, 3.4)):
        s.camera.location.x = x
        s.camera.keyframe_insert("location", frame=frame)
    for curve in curves_of(s.camera):
        for point in curve.keyframe_points:
            point.interpolation = "LINEAR"
    s.scene.frame_set(1)


def curves_of(object_):
    """The F-curves of an object's action: of its first slot, where actions are layered."""
    action = object_.animation_data.action
    if hasattr(action, "fcurves"):
        return list(action.fcurves)
    return [c for layer in action.layers for strip in layer.strips for bag in strip.channelbags for c in bag.fcurves]
