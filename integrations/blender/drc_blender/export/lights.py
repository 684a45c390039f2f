"""Blender's lamps as pbrt lights, with the same radiometry."""

import math

import numpy as np

from ..materials.closures import ClosureReader, emitted
from ..materials.expressions import as_colour, combined, constant, product
from ..materials.node_links import active_output, tree_of
from .directed_lamps import NARROW, along_the_axis, directed_lines
from .objects import invertible
from .pbrt_text import statement

HIDDEN = {"bool visibletocamera": False}
ELLIPSE_CORNERS = 128
LEAST_RADIUS = 1e-6  # below which a lamp is a point
LEAST_SPREAD = 1.0  # degrees: that of Cycles


def emission_of(light, reader, place):
    """An Expression: the colour with its strength, as Blender has it before the lamp's own geometry counts."""
    colour = np.array(light.color, dtype=float)
    if getattr(light, "use_temperature", False):
        colour = colour * np.array(light.temperature_color)
    colour = constant(*(colour * light.energy * 2.0 ** getattr(light, "exposure", 0.0)))
    tree = tree_of(light)
    output = active_output(tree, "OUTPUT_LIGHT") if tree is not None else None
    if output is None:
        return colour
    return as_colour(product(colour, emitted(ClosureReader(reader.at(*place)).surface_of(output))))


def lamp_lines(object_, matrix, reader, files, report):
    """files: the FileCache of pictures."""
    light, place = object_.data, (object_.name,)
    emission, matrix = emission_of(light, reader, place), np.array(matrix, dtype=float)
    if not getattr(light, "use_shadow", True):
        report.add("a lamp without shadows has no equal; it has them", *place)
    if light.type in ("SUN", "SPOT") and not np.any(matrix[:3, 2]):
        report.add("a lamp that is scaled to nothing has no direction; it is left out", *place)
        return []
    narrow = light.type == "SPOT" and math.degrees(light.spot_size) < NARROW
    colour = along_the_axis(emission)
    if not emission.is_constant and not narrow:
        if light.type in ("POINT", "SPOT") and invertible(matrix) is matrix:
            if light.shadow_soft_size > LEAST_RADIUS:
                report.add("a lamp whose light depends on its direction is a point; its shadows are sharp", *place)
            size = lamp_size(light)
            return directed_lines(light, matrix, combined(lambda e: e * size, emission), files, report, place)
        report.add("textures of suns and areas have no equal; they shine as straight ahead", *place)
    if not np.any(colour > 0):
        return []
    if np.any(colour < 0):
        report.add("lamps that take light away have no equal; what is negative is black", *place)
        colour = np.maximum(colour, 0)
    kinds = {"POINT": point, "SUN": sun, "SPOT": spot, "AREA": area}
    return kinds[light.type](light, matrix, colour, report, place)


def is_normalized(light):
    """Whether the energy is that of the whole lamp, whatever its size."""
    return getattr(light, "normalize", True)


# Blender's camera does not see lamps, and they block no light.
WITHOUT_BODY = {"bool visibletocamera": False, "bool blockslight": False}


def point(light, matrix, colour, report, place):
    params = {"rgb I": colour / (4 * math.pi), "point3 from": matrix[:3, 3]}
    return [statement("LightSource", "point", params=with_radius(params, light))]


def with_radius(params, light):
    """Of a point or a spot: with the lamp's extent. Without normalization, the intensity is the radiance's."""
    if light.shadow_soft_size <= LEAST_RADIUS:
        return params
    return {**params, "rgb I": params["rgb I"] * lamp_size(light), "float radius": light.shadow_soft_size}


def lamp_size(light):
    """What the energy of a point or a spot is multiplied by."""
    radius = light.shadow_soft_size
    return 1 if is_normalized(light) or radius <= LEAST_RADIUS else math.pi * radius**2


def direction_of(matrix):
    """Lamps shine along their -z."""
    return -matrix[:3, 2] / np.linalg.norm(matrix[:3, 2])


def sun(light, matrix, colour, report, place):
    """Its energy is an irradiance."""
    angle = min(light.angle, math.pi)
    irradiance = colour if is_normalized(light) else colour * disk_solid_angle(angle)
    return [sun_line(irradiance, -direction_of(matrix), angle, HIDDEN)]


def disk_solid_angle(angle):
    """Of a disk that is seen under this angle, projected on a surface that faces it: irradiance over radiance."""
    return math.pi * math.sin(angle / 2) ** 2


def sun_line(irradiance, towards, angle, audience):
    """angle: that it is seen under; towards: the direction of its middle; audience: parameters that say who sees it."""
    params = {"rgb L": irradiance, "point3 from": towards, "point3 to": (0, 0, 0)}
    if angle > 0:
        params["float angle"] = math.degrees(angle)
        params.update(audience)
    return statement("LightSource", "distant", params=params)


def spot(light, matrix, colour, report, place):
    """Its cone does not change its intensity. pbrt's edge is the same curve of the angle's cosine."""
    scale = np.linalg.norm(matrix[:3, :3], axis=0)
    if np.ptp(scale) > 1e-3 * scale.max():
        report.add("a spot with unequal scales has no equal; its cone is round", *place)
    edge = math.cos(light.spot_size / 2)
    full = edge + (1 - edge) * light.spot_blend
    cone = math.degrees(light.spot_size / 2)
    fade = cone - math.degrees(math.acos(min(1.0, full)))
    position = matrix[:3, 3]
    params = {
        "rgb I": colour / (4 * math.pi),
        "point3 from": position,
        "point3 to": position + direction_of(matrix),
        "float coneangle": max(cone, 1e-3),
        "float conedeltaangle": max(fade, 1e-3),
    }
    return [statement("LightSource", "spot", params=with_radius(params, light))]


def area(light, matrix, colour, report, place):
    """One-sided. Its energy is that of the whole lamp: Lambert's law makes it pi times area times radiance."""
    wide = light.size
    tall = light.size_y if light.shape in ("RECTANGLE", "ELLIPSE") else light.size
    x, y, origin = matrix[:3, 0] * wide / 2, matrix[:3, 1] * tall / 2, matrix[:3, 3]
    round_ = light.shape in ("DISK", "ELLIPSE")
    size = float(np.linalg.norm(np.cross(x, y))) * (math.pi if round_ else 4)
    if size <= 0:
        return []
    radiance = colour / (math.pi * size) if is_normalized(light) else colour / math.pi
    if round_:
        turns = np.arange(ELLIPSE_CORNERS) * (2 * math.pi / ELLIPSE_CORNERS)
        # The polygon has the ellipse's area.
        grow = math.sqrt(math.pi / (ELLIPSE_CORNERS / 2 * math.sin(2 * math.pi / ELLIPSE_CORNERS)))
        ring = origin + grow * (np.cos(turns)[:, None] * x + np.sin(turns)[:, None] * y)
        corners = np.concatenate([[origin], ring])
        triangles = [(0, 1 + (i + 1) % ELLIPSE_CORNERS, 1 + i) for i in range(ELLIPSE_CORNERS)]
    else:
        corners = np.array([origin - x - y, origin + x - y, origin + x + y, origin - x + y])
        triangles = [(0, 2, 1), (0, 3, 2)]
    if np.linalg.det(matrix[:3, :3]) < 0:  # mirrored: it still shines along its -z
        triangles = [t[::-1] for t in triangles]
    emission = {"rgb L": radiance}
    if light.spread < math.pi:
        emission["float spread"] = max(math.degrees(light.spread), LEAST_SPREAD)
    corners_and_faces = {"point3 P": corners.reshape(-1), "integer indices": np.array(triangles).reshape(-1)}
    return [
        "AttributeBegin",
        statement("AreaLightSource", "diffuse", params=emission),
        statement("Shape", "trianglemesh", params={**corners_and_faces, **WITHOUT_BODY}),
        "AttributeEnd",
    ]
