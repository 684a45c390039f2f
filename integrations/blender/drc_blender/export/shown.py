"""What is shown of objects: meshes and hair, read from Blender while the depsgraph stands at one time."""

from dataclasses import dataclass

import numpy as np

from .hair import Hair, hair_of_curves, hair_of_particles, systems_of
from .mesh_data import MeshData
from .objects import MESHES, has_visible_hair, visible
from .visibility import shape_visibility

FARTHEST = 1e18  # of what the renderer takes


@dataclass
class Shown:
    """materials: of the object's slots; visibility: parameters of the shapes."""

    materials: list
    visibility: dict


@dataclass
class ShownMesh(Shown):
    """bounds: of the undeformed mesh."""

    data: MeshData
    bounds: tuple

    @property
    def positions(self):
        return self.data.positions


@dataclass
class ShownHair(Shown):
    """slot: of its material."""

    hair: Hair
    slot: int

    @property
    def positions(self):
        return self.hair.positions

    @property
    def material(self):
        return self.materials[max(0, min(self.slot, len(self.materials) - 1))]


class ObjectReader:
    def __init__(self, layer, report, is_render):
        """layer: the view layer; is_render: whether what counts for renders does, else for viewports."""
        self.layer, self.report, self.is_render = layer, report, is_render

    def parts(self, instance):
        """[(name, function that reads it)]. What is read is a Shown, or None for nothing."""
        object_, found = instance.object, []
        if visible(instance) and object_.type in MESHES:
            found.append(("", lambda: self._mesh(object_)))
        elif visible(instance) and object_.type == "CURVES":
            found.append(("", lambda: self._curves(object_)))
        elif visible(instance) and object_.type in ("POINTCLOUD", "VOLUME"):
            self.report.add(f"objects of the kind {object_.type.lower()} are not exported", object_.name)
        if object_.type == "MESH" and has_visible_hair(instance):
            for modifier, system in systems_of(object_, self.is_render):
                found.append((modifier.name, lambda m=modifier, s=system: self._particles(object_, m, s)))
        return found

    def _mesh(self, object_):
        mesh = object_.data if object_.type == "MESH" else object_.to_mesh()
        if mesh is None or not len(mesh.polygons):
            if object_.type != "MESH":
                object_.to_mesh_clear()
            return None
        data = MeshData.of(mesh)
        check(object_, "the mesh has a vertex", data.positions)
        bounds = texture_space(object_) or (data.positions.min(axis=0), data.positions.max(axis=0))
        if object_.type != "MESH":
            object_.to_mesh_clear()
        return ShownMesh(*self._looks(object_), data, bounds)

    def _curves(self, object_):
        return self._hair(object_, hair_of_curves(object_.data, np.array(object_.matrix_world)), 0)

    def _particles(self, object_, modifier, system):
        bounds = texture_space(object_) or (np.zeros(3), np.ones(3))
        hair = hair_of_particles(object_, modifier, system, self.is_render, bounds)
        return self._hair(object_, hair, system.settings.material - 1)

    def _hair(self, object_, hair, slot):
        if hair is None:
            return None
        check(object_, "the hair has a point", hair.positions)
        if not (np.nan_to_num(np.abs(hair.radii)) < FARTHEST).all():
            raise ValueError(f"{object_.name}: the hair has a radius of {FARTHEST:g} or more: make it smaller")
        return ShownHair(*self._looks(object_), hair, slot)

    def _looks(self, object_):
        # Of the slots, which may have the object's materials rather than the mesh's.
        materials = [slot.material for slot in object_.material_slots] or [None]
        if self.layer.material_override is not None:
            materials = [self.layer.material_override] * len(materials)
        used = [m.original if m is not None else None for m in materials]
        return used, shape_visibility(object_, self.layer, self.report)


def check(object_, what, positions):
    if not (np.abs(positions) < FARTHEST).all():
        raise ValueError(f"{object_.name}: {what} at no number or farther than {FARTHEST:g}: delete it")


def texture_space(object_):
    """(low, high) of Blender's generated coordinates: the bounds of the mesh without modifiers; None if there is none."""
    original = object_.original.data if object_.original is not None else None
    if original is not None and hasattr(original, "texspace_location"):
        middle, half = np.array(original.texspace_location), np.array(original.texspace_size)
        return middle - half, middle + half
    return None
