"""Hair: the strands of Curves objects and of particle systems, as pbrt's curves."""

from dataclasses import dataclass, replace

import numpy as np

from ..materials.points import Points
from .cache import digest
from .objects import invertible

DEFAULT_RADIUS = 0.005  # of Curves without the attribute
# How values of an attribute's kind are called, and how many there are.
ATTRIBUTES = {
    "FLOAT": ("value", 1),
    "FLOAT2": ("vector", 2),
    "FLOAT_VECTOR": ("vector", 3),
    "FLOAT_COLOR": ("color", 4),
    "BYTE_COLOR": ("color", 4),
}


@dataclass
class Hair:
    """positions: keys x 3, object space; offsets: of each strand's first key, and the number of keys; radii: of keys;
    roots: of each strand, for materials."""

    positions: np.ndarray
    offsets: np.ndarray
    radii: np.ndarray
    roots: Points

    @property
    def key(self):
        return digest(self.positions, self.offsets, self.radii)

    @property
    def strands(self):
        return len(self.offsets) - 1

    def stretched(self, matrix):
        """The strands in another space, 4 x 4, as wide as before and of the same looks."""
        return replace(self, positions=(self.positions @ matrix[:3, :3].T).astype(np.float32))

    def roots_of_pieces(self, pieces):
        """What materials know of pieces of strands: the root's, but where along the strand they are."""
        points = self.roots.take(pieces.strand, len(pieces.strand))
        points.along = pieces.along.astype(np.float32)
        return points


def roots_of(positions, to_world, bounds, uvs):
    """What materials know of strands with these roots, object space. bounds: (low, high) of generated coordinates."""
    low, high = (np.asarray(b, dtype=np.float32) for b in bounds)
    matrix = np.asarray(to_world, dtype=np.float32)
    count = len(positions)
    return Points(
        count,
        uvs,
        generated=(positions - low) / np.maximum(high - low, 1e-12),
        object=positions,
        position=positions @ matrix[:3, :3].T + matrix[:3, 3],
        along=np.full((count, 1), 0.5, dtype=np.float32),
        # Of numbers of its own: those of other renderers are others.
        random=np.random.default_rng(1).random((count, 1), dtype=np.float32),
    )


def hair_of_curves(curves, to_world):
    """Of an evaluated Curves; None if it has no strands."""
    count = len(curves.points)
    if not count:
        return None
    offsets = np.empty(len(curves.curves) + 1, dtype=np.int32)
    curves.curve_offset_data.foreach_get("value", offsets)
    found = {attribute.name: attribute for attribute in curves.attributes}
    positions = values_of(found.pop("position"))
    radius = found.pop("radius", None)
    is_radius = radius is not None and radius.domain == "POINT" and radius.data_type == "FLOAT"
    radii = values_of(radius)[:, 0] if is_radius else np.full(count, DEFAULT_RADIUS, np.float32)
    bounds = positions.min(axis=0), positions.max(axis=0)
    uvs, others = {}, {}
    for name, attribute in found.items():
        values = None if name.startswith(".") else values_of(attribute)
        if values is None:
            continue
        if attribute.domain == "POINT":  # that of the root
            values = values[offsets[:-1]]
        if attribute.data_type == "FLOAT2":
            uvs[name] = values
        others[name] = as_colours(values)
        if name == "surface_uv_coordinate":
            uvs[""] = others[name][:, :2]
    roots = roots_of(positions[offsets[:-1]], to_world, bounds, uvs)
    roots.attributes = others
    return Hair(positions, offsets, radii, roots)


def values_of(attribute):
    """Points or curves x columns; None for kinds that materials do not read."""
    what, columns = ATTRIBUTES.get(attribute.data_type, (None, 0))
    if what is None:
        return None
    values = np.empty(len(attribute.data) * columns, dtype=np.float32)
    attribute.data.foreach_get(what, values)
    return values.reshape(-1, columns)


def as_colours(values):
    """n x 3, of numbers, vectors of two and colours with alpha."""
    if values.shape[1] == 1:
        return np.repeat(values, 3, axis=1)
    if values.shape[1] == 2:
        return np.concatenate([values, np.zeros((len(values), 1), dtype=np.float32)], axis=1)
    return values[:, :3]


def systems_of(object_, is_render):
    """(modifier, particle system) of the object's hair that is shown as strands."""
    for modifier in object_.modifiers:
        shown = modifier.show_render if is_render else modifier.show_viewport
        if modifier.type != "PARTICLE_SYSTEM" or not shown:
            continue
        settings = modifier.particle_system.settings
        if settings.type == "HAIR" and settings.render_type == "PATH":
            yield modifier, modifier.particle_system


def hair_of_particles(object_, modifier, system, is_render, bounds):
    """Of a particle system of an evaluated object; None if it has no strands."""
    settings = system.settings
    parents, children = len(system.particles), len(system.child_particles)
    if not is_render:
        children = children * settings.display_percentage // 100
    first = 0 if children == 0 or settings.use_parent_particles else parents
    numbers = range(first, parents + children)
    keys = (1 << (settings.render_step if is_render else settings.display_step)) + 1
    if settings.kink == "SPIRAL":
        keys += settings.kink_extra_steps
    to_world = invertible(np.array(object_.matrix_world))
    if not numbers or to_world is None:
        return None
    world = np.empty((len(numbers), keys, 3))
    for i, number in enumerate(numbers):
        world[i] = [system.co_hair(object_, particle_no=number, step=step)[:] for step in range(keys)]
    # Only children have the keys of a kink. Of keys that a strand does not have, Blender says that they are at zero.
    missing = np.cumprod((world == 0).all(axis=2)[:, ::-1], axis=1)[:, ::-1].astype(bool)
    if missing.all():
        return None
    inverse = np.linalg.inv(to_world)
    positions = (world @ inverse[:3, :3].T + inverse[:3, 3]).astype(np.float32)
    offsets = np.concatenate([[0], np.cumsum(keys - missing.sum(axis=1))])
    uvs = uvs_of_roots(object_.data, modifier, system, numbers)
    roots = roots_of(positions[:, 0], to_world, bounds, uvs)
    return Hair(positions[~missing], offsets, radii_along(positions, missing, settings), roots)


def uvs_of_roots(mesh, modifier, system, numbers):
    """On the mesh that the strands grow on: strands x 2 by the map's name; "" is the map that is rendered."""
    particles, uvs = list(system.particles), {}
    for i, layer in enumerate(mesh.uv_layers):
        found = [
            system.uv_on_emitter(modifier, particle=particles[min(n, len(particles) - 1)], particle_no=n, uv_no=i)[:]
            for n in numbers
        ]
        uvs[layer.name] = np.array(found, dtype=np.float32)
        if layer.active_render:
            uvs[""] = uvs[layer.name]
    return uvs


def radii_along(keys, missing, settings):
    """Of the strands of a particle system. keys: strands x keys x 3; missing: which of them are not there, at the ends."""
    lengths = np.where(missing[:, 1:], 0, np.linalg.norm(np.diff(keys, axis=1), axis=2))
    along = np.concatenate([np.zeros((len(keys), 1)), np.cumsum(lengths, axis=1)], axis=1)
    taper = np.clip(1 - along / np.maximum(along[:, -1:], 1e-20), 0, 1)
    shape = settings.shape
    if shape:
        taper = taper ** (1 + shape if shape < 0 else 1 / (1 - min(shape, 0.999)))
    scale = settings.radius_scale / 2
    root, tip = settings.root_radius * scale, settings.tip_radius * scale
    radii = taper * (root - tip) + tip
    if settings.use_close_tip:
        radii[np.arange(len(keys)), keys.shape[1] - 1 - missing.sum(axis=1)] = 0
    return radii[~missing].astype(np.float32)
