"""Measured lamps: photometric files of the Illuminating Engineering Society (LM-63), and the node that reads them."""

import os

import numpy as np

from .coordinate_nodes import of_place
from .expressions import combined, constant
from .texture_nodes import texture_vector

# A strength of Blender's for a candela: the power of a point that has it in all directions, in watts of white light.
PER_CANDELA = 4 * np.pi / 177.83


class LightProfile:
    """down: angles from the nadir, around: angles about the axis, degrees, both rising; candelas: around x down."""

    def __init__(self, down, around, candelas):
        self.down, self.around, self.candelas = down, around, candelas

    @staticmethod
    def parse(text):
        """Raises ValueError with what is wrong."""
        lines = text.splitlines()
        tilt = next((i for i, line in enumerate(lines) if line.strip().upper().startswith("TILT=")), None)
        if tilt is None:
            raise ValueError("it has no line TILT=")
        kind = lines[tilt].split("=", 1)[1].strip().upper()
        if kind not in ("NONE", "INCLUDE"):
            raise ValueError(f"its TILT is {kind}, not NONE or INCLUDE")
        try:
            numbers = [float(word) for word in " ".join(lines[tilt + 1 :]).replace(",", " ").split()]
            if kind == "INCLUDE":
                numbers = numbers[2 + 2 * int(numbers[1]) :]
            lamps, _, factor, n_down, n_around, type_ = numbers[:6]
            ballast, future = numbers[10:12]
            n_down, n_around, rest = int(n_down), int(n_around), numbers[13:]
            down, around = np.array(rest[:n_down]), np.array(rest[n_down : n_down + n_around])
            candelas = np.array(rest[n_down + n_around :][: n_down * n_around]).reshape(n_around, n_down)
        except (IndexError, OverflowError, ValueError) as error:
            raise ValueError("its numbers are not those of a photometric file") from error
        if not all(np.isfinite(v).all() for v in (down, around, candelas, factor, ballast, future)):
            raise ValueError("it has numbers that are none")
        if type_ != 1:
            raise ValueError("its photometry is not of type C")
        if n_down < 2 or n_around < 1 or (np.diff(down) <= 0).any() or (np.diff(around) <= 0).any():
            raise ValueError("its angles do not rise")
        return LightProfile(down, *all_around(around, candelas * factor * ballast * future))

    def candelas_at(self, directions):
        """directions: n x 3, unit, down is -z: n x 1. Smooth between the angles, as in Cycles."""
        x, y, z = directions.T
        angle = np.degrees(np.arccos(np.clip(-z, -1, 1)))
        about = np.degrees(np.arctan2(x, y)) + 180
        row, row_shares = cubic_shares(about, self.around)
        column, column_shares = cubic_shares(angle, self.down)
        last_row, last = len(self.around) - 1, len(self.down) - 1
        value = 0.0
        for i in range(4):
            rows = (row + i - 1) % last_row  # the last angle is the first again
            for j in range(4):
                columns = np.abs(column + j - 1)  # it is mirrored at its ends
                columns = np.clip(last - np.abs(last - columns), 0, last)
                value = value + row_shares[i] * column_shares[j] * self.candelas[rows, columns]
        return np.where((angle >= self.down[0]) & (angle <= self.down[-1]), np.maximum(value, 0), 0)[:, None]


def cubic_shares(values, steps):
    """(number of the step before each value, shares of the four steps around it), by Catmull and Rom's spline."""
    place = np.interp(values, steps, np.arange(len(steps)))
    number = np.minimum(place.astype(int), len(steps) - 2)
    t = place - number
    return number, (
        ((-t + 2) * t - 1) * t / 2,
        ((3 * t - 5) * t * t + 2) / 2,
        ((-3 * t + 4) * t + 1) * t / 2,
        (t - 1) * t * t / 2,
    )


def all_around(around, candelas):
    """Angles from 0 to 360, by the symmetry that the last one says."""
    if len(around) == 1:
        return np.array([0.0, 360.0]), np.repeat(candelas, 2, axis=0)
    around = around - around[0]
    for whole in (180, 360):
        if abs(around[-1] - whole / 2) < 1:  # what follows is the mirror image
            around = np.concatenate([around, whole - around[-2::-1]])
            candelas = np.concatenate([candelas, candelas[-2::-1]])
    if abs(around[-1] - 360) > 1:
        raise ValueError(f"its angles about the axis end at {around[-1]:g} degrees, not at 0, 90, 180 or 360")
    return around, candelas


def text_of(node):
    """Of the node's file or of Blender's text."""
    if node.mode == "INTERNAL":
        if node.ies is None:
            raise ValueError("it has no text")
        return node.ies.as_string()
    import bpy

    path = bpy.path.abspath(node.filepath, library=node.id_data.library)
    with open(path, encoding="latin-1") as f:
        return f.read()


def _ies(reader, at):
    try:
        profile = LightProfile.parse(text_of(at.node))
    except (OSError, ValueError) as error:
        name = os.path.basename(at.node.filepath) if at.node.mode == "EXTERNAL" else getattr(at.node.ies, "name", "")
        reason = error.strerror if isinstance(error, OSError) else error
        return reader.unsupported(at, f"the photometric file '{name}' cannot be read: {reason}; it is 1", constant(1.0))

    def value(v, strength):
        directions = v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1e-20)
        return strength * profile.candelas_at(directions) * PER_CANDELA

    return combined(value, texture_vector(reader, at, of_place("normal")), reader.value(at.input("Strength")))


NODES = {"TEX_IES": _ies}
