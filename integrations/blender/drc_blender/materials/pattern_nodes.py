"""Textures that are computed. Each function takes the reader and the output socket, and returns the expression of that
output."""

import numpy as np

from .blocks import beside, in_blocks
from .coordinate_nodes import of_place
from .expressions import as_colour, combined, constant
from .hashes import IntegerCells, NumberedCells, colour_of_numbers, of_numbers
from .noise import Noise
from .patterns import bricks, checker, gradient
from .texture_nodes import texture_vector
from .voronoi import Voronoi
from .waves import Wave, magic


def _constants(reader, at, texture, **defaults):
    """The numbers of inputs that cannot change over a surface; the default of one that does, or that counts for nothing.
    Inputs by their names, with _ for spaces."""
    numbers = []
    for name, default in defaults.items():
        socket = at.input(name.replace("_", " "))
        if socket is None or not socket.socket.enabled:
            numbers.append(default)
            continue
        value = reader.value(socket)
        if not value.is_constant:
            reader.unsupported(at, f"{socket.socket.name} of {texture} is taken as constant")
            value = constant(default)
        numbers.append(float(value.constant()[0]))
    return numbers


def _place(reader, at, dimensions):
    """Where a texture of 1D to 4D is looked up: n x 1 to n x 4."""
    if dimensions == "1D":
        return reader.value(at.input("W"))
    vector = texture_vector(reader, at, of_place("generated"))
    if dimensions != "4D":
        return combined(lambda v: v[:, : int(dimensions[0])], vector)
    return combined(beside, vector, reader.value(at.input("W")))


def _scaled_place(reader, at, dimensions):
    return combined(lambda p, s: p * s, _place(reader, at, dimensions), reader.value(at.input("Scale")))


def _before(*version):
    """Whether this Blender is older."""
    import bpy

    return bpy.app.version < version


def _voronoi(reader, at):
    node, name = at.node, at.socket.name
    numbers = _constants(
        reader,
        at,
        "Voronoi Texture",
        Detail=0.0,
        Roughness=0.5,
        Lacunarity=2.0,
        Smoothness=1.0,
        Exponent=0.5,
        Randomness=1.0,
    )
    hashes = NumberedCells if _before(5, 0) else IntegerCells
    voronoi = Voronoi(node.feature, node.distance, node.normalize, *numbers, hashes)
    place = _scaled_place(reader, at, node.voronoi_dimensions)
    if name == "Color":
        return combined(voronoi.colours, place)
    if name not in ("Position", "W"):
        return combined(voronoi.distances, place)
    unscaled = combined(
        lambda p, s: np.where(s == 0, 0, p / np.where(s == 0, 1, s)),
        combined(voronoi.positions, place),
        reader.value(at.input("Scale")),
    )
    if name == "W":
        return combined(lambda p: p[:, -1:], unscaled)
    return combined(lambda p: np.pad(p, ((0, 0), (0, 3 - min(p.shape[1], 3))))[:, :3], unscaled)


def _noise(reader, at):
    node = at.node
    numbers = _constants(
        reader, at, "noise", Detail=2.0, Roughness=0.5, Lacunarity=2.0, Offset=0.0, Gain=1.0, Distortion=0.0
    )
    made = Noise(node.noise_type, node.normalize, *numbers)
    return combined(
        made.colours if at.socket.name == "Color" else made.values, _scaled_place(reader, at, node.noise_dimensions)
    )


def _white_noise(reader, at):
    hashed = colour_of_numbers if at.socket.name == "Color" else lambda *columns: [of_numbers(*columns)]
    return combined(
        lambda p: in_blocks(lambda some: np.stack(hashed(*np.ascontiguousarray(some.T)), axis=1), p),
        _place(reader, at, at.node.noise_dimensions),
    )


def _wave(reader, at):
    node = at.node
    axis = node.bands_direction if node.wave_type == "BANDS" else node.rings_direction
    numbers = _constants(reader, at, "Wave Texture", Detail=2.0, Detail_Roughness=0.5)
    wave = Wave(node.wave_type, axis, node.wave_profile, *numbers)
    others = (reader.value(at.input(n)) for n in ("Distortion", "Detail Scale", "Phase Offset"))
    value = combined(wave.values, _scaled_place(reader, at, "3D"), *others)
    return as_colour(value) if at.socket.name == "Color" else value


def _magic(reader, at):
    depth, place, scale = at.node.turbulence_depth, _place(reader, at, "3D"), reader.value(at.input("Scale"))
    # Older ones begin anew at every 2 pi, whatever the scale: 4.2, 4.5 and 5.0 do, 5.2 and 5.3 do not.
    if _before(5, 2):
        place = combined(lambda p: np.fmod(p, np.float32(2 * np.pi)), place)
    colour = combined(
        lambda p, s, distortion: magic(p * s, depth, distortion), place, scale, reader.value(at.input("Distortion"))
    )
    return colour if at.socket.name == "Color" else combined(lambda c: c.mean(axis=1, keepdims=True), colour)


def _checker(reader, at):
    which = combined(checker, _scaled_place(reader, at, "3D"))
    if at.socket.name != "Color":
        return which
    return combined(
        lambda w, a, b: w * a + (1 - w) * b, which, reader.value(at.input("Color1")), reader.value(at.input("Color2"))
    )


def _gradient(reader, at):
    value = combined(lambda p: gradient(p, at.node.gradient_type), texture_vector(reader, at, of_place("generated")))
    return as_colour(value) if at.socket.name == "Color" else value


def _brick(reader, at):
    node = at.node
    sizes = _constants(
        reader,
        at,
        "Brick Texture",
        Mortar_Size=0.02,
        Mortar_Smooth=0.1,
        Bias=0.0,
        Brick_Width=0.5,
        Row_Height=0.25,
    )
    patterns = combined(
        lambda p: np.concatenate(
            bricks(p, *sizes, node.offset, node.offset_frequency, node.squash, node.squash_frequency), axis=1
        ),
        _scaled_place(reader, at, "3D"),
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
    "TEX_GRADIENT": _gradient,
    "TEX_MAGIC": _magic,
    "TEX_NOISE": _noise,
    "TEX_VORONOI": _voronoi,
    "TEX_WAVE": _wave,
    "TEX_WHITE_NOISE": _white_noise,
}
