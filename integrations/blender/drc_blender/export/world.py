"""The world as an infinite light: constant, or a picture of all directions."""

import numpy as np

from ..materials.closures import ClosureReader, emitted
from ..materials.expressions import as_colour
from ..materials.node_links import tree_of
from ..materials.points import Points
from ..materials.ray_kinds import probes, values
from ..materials.textures import evaluated
from ..materials.tree_key import tree_key
from .cache import digest
from .equal_area import directions
from .image_files import pfm_bytes
from .lights import HIDDEN, disk_solid_angle, sun_line
from .pbrt_text import statement
from .report import Report

BACKDROP = {"bool illuminates": False}  # what the camera alone sees


def world_lines(world, reader, cache, side):
    """side: pixels of the picture's side."""
    if world is None:
        return []
    visible = getattr(getattr(world, "cycles_visibility", None), "camera", True)
    tree = tree_of(world)
    if tree is None:
        return constant_lines(np.array(world.color, dtype=float), {} if visible else HIDDEN)
    reader = reader.at(world.name)
    seen = reader.for_ray("camera")
    radiance = emitted(ClosureReader(seen).background(tree))
    if not seen.rays_matter:
        return radiance_lines(radiance, seen, tree, cache, side, {} if visible else HIDDEN)
    lighting = reader.for_ray("diffuse")
    light = emitted(ClosureReader(lighting).background(tree))
    mirrored = emitted(ClosureReader(reader.for_ray("glossy", Report())).background(tree))
    points = probes()
    if not np.allclose(values(as_colour(mirrored), points), values(as_colour(light), points), rtol=1e-3):
        reader.report.add("mirrors show the world that lights the scene", *reader.place)
    lines = radiance_lines(light, lighting, tree, cache, side, HIDDEN)
    return lines + (radiance_lines(radiance, seen, tree, cache, side, BACKDROP) if visible else [])


def radiance_lines(radiance, reader, tree, cache, side, audience):
    """Lights at infinity. audience: parameters that say who sees them."""
    if radiance.is_constant:
        return constant_lines(np.broadcast_to(radiance.constant(), 3), audience)

    def make():
        # Four directions a pixel, so that small suns keep their energy.
        way = directions(2 * side).reshape(-1, 3).astype(np.float32)
        points = Points(len(way), {"": way[:, :2]}, generated=way, object=way, position=way, normal=way)
        values = np.maximum(evaluated(radiance, points, 3), 0)
        return pfm_bytes(values.reshape(side, 2, side, 2, 3).mean(axis=(1, 3)))

    file = cache.file(digest("world", tree_key(tree), side, reader.ray), "pfm", make)
    lines = [infinite({"string filename": file}, audience)]
    for sky in reader.skies:
        if sky.sun_radiance is not None:
            lines += sun_lines(sky, radiance, reader, audience)
    return lines


def sun_lines(sky, radiance, reader, audience):
    """The sun of a Sky Texture, as bright as the nodes behind it make it."""
    way = np.asarray(sky.sun_direction, dtype=np.float32)[None]
    points = Points(1, {"": way[:, :2]}, generated=way, object=way, position=way, normal=way)
    without = radiance(points)[0]
    reader.suns_shown = True
    added = radiance(points)[0] - without
    reader.suns_shown = False
    if not np.any(added > 0):
        return []
    irradiance = np.maximum(added, 0) * disk_solid_angle(sky.sun_angle)
    return [sun_line(irradiance, sky.sun_direction, sky.sun_angle, audience)]


def infinite(params, audience):
    return statement("LightSource", "infinite", params={**params, **audience})


def constant_lines(radiance, audience):
    if not np.any(radiance > 0):
        return []
    return [infinite({"rgb L": np.maximum(radiance, 0)}, audience)]
