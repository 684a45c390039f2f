"""A key of a node tree's state: textures are baked again only if it has changed."""

from ..export.cache import digest

_IGNORED = {
    "location",
    "location_absolute",
    "width",
    "width_hidden",
    "height",
    "select",
    "name",
    "label",
    "parent",
    "hide",
    "show_options",
    "show_preview",
    "show_texture",
    "use_custom_color",
    "color",
    "rna_type",
    "dimensions",
    "warning_propagation",
}


def tree_key(tree):
    import bpy

    # Versions of Blender have their own random numbers in some textures.
    return digest(repr((bpy.app.version, _tree(tree, 0))))


def _tree(tree, depth):
    if depth > 16:
        return None
    nodes = [_node(n, depth) for n in tree.nodes]
    links = sorted(
        (l.from_node.name, l.from_socket.identifier, l.to_node.name, l.to_socket.identifier, l.is_muted)
        for l in tree.links
    )
    return nodes, links


def _plain(value):
    return tuple(value) if hasattr(value, "__len__") and not isinstance(value, str) else value


def _node(node, depth):
    state = [node.name, node.bl_idname, node.mute]
    for prop in node.bl_rna.properties:
        if prop.identifier in _IGNORED or prop.type in ("POINTER", "COLLECTION"):
            continue
        state.append((prop.identifier, repr(_plain(getattr(node, prop.identifier)))))
    state += [
        (s.identifier, repr(_plain(s.default_value)))
        for s in node.inputs
        if hasattr(s, "default_value") and s.type not in ("OBJECT", "IMAGE", "MATERIAL", "COLLECTION")
    ]
    state += [
        (s.identifier, repr(_plain(s.default_value)))
        for s in node.outputs
        if node.type in ("VALUE", "RGB") and hasattr(s, "default_value")
    ]
    if getattr(node, "image", None) is not None:
        state.append(_image(node.image))
    if getattr(node, "color_ramp", None) is not None:
        ramp = node.color_ramp
        state.append((ramp.interpolation, ramp.color_mode, [(e.position, tuple(e.color)) for e in ramp.elements]))
    if hasattr(node, "mapping") and hasattr(node.mapping, "curves"):
        state.append([[(tuple(p.location), p.handle_type) for p in c.points] for c in node.mapping.curves])
    if getattr(node, "object", None) is not None:
        state.append([tuple(row) for row in node.object.matrix_world])
    if getattr(node, "node_tree", None) is not None:
        state.append(_tree(node.node_tree, depth + 1))
    return state


def _image(image):
    import os

    path = _path(image)
    changed = os.path.getmtime(path) if path and os.path.exists(path) else 0
    state = [image.name_full, path, changed, tuple(image.size), image.colorspace_settings.name]
    if image.is_dirty or image.source == "GENERATED":  # painted or made, so that there is no file to look at
        import numpy as np

        values = np.empty(len(image.pixels), dtype=np.float32)
        image.pixels.foreach_get(values)
        state.append(digest(values))
    return state


def _path(image):
    import bpy

    return bpy.path.abspath(image.filepath, library=image.library) if image.filepath else ""
