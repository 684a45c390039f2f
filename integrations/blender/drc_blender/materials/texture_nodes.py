"""Textures: images and patterns. Each function takes the
reader and the output socket, and returns the expression of that output."""

import numpy as np

from . import noise
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


def _scaled(reader, at):
    return combined(
        lambda v, s: v * s, texture_vector(reader, at, of_place("generated")), reader.value(at.input("Scale"))
    )


def _noise(reader, at):
    node = at.node
    if node.noise_dimensions != "3D":
        reader.unsupported(at, f"noise of {node.noise_dimensions} has no equal; that of 3D is used")
    if getattr(node, "noise_type", "FBM") != "FBM":
        reader.unsupported(at, f"noise of the kind {node.noise_type} has no equal; fBM is used")
    numbers = []
    for name, default in (("Detail", 2.0), ("Roughness", 0.5), ("Lacunarity", 2.0), ("Distortion", 0.0)):
        socket = at.input(name)
        value = reader.value(socket) if socket is not None else constant(default)
        if not value.is_constant:
            reader.unsupported(at, f"{name} of noise is taken as constant")
            value = constant(default)
        numbers.append(float(value.constant()[0]))
    coloured = at.socket.name == "Color"
    return combined(lambda p: noise.noise(p, *numbers, getattr(node, "normalize", True), coloured), _scaled(reader, at))


def _checker(reader, at):
    which = combined(noise.checker, _scaled(reader, at))
    if at.socket.name != "Color":
        return which
    return combined(
        lambda w, a, b: w * a + (1 - w) * b, which, reader.value(at.input("Color1")), reader.value(at.input("Color2"))
    )


def _gradient(reader, at):
    value = combined(
        lambda p: noise.gradient(p, at.node.gradient_type), texture_vector(reader, at, of_place("generated"))
    )
    return as_colour(value) if at.socket.name == "Color" else value


def _brick(reader, at):
    node = at.node
    names = ("Mortar Size", "Mortar Smooth", "Bias", "Brick Width", "Row Height")
    sizes = [reader.value(at.input(n)) for n in names]
    if not all(s.is_constant for s in sizes):
        reader.unsupported(at, "the sizes of bricks are taken as constant")
    sizes = [float(s.constant()[0]) for s in sizes]
    patterns = combined(
        lambda p: np.concatenate(
            noise.bricks(p, *sizes, node.offset, node.offset_frequency, node.squash, node.squash_frequency), axis=1
        ),
        _scaled(reader, at),
    )
    if at.socket.name != "Color":
        return combined(lambda p: p[:, 1:2], patterns)
    return combined(
        lambda p, a, b, m: ((1 - p[:, :1]) * a + p[:, :1] * b) * (1 - p[:, 1:2]) + p[:, 1:2] * m,
        patterns,
        *(reader.value(at.input(n)) for n in ("Color1", "Color2", "Mortar")),
    )


NODES = {
    "TEX_BRICK": _brick,
    "TEX_CHECKER": _checker,
    "TEX_ENVIRONMENT": _environment,
    "TEX_GRADIENT": _gradient,
    "TEX_IMAGE": _image,
    "TEX_NOISE": _noise,
    "TEX_SKY": _sky,
}
