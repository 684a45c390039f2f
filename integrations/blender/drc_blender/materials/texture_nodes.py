"""Textures that are pictures. Each function takes the reader and the output socket, and returns the expression of that
output."""

import numpy as np

from .coordinate_nodes import of_place, uv_map
from .expressions import as_colour, combined, constant
from .image_lookup import equirectangular, mirror_ball


def texture_vector(reader, at, without):
    """The Vector input of a texture, or the coordinates that count if nothing is linked."""
    socket = at.input("Vector")
    if socket is None or socket.source().socket == socket.socket:
        return without
    return as_colour(reader.value(socket))


def _image(reader, at):
    node = at.node
    image = node.image
    if image is None:
        return constant(0.0) if at.socket.name == "Alpha" else constant(0.0, 0.0, 0.0)
    pixels = reader.images.pixels(image)
    if pixels is None:
        return reader.unsupported(
            at,
            f"the image '{image.name}' cannot be read; it is magenta, as in Cycles",
            constant(1.0) if at.socket.name == "Alpha" else constant(1.0, 0.0, 1.0),
        )
    if image.source in ("TILED", "SEQUENCE", "MOVIE"):
        reader.unsupported(at, f"of the image '{image.name}', only one picture is used")
    vector = texture_vector(reader, at, uv_map(""))
    if node.projection != "FLAT":
        reader.unsupported(at, f"the projection {node.projection.title()} has no equal; Flat is used")
    alpha = at.socket.name == "Alpha"

    def looked_up(v):
        found = pixels.lookup(v[:, :2], node.extension, node.interpolation)
        return found[:, 3:] if alpha else found[:, :3]

    made = combined(looked_up, vector)
    made.image = None if alpha else at
    return made


def _environment(reader, at):
    node = at.node
    pixels = reader.images.pixels(node.image) if node.image is not None else None
    if pixels is None:
        return reader.unsupported(
            at, "the environment's image is missing; it is magenta, as in Cycles", constant(1.0, 0.0, 1.0)
        )
    project = equirectangular if node.projection == "EQUIRECTANGULAR" else mirror_ball

    def looked_up(v):
        v = v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1e-20)
        return pixels.lookup(project(v), "REPEAT", node.interpolation)[:, :3]

    return combined(looked_up, texture_vector(reader, at, of_place("generated")))


def _sky(reader, at):
    sky = reader.sky(at.node)
    if isinstance(sky, str):
        return reader.unsupported(at, sky + "; it is black", constant(0.0, 0.0, 0.0))

    def looked_up(v):
        v = v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1e-20)
        found = sky.pixels.lookup(equirectangular(v), "REPEAT", "Linear")[:, :3]
        return found + sky.sun_radiance if reader.suns_shown and sky.sun_radiance is not None else found

    return combined(looked_up, texture_vector(reader, at, of_place("generated")))


NODES = {
    "TEX_ENVIRONMENT": _environment,
    "TEX_IMAGE": _image,
    "TEX_SKY": _sky,
}
