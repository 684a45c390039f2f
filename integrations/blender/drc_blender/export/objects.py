"""What a depsgraph shows: each visible mesh or lamp with its matrices, read while the depsgraph stands at one time."""

import numpy as np

MESHES = {"MESH", "CURVE", "SURFACE", "META", "FONT"}  # what can be made a mesh


def key_of(instance):
    object_ = instance.object.original if instance.object.original is not None else instance.object
    parent = instance.parent.original.name_full if instance.parent is not None else ""
    return (object_.name_full, parent, tuple(instance.persistent_id) if instance.is_instance else ())


def visible(instance):
    return instance.show_self and not getattr(instance.object, "hide_render", False)


def matrices_at(depsgraph):
    """Of all that is shown, by key, as 4 x 4 arrays."""
    return {
        key_of(i): np.array(i.matrix_world)
        for i in depsgraph.object_instances
        if visible(i) and i.object.type in MESHES | {"LIGHT"}
    }
