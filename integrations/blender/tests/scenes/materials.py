"""Shaders, on the ball as a rule."""

import math

import bpy

from stage import feature


def on_ball(name, kind, settings=(), **inputs):
    options = {k: inputs.pop(k) for k in ("reason", "block", "mean") if k in inputs}

    @feature(name, **options)
    def _(s):
        s.shader(s.ball.active_material, kind, settings, **inputs)


on_ball("Principled, plastic", "BsdfPrincipled", Base_Color=(0.8, 0.3, 0.1), Roughness=0.3)
on_ball("Principled, rough diffuse", "BsdfPrincipled", Base_Color=(0.8, 0.3, 0.1), Diffuse_Roughness=0.8, Roughness=0.5)
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
on_ball("Diffuse, rough", "BsdfDiffuse", Color=(0.3, 0.7, 0.4), Roughness=0.8)
on_ball("Glossy, sharp", "BsdfAnisotropic", Color=(0.8, 0.7, 0.5), Roughness=0.0)
on_ball("Glossy, rough 0.4", "BsdfAnisotropic", Color=(0.8, 0.5, 0.3), Roughness=0.4)
on_ball("Metallic", "BsdfMetallic", Base_Color=(0.9, 0.6, 0.4), Edge_Tint=(0.7, 0.8, 1.0), Roughness=0.3)
on_ball("Glass, clear", "BsdfGlass", Color=(1.0, 1.0, 1.0), Roughness=0.0, IOR=1.5)
on_ball(
    "Glass, coloured, rough",
    "BsdfGlass",
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
    m = s.ball.active_material
    a = s.node(m, "BsdfDiffuse", Color=(0.7, 0.2, 0.2))
    b = s.node(m, "BsdfAnisotropic", Color=(0.9, 0.9, 0.9), Roughness=0.2)
    s.shader(m, "MixShader", i0=0.3, i1=a.outputs[0], i2=b.outputs[0])


@feature("Mix Shader: by Fresnel")
def _(s):
    m = s.ball.active_material
    a = s.node(m, "BsdfDiffuse", Color=(0.7, 0.2, 0.2))
    b = s.node(m, "BsdfAnisotropic", Color=(1.0, 1.0, 1.0), Roughness=0.1)
    s.shader(m, "MixShader", i0=s.node(m, "Fresnel", IOR=1.5).outputs[0], i1=a.outputs[0], i2=b.outputs[0])


@feature("Mix Shader: by Layer Weight")
def _(s):
    m = s.ball.active_material
    a = s.node(m, "BsdfDiffuse", Color=(0.1, 0.3, 0.5))
    b = s.node(m, "BsdfAnisotropic", Color=(1.0, 1.0, 1.0), Roughness=0.2)
    fresnel = s.node(m, "LayerWeight", Blend=0.4).outputs["Fresnel"]
    s.shader(m, "MixShader", i0=fresnel, i1=a.outputs[0], i2=b.outputs[0])


@feature("Mix Shader: glass by Fresnel", spp=1024)
def _(s):
    m = s.ball.active_material
    a = s.node(m, "BsdfRefraction", Color=(0.9, 0.95, 1.0), Roughness=0.0, IOR=1.45)
    b = s.node(m, "BsdfAnisotropic", Color=(1.0, 1.0, 1.0), Roughness=0.0)
    s.shader(m, "MixShader", i0=s.node(m, "Fresnel", IOR=1.45).outputs[0], i1=a.outputs[0], i2=b.outputs[0])


@feature("Mix Shader: cut-out by an image")
def _(s):
    m = s.box.active_material
    image = s.texture(
        m,
        s.image(
            "holes", 64, 64, lambda u, v: [1.0 if math.sin(12 * u) * math.sin(12 * v) > 0 else 0.0] * 3, "Non-Color"
        ),
    )
    s.shader(
        m,
        "MixShader",
        i0=image,
        i1=s.node(m, "BsdfTransparent").outputs[0],
        i2=s.node(m, "BsdfDiffuse", Color=(0.7, 0.6, 0.2)).outputs[0],
    )


@feature("Add Shader: Diffuse and Emission")
def _(s):
    m = s.ball.active_material
    s.shader(
        m,
        "AddShader",
        i0=s.node(m, "BsdfDiffuse", Color=(0.5, 0.2, 0.2)).outputs[0],
        i1=s.node(m, "Emission", Color=(0.1, 0.3, 0.8), Strength=0.5).outputs[0],
    )


@feature("Add Shader: Diffuse and Glossy")
def _(s):
    m = s.ball.active_material
    s.shader(
        m,
        "AddShader",
        i0=s.node(m, "BsdfDiffuse", Color=(0.4, 0.2, 0.2)).outputs[0],
        i1=s.node(m, "BsdfAnisotropic", Color=(0.3, 0.3, 0.3), Roughness=0.2).outputs[0],
    )


@feature("group of nodes")
def _(s):
    m = s.ball.active_material
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
