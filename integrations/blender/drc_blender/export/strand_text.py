"""Strands of hair as pbrt's curves."""

from dataclasses import dataclass

import numpy as np

from .pbrt_text import statement

NEARLY = 0.02  # how far radii may be from those of a straight taper, as a share of the largest
BLOCK = 1 << 12  # curves whose numbers are Python's at a time
LEAST_PIECES = 8  # of a strand whose look changes along it


@dataclass
class Pieces:
    """Parts of strands. control: pieces x 4 x 3, of cubic Bezier curves, object space; radii: pieces x 2, at their ends;
    strand: of each; along: pieces x 1, of its middle, as a share of the strand's length."""

    control: np.ndarray
    radii: np.ndarray
    strand: np.ndarray
    along: np.ndarray


def bezier(keys):
    """Catmull-Rom splines through keys, strands x keys x 3, as the control points of cubic Bezier curves: strands x
    segments x 4 x 3. At its ends a spline goes as if its end were there twice."""
    slopes = np.gradient(keys, axis=1)
    slopes[:, [0, -1]] /= 2
    before, after = keys[:, :-1] + slopes[:, :-1] / 3, keys[:, 1:] - slopes[:, 1:] / 3
    return np.stack([keys[:, :-1], before, after, keys[:, 1:]], axis=2)


def divided(control, count):
    """Bezier curves, n x segments x 4 x 3, each cut into `count` at equal steps of its parameter."""
    parts, rest = [], control
    for left in range(count, 1, -1):
        t = 1 / left
        a, b, c, d = np.moveaxis(rest, 2, 0)
        ab, bc, cd = a + t * (b - a), b + t * (c - b), c + t * (d - c)
        abc, bcd = ab + t * (bc - ab), bc + t * (cd - bc)
        middle = abc + t * (bcd - abc)
        parts.append(np.stack([a, ab, abc, middle], axis=2))
        rest = np.stack([middle, bcd, cd, d], axis=2)
    n, segments = control.shape[:2]
    return np.stack([*parts, rest], axis=2).reshape(n, segments * count, 4, 3)


def tapers_straight(radii):
    """Which strands have radii, strands x keys, that change evenly from the root to the tip."""
    along = np.linspace(0, 1, radii.shape[1])
    straight = radii[:, :1] * (1 - along) + radii[:, -1:] * along
    return (np.abs(radii - straight) <= NEARLY * radii.max(axis=1, keepdims=True)).all(axis=1)


def _of_each_length(hair, rows):
    """(numbers of strands, keys, radii) of those that have as many keys, unless they are points or have no width."""
    lengths = np.diff(hair.offsets)[rows]
    for length in np.unique(lengths[lengths > 1]):
        numbers = rows[lengths == length]
        at = hair.offsets[numbers][:, None] + np.arange(length)
        keys, radii = hair.positions[at].astype(np.float64), hair.radii[at].astype(np.float64)
        seen = np.ptp(keys, axis=1).any(axis=1) & (radii.max(axis=1) > 0) & np.isfinite(radii).all(axis=1)
        yield numbers[seen], keys[seen], np.maximum(radii[seen], 0)


def pieces_of(hair):
    """All strands in pieces."""
    found = []
    for numbers, keys, radii in _of_each_length(hair, np.arange(hair.strands)):
        count = -(-LEAST_PIECES // (keys.shape[1] - 1))
        control = divided(bezier(keys), count)
        pieces = control.shape[1]
        ends = np.linspace(0, keys.shape[1] - 1, pieces + 1)
        low = np.minimum(ends.astype(int), keys.shape[1] - 2)
        radii = radii[:, low] + (ends - low) * (radii[:, low + 1] - radii[:, low])
        lengths = np.linalg.norm(control[:, :, 3] - control[:, :, 0], axis=2)
        middles = (np.cumsum(lengths, axis=1) - lengths / 2) / np.maximum(lengths.sum(axis=1, keepdims=True), 1e-20)
        ends_of = np.stack([radii[:, :-1], radii[:, 1:]], axis=2).reshape(-1, 2)
        found.append((control.reshape(-1, 4, 3), ends_of, np.repeat(numbers, pieces), middles.reshape(-1, 1)))
    if not found:
        return Pieces(np.empty((0, 4, 3)), np.empty((0, 2)), np.empty(0, int), np.empty((0, 1)))
    return Pieces(*(np.concatenate(arrays) for arrays in zip(*found)))


def piece_lines(pieces, rows, params):
    """A pbrt curve for each of these pieces. params: of each Shape."""
    return _lines(pieces.control[rows], pieces.radii[rows], params)


def strand_lines(hair, rows, params):
    """A pbrt curve for each of these strands, or for each of its segments if their radii need it."""
    lines = []
    for _, keys, radii in _of_each_length(hair, rows):
        whole, control = tapers_straight(radii), bezier(keys)
        inner = control[:, :, :3].reshape(len(keys), 3 * control.shape[1], 3)
        joined = np.concatenate([inner, control[:, -1, 3:]], axis=1)
        lines += _lines(joined[whole], radii[whole][:, [0, -1]], params)
        ends = np.stack([radii[~whole][:, :-1], radii[~whole][:, 1:]], axis=2).reshape(-1, 2)
        lines += _lines(control[~whole].reshape(-1, 4, 3), ends, params)
    return lines


def _lines(control, radii, params):
    """control: curves x points x 3; radii: curves x 2. Those that nobody could see are left out."""
    seen = np.ptp(control, axis=1).any(axis=1) & radii.any(axis=1)
    control, radii = control[seen], radii[seen]
    points = " ".join(["%.7g"] * 3 * control.shape[1])
    line = statement("Shape", "curve", params={"string type": "tube", **params}).replace("%", "%%")
    line += f' "point3 P" [{points}] "float width0" [%.7g] "float width1" [%.7g]'
    values = np.concatenate([control.reshape(len(control), 3 * control.shape[1]), 2 * radii], axis=1)
    blocks = (values[begin : begin + BLOCK].tolist() for begin in range(0, len(values), BLOCK))
    return [line % tuple(row) for block in blocks for row in block]
