"""What a depsgraph shows: each visible mesh or lamp with its matrices, read while the depsgraph stands at one time."""

import numpy as np

MESHES = {"MESH", "CURVE", "SURFACE", "META", "FONT"}  # what can be made a mesh


def key_of(instance):
    object_ = instance.object.original if instance.object.original is not None else instance.object
    parent = instance.parent.original.name_full if instance.parent is not None else ""
    return (object_.name_full, parent, tuple(instance.persistent_id) if instance.is_instance else ())


SQUEEZED = 1e-7  # an axis is nothing, as a share of the longest
THIN = 1e-4  # what it is made, as a share of the second


def invertible(matrix):
    """The matrix of an object that the renderer can invert: what a scale of zero has made flat is as thin as paper. None
    for what is squeezed to a line or a point, which nobody sees. Raises ValueError if there is no number in it."""
    if not np.isfinite(matrix).all():
        raise ValueError("its place or scale is no number")
    turn, scale, along = np.linalg.svd(matrix[:3, :3])
    if scale[2] > SQUEEZED * scale[0]:
        return matrix
    if scale[1] <= SQUEEZED * scale[0]:
        return None
    made = matrix.copy()
    made[:3, :3] = turn @ np.diag([scale[0], scale[1], THIN * scale[1]]) @ along
    return made


STRETCHED = 0.01  # how far scales of the axes are apart, as a share of the largest, that curves are stretched by


def stretch_of(matrix):
    """What stretches a matrix that does not scale alike in all directions, itself of volume one; None if it does. 4 x 4."""
    _, scale, along = np.linalg.svd(matrix[:3, :3])
    if scale[0] - scale[2] <= STRETCHED * scale[0]:
        return None
    made = np.eye(4)
    made[:3, :3] = along.T @ np.diag(scale / np.prod(scale) ** (1 / 3)) @ along
    return made


def visible(instance):
    return instance.show_self and not getattr(instance.object, "hide_render", False)


def has_visible_hair(instance):
    return instance.show_particles and not getattr(instance.object, "hide_render", False)


def matrices_at(depsgraph):
    """Of all that is shown, by key, as 4 x 4 arrays."""
    return {
        key_of(i): np.array(i.matrix_world)
        for i in depsgraph.object_instances
        if visible(i) and i.object.type in MESHES | {"CURVES", "LIGHT"}
    }
