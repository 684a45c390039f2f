"""Points and spots whose light depends on its direction by their nodes, such as measured ones, as pbrt's goniometric
lights."""

import math

import numpy as np

from ..materials.points import Points
from .cache import digest
from .equal_area import directions
from .image_files import pfm_bytes
from .pbrt_text import statement, transform

SIDE = 256  # of the picture of all directions
NARROW = 15  # degrees of a spot's cone, across which its light is taken to be as in its middle
GREY = 0.01  # how far colours may be from those of a grey picture, as a share of the largest


def along_the_axis(radiance):
    """Of an Expression of the direction, at -z: three values."""
    return np.broadcast_to(radiance(Points(1, normal=np.array([[0, 0, -1]], dtype=np.float32))), (1, 3))[0].astype(float)


def directed_lines(light, matrix, radiance, files, report, place):
    """radiance: an Expression of the direction, of a point or a spot; matrix: of the lamp, whose -z is down."""
    towards = directions(SIDE).reshape(-1, 3).astype(np.float32)
    colours = np.broadcast_to(radiance(Points(len(towards), normal=towards)), towards.shape)
    if (colours < 0).any():
        report.add("lamps that take light away have no equal; what is negative is black", *place)
    colours = np.maximum(np.nan_to_num(colours, nan=0, posinf=0, neginf=0), 0)
    if light.type == "SPOT":
        colours = colours * within_cone(light, -towards[:, 2:])
    grey = colours.mean(axis=1)
    if not grey.any():
        return []
    tint = colours.sum(axis=0) / grey.sum()
    if np.abs(colours - grey[:, None] * tint).max() > GREY * colours.max():
        report.add("the light of a lamp has one colour in all directions", *place)
    # Numbers that a picture keeps well.
    grey, tint = grey / grey.max(), tint * grey.max() / (4 * math.pi)
    picture = grey.reshape(SIDE, SIDE).astype(np.float32)
    file = files.file(digest("lamp", picture), "pfm", lambda: pfm_bytes(picture))
    turned = np.eye(4)
    axes = matrix[:3, :3] / np.linalg.norm(matrix[:3, :3], axis=0)
    # pbrt's diagrams have their pole along y.
    turned[:3, :3], turned[:3, 3] = axes[:, [0, 2, 1]], matrix[:3, 3]
    return [
        "AttributeBegin",
        transform(turned),
        statement("LightSource", "goniometric", params={"string filename": file, "rgb I": tint}),
        "AttributeEnd",
    ]


def within_cone(light, cosine):
    """The share of a spot's light, by the cosine of the angle to its axis."""
    edge = math.cos(light.spot_size / 2)
    share = np.clip((cosine - edge) / max((1 - edge) * light.spot_blend, 1e-6), 0, 1)
    return share * share * (3 - 2 * share)
