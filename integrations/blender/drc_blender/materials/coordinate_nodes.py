"""Nodes that say where a point is: coordinates, attributes, and their mapping. Each function takes the
reader and the output socket, and returns the expression of that output."""

import numpy as np

from .colour_maths import rotation
from .expressions import ALONG, SPACE, UV, Expression, as_number, combined, constant


def _coordinates(reader, at):
    name = at.socket.name
    if name == "UV":
        return uv_map("")
    if name == "Normal":
        return of_place("normal")
    if name == "Object":
        if at.node.object is None:
            return of_place("object")
        inverse = np.linalg.inv(np.array(at.node.object.matrix_world)).astype(np.float32)
        return combined(lambda p: p @ inverse[:3, :3].T + inverse[:3, 3], of_place("position"))
    if name == "Generated":
        return of_place("generated")
    return reader.unsupported(
        at, f"the texture coordinate '{name}' has no equal; Generated is used", of_place("generated")
    )


def of_place(name):
    def values(points):
        found = getattr(points, name)
        return np.zeros((1, 3), dtype=np.float32) if found is None else found

    return Expression(values, [(SPACE,)])


def uv_map(name):
    def values(points):
        uv = points.uv(name)
        return np.concatenate([uv, np.zeros((len(uv), 1), dtype=np.float32)], axis=1)

    return Expression(values, [(UV, name)])


def _uv_map(reader, at):
    return uv_map(at.node.uv_map)


def _geometry(reader, at):
    name = at.socket.name
    if name in ("Position", "Normal", "True Normal"):
        return of_place("position" if name == "Position" else "normal")
    if name == "Backfacing":
        return reader.unsupported(at, "which side is seen cannot be told; the front is taken", constant(0.0))
    return reader.unsupported(at, f"'{name}' of Geometry has no equal; 0 is used", constant(0.0))


def _attribute(reader, at):
    name = getattr(at.node, "layer_name", None) or getattr(at.node, "attribute_name", "")

    def values(points):
        found = points.attributes.get(name)
        if found is None and not name:
            found = next(iter(points.attributes.values()), None)
        if found is None and name in points.uvs:
            uv = points.uvs[name]
            found = np.concatenate([uv, np.zeros((len(uv), 1), dtype=np.float32)], axis=1)
        return np.zeros((1, 3), dtype=np.float32) if found is None else found

    colour = Expression(values, [(SPACE,)])
    if at.socket.name == "Alpha":
        return constant(1.0)
    return as_number(colour) if at.socket.name in ("Fac", "Factor") else colour


def _hair(reader, at):
    name = at.socket.name

    def of_strand(what, elsewhere, needs):
        def values(points):
            found = getattr(points, what)
            return np.full((1, 1), elsewhere, dtype=np.float32) if found is None else found

        return Expression(values, needs)

    if name == "Is Strand":
        return combined(lambda along: (along >= 0).astype(np.float32), of_strand("along", -1.0, [(SPACE,)]))
    if name == "Intercept":
        return of_strand("along", 0.0, [(SPACE,), (ALONG,)])
    if name == "Random":
        return of_strand("random", 0.0, [(SPACE,)])
    return reader.unsupported(at, f"'{name}' of Curves Info has no equal; 0 is used", constant(0.0))


def _mapping(reader, at):
    vector = reader.value(at.input("Vector"))
    location, turn, scale = (
        reader.value(at.input(n)) if at.input(n) else constant(0.0, 0.0, 0.0) for n in ("Location", "Rotation", "Scale")
    )
    kind = at.node.vector_type

    def mapped(v, location, turn, scale):
        if kind == "TEXTURE":
            v = np.einsum("nij,ni->nj", rotation(turn), v - location)
            return v / np.where(scale == 0, 1, scale)
        if kind == "NORMAL":
            v = np.einsum("nij,nj->ni", rotation(turn), v / np.where(scale == 0, 1, scale))
            return v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1e-20)
        v = np.einsum(
            "nij,nj->ni", rotation(turn), np.broadcast_to(v * scale, np.broadcast_shapes(v.shape, scale.shape))
        )
        return v if kind == "VECTOR" else v + location

    return combined(mapped, vector, location, turn, scale)


NODES = {
    "ATTRIBUTE": _attribute,
    "HAIR_INFO": _hair,
    "MAPPING": _mapping,
    "NEW_GEOMETRY": _geometry,
    "TEX_COORD": _coordinates,
    "UVMAP": _uv_map,
    "VERTEX_COLOR": _attribute,
}
