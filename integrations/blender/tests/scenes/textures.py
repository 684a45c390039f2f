"""Textures and the nodes between them and a shader."""

import math

from stage import feature


def textured(name, make, target="floor", **options):
    @feature(name, **options)
    def _(s):
        m = getattr(s, target).active_material
        s.shader(m, "BsdfDiffuse", Color=make(s, m))


def uv(s, m):
    return s.node(m, "TexCoord").outputs["UV"]


textured("Image Texture", lambda s, m: s.texture(m, s.striped()))
textured(
    "Image Texture, Non-Color",
    lambda s, m: s.texture(m, s.striped("Non-Color")),
)
textured(
    "Mapping: moved, scaled",
    lambda s, m: s.texture(
        m, s.striped(), s.node(m, "Mapping", Vector=uv(s, m), Location=(0.3, 0.1, 0), Scale=(3, 2, 1)).outputs[0]
    ),
)
textured(
    "Mapping: turned",
    lambda s, m: s.texture(
        m, s.striped(), s.node(m, "Mapping", Vector=uv(s, m), Rotation=(0, 0, 0.7), Scale=(1.5, 1.5, 1)).outputs[0]
    ),
)
textured("Noise Texture, generated", lambda s, m: s.node(m, "TexNoise", Scale=4.0).outputs[0], "ball")
textured(
    "Noise Texture, colours, UV",
    lambda s, m: s.node(m, "TexNoise", Vector=uv(s, m), Scale=8.0, Detail=3.5, Distortion=0.4).outputs["Color"],
)
textured(
    "Noise Texture, ridged, 2D",
    lambda s, m: s.node(
        m,
        "TexNoise",
        {"noise_type": "RIDGED_MULTIFRACTAL", "noise_dimensions": "2D"},
        Vector=uv(s, m),
        Scale=5.0,
        Offset=0.9,
        Gain=1.5,
    ).outputs[0],
)
textured(
    "Voronoi Texture, colours",
    lambda s, m: s.node(m, "TexVoronoi", Vector=uv(s, m), Scale=9.0).outputs["Color"],
)
textured(
    "Voronoi Texture, distance to edge",
    lambda s, m: s.node(
        m,
        "TexVoronoi",
        {"feature": "DISTANCE_TO_EDGE", "voronoi_dimensions": "2D", "normalize": True},
        Vector=uv(s, m),
        Scale=8.0,
    ).outputs["Distance"],
)
textured(
    "Voronoi Texture, smooth, octaves, generated",
    lambda s, m: s.node(
        m,
        "TexVoronoi",
        {"feature": "SMOOTH_F1", "distance": "MANHATTAN", "normalize": True},
        Scale=4.0,
        Detail=1.5,
        Smoothness=0.6,
    ).outputs["Distance"],
    "ball",
)
textured(
    "Wave Texture",
    lambda s, m: s.node(
        m, "TexWave", {"wave_type": "RINGS"}, Vector=uv(s, m), Scale=1.5, Distortion=4.0, Detail_Scale=1.5
    ).outputs["Color"],
)
textured(
    "Magic Texture",
    lambda s, m: s.node(m, "TexMagic", {"turbulence_depth": 4}, Vector=uv(s, m), Scale=3.0).outputs["Color"],
)


def tiles(s, m):
    """Tiles of random colours."""
    scaled = s.node(m, "VectorMath", {"operation": "SCALE"}, i0=uv(s, m), Scale=12.0).outputs[0]
    cell = s.node(m, "VectorMath", {"operation": "FLOOR"}, i0=scaled).outputs[0]
    return s.node(m, "TexWhiteNoise", {"noise_dimensions": "2D"}, Vector=cell).outputs["Color"]


textured("White Noise Texture, tiles", tiles)
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
    node = s.node(m, "RGBCurve", Color=s.texture(m, s.striped()))
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
        A=s.texture(m, s.striped()),
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
        Color=s.texture(m, s.striped()),
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
    m = s.floor.active_material
    image = s.texture(
        m, s.image("mask", 128, 128, lambda u, v: [0.5 + 0.4 * math.sin(10 * u) * math.sin(14 * v)] * 3, "Non-Color")
    )
    s.shader(m, "BsdfPrincipled", Base_Color=(0.6, 0.5, 0.3), Roughness=image, Metallic=image)


def wave_normals(u, v):
    x, y = 0.3 * math.sin(20 * math.pi * u), 0.3 * math.sin(14 * math.pi * v)
    return (0.5 + 0.5 * x, 0.5 + 0.5 * y, 0.5 + 0.5 * math.sqrt(1 - x * x - y * y))


@feature("Normal Map")
def _(s):
    m = s.floor.active_material
    image = s.texture(m, s.image("normals", 256, 256, wave_normals, "Non-Color", True))
    s.shader(
        m,
        "BsdfPrincipled",
        Base_Color=(0.5, 0.5, 0.5),
        Roughness=0.3,
        Normal=s.node(m, "NormalMap", Color=image).outputs[0],
    )


@feature("Bump")
def _(s):
    m = s.floor.active_material
    image = s.texture(
        m,
        s.image(
            "heights",
            512,
            512,
            lambda u, v: [0.5 + 0.25 * math.sin(20 * math.pi * u) + 0.25 * math.sin(14 * math.pi * v)] * 3,
            "Non-Color",
            True,
        ),
    )
    s.shader(
        m,
        "BsdfPrincipled",
        Base_Color=(0.5, 0.5, 0.5),
        Roughness=0.3,
        Normal=s.node(m, "Bump", Height=image, Strength=1.0, Distance=0.15).outputs[0],
    )
