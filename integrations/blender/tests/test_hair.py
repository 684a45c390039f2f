#!/usr/bin/env python3
"""What of hair needs no Blender: the curves of strands, and their looks.

    integrations/blender/tests/test_hair.py

Without numpy it is skipped: it ends with status 77.
"""

import os
import re
import sys
import types
import unittest

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
try:
    import numpy as np
except ImportError:
    print("skipped: this Python has no numpy")
    sys.exit(77)

from drc_blender.export.hair import Hair, radii_along, roots_of
from drc_blender.export.strand_text import LEAST_PIECES, bezier, divided, piece_lines, pieces_of, strand_lines
from drc_blender.materials.clusters import ALIKE, MOST_GROUPS, groups_of
from drc_blender.materials.closures import Closure, absorption_of_melanin
from drc_blender.materials.expressions import SPACE, Expression, constant
from drc_blender.materials.plan import MaterialPlan
from drc_blender.materials.strand_looks import StrandLook, looks_of


def hair_of(strands, radii):
    """strands: lists of keys; radii: a list for each strand."""
    keys = np.array([k for strand in strands for k in strand], dtype=np.float32)
    offsets = np.cumsum([0] + [len(strand) for strand in strands])
    roots = roots_of(keys[offsets[:-1]], np.eye(4), (np.zeros(3), np.ones(3)), {})
    return Hair(keys, offsets, np.array([r for of_one in radii for r in of_one], dtype=np.float32), roots)


def at(control, t):
    """Of Bezier curves n x 4 x 3."""
    weights = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3]
    return sum(w * control[:, i] for i, w in enumerate(weights))


def numbers(line, name):
    return [float(v) for v in re.search(rf'{name}" \[([^]]*)\]', line)[1].split()]


class Strands(unittest.TestCase):
    def test_splines_pass_their_keys_smoothly(self):
        keys = np.random.default_rng(3).random((5, 6, 3))
        control = bezier(keys)
        np.testing.assert_allclose(control[:, :, 0], keys[:, :-1])
        np.testing.assert_allclose(control[:, :, 3], keys[:, 1:])
        out, into = control[:, 1:, 1] - control[:, 1:, 0], control[:, :-1, 3] - control[:, :-1, 2]
        np.testing.assert_allclose(out, into)
        np.testing.assert_allclose(out, (keys[:, 2:] - keys[:, :-2]) / 6)

    def test_what_is_divided_has_the_same_shape(self):
        control = np.random.default_rng(4).random((3, 2, 4, 3))
        parts = divided(control, 5)
        self.assertEqual(parts.shape, (3, 10, 4, 3))
        for part in range(10):
            for t in (0.0, 0.3, 1.0):
                whole = at(control[:, part // 5], (part % 5 + t) / 5)
                np.testing.assert_allclose(at(parts[:, part], t), whole, atol=1e-12)

    def test_lines_of_strands(self):
        straight, bellied = [[0, 0, 0], [0, 0, 1], [0, 0, 2]], [[1, 0, 0], [1, 0, 1], [1, 0, 2]]
        hair = hair_of([straight, bellied], [[0.3, 0.2, 0.1], [0.1, 0.3, 0.0]])
        lines = strand_lines(hair, np.arange(2), {"bool visibletocamera": False})
        self.assertEqual(len(lines), 3)  # one of the straight taper, one for each segment of the other
        for line in lines:
            self.assertRegex(line, '^Shape "curve" "string type" \\["tube"\\] "bool visibletocamera" \\[false\\]')
        self.assertEqual(numbers(lines[0], "width0") + numbers(lines[0], "width1"), [0.6, 0.2])
        points = np.array(numbers(lines[0], "P")).reshape(-1, 3)
        self.assertEqual(len(points), 7)
        np.testing.assert_allclose(points[[0, 3, 6]], straight)
        self.assertEqual([numbers(line, "width0")[0] for line in lines[1:]], [0.2, 0.6])
        self.assertEqual([numbers(line, "width1")[0] for line in lines[1:]], [0.6, 0.0])

    def test_what_nobody_could_see_is_left_out(self):
        good, point, single = [[0, 0, 0], [0, 0, 1]], [[1, 1, 1]] * 2, [[2, 2, 2]]
        hair = hair_of([good, point, single, good, good], [[1, 1], [1, 1], [1], [0, 0], [np.nan, 1]])
        self.assertEqual(len(strand_lines(hair, np.arange(5), {})), 1)
        pieces = pieces_of(hair)
        self.assertEqual(len(pieces.strand), LEAST_PIECES)
        self.assertTrue((pieces.strand == 0).all())
        self.assertEqual(len(strand_lines(hair_of([single], [[1]]), np.arange(1), {})), 0)
        self.assertEqual(len(pieces_of(hair_of([single], [[1]])).strand), 0)

    def test_pieces_tell_how_far_along_they_are(self):
        hair = hair_of([[[0, 0, 0], [0, 0, 1]], [[0, 0, 0], [0, 0, 1], [0, 0, 4]]], [[0.4, 0.0], [0.2, 0.2, 0.2]])
        pieces = pieces_of(hair)
        first = pieces.strand == 0
        np.testing.assert_allclose(pieces.radii[first][:, 0], 0.4 * (1 - np.arange(8) / 8), atol=1e-7)
        np.testing.assert_allclose(pieces.radii[first][1:, 0], pieces.radii[first][:-1, 1])
        for strand, length in ((0, 1), (1, 4)):
            part = pieces.strand == strand
            middle = pieces.control[part][:, [0, 3], 2].mean(axis=1)
            np.testing.assert_allclose(pieces.along[part][:, 0], middle / length, atol=1e-6)
        roots = hair.roots_of_pieces(pieces)
        self.assertEqual(roots.count, len(pieces.strand))
        np.testing.assert_allclose(roots.along, pieces.along)
        np.testing.assert_allclose(roots.random, hair.roots.random[pieces.strand])
        self.assertEqual(len(piece_lines(pieces, np.arange(16), {})), 16)

    def test_radii_of_particles(self):
        settings = types.SimpleNamespace(
            shape=0.0, radius_scale=0.1, root_radius=2.0, tip_radius=1.0, use_close_tip=False
        )
        keys = np.array([[[0, 0, 0], [0, 0, 1], [0, 0, 4]], [[0, 0, 0], [0, 0, 2], [9, 9, 9]]], dtype=float)
        missing = np.array([[False] * 3, [False, False, True]])
        np.testing.assert_allclose(radii_along(keys, missing, settings), [0.1, 0.0875, 0.05, 0.1, 0.05])
        settings.shape, settings.use_close_tip = 0.5, True
        np.testing.assert_allclose(radii_along(keys, missing, settings), [0.1, 0.05 + 0.05 * 0.75**2, 0, 0.1, 0])
        settings.shape, settings.use_close_tip = -0.5, False
        np.testing.assert_allclose(radii_along(keys, missing, settings)[:3], [0.1, 0.05 + 0.05 * 0.75**0.5, 0.05])


class Looks(unittest.TestCase):
    def test_groups_are_alike_and_whole(self):
        rows = np.random.default_rng(5).random((4000, 3)).astype(np.float32)
        groups = groups_of(rows)
        self.assertEqual(len(groups), MOST_GROUPS)
        np.testing.assert_array_equal(np.sort(np.concatenate(groups)), np.arange(4000))
        # A cube cut in 64 has a quarter of its side.
        self.assertLess(max(np.ptp(rows[g], axis=0).max() for g in groups), 0.6)
        self.assertLess(np.mean([np.ptp(rows[g], axis=0).max() for g in groups]), 0.35)

    def test_few_values_are_kept(self):
        values = np.array([[0.1], [0.5], [0.9], [0.5 - ALIKE / 2]])
        rows = values[np.random.default_rng(6).integers(0, 4, 100)]
        groups = groups_of(rows)
        self.assertEqual(sorted(round(float(rows[g].mean()), 1) for g in groups), [0.1, 0.5, 0.9])
        self.assertEqual([len(g) for g in groups_of(np.zeros((1, 2)))], [1])
        self.assertEqual(sorted(len(g) for g in groups_of(np.float32([[3e38], [3e38], [-3e38]]))), [1, 2])
        self.assertEqual(sorted(len(g) for g in groups_of(np.array([[1e9], [np.nextafter(1e9, 2e9)]]))), [2])

    def test_a_look_is_that_of_its_roots(self):
        hair = hair_of([[[x, 0, 0], [x, 0, 1]] for x in (0, 0, 1)], [[0.1, 0.1]] * 3)
        colour = Expression(lambda points: points.object * 0.5, [(SPACE,)])
        plan = MaterialPlan([Closure("diffuse", {"rgb reflectance": colour, "float x": constant(2.0)})], [])
        looks = [(StrandLook(hair.roots, rows), sorted(rows.tolist())) for rows in looks_of(plan, hair.roots)]
        self.assertEqual(sorted(rows for _, rows in looks), [[0, 1], [2]])
        for look, rows in looks:
            value = look.parameter("rgb reflectance", colour, "")["rgb reflectance"]
            np.testing.assert_allclose(value, (0.5 if rows == [2] else 0.0, 0, 0))
            self.assertEqual(look.parameter("float x", constant(2.0), ""), {"float x": 2.0})
        self.assertNotEqual(looks[0][0].key(plan), looks[1][0].key(plan))

    def test_what_is_no_number_is_zero(self):
        hair = hair_of([[[x, 0, 0], [x, 0, 1]] for x in (0, 1)], [[0.1, 0.1]] * 2)
        with np.errstate(divide="ignore"):
            colour = Expression(lambda points: np.float32(1) / points.object, [(SPACE,)])
            plan = MaterialPlan([Closure("diffuse", {"rgb reflectance": colour})], [])
            looks = [StrandLook(hair.roots, rows) for rows in looks_of(plan, hair.roots)]
            values = [look.parameter("rgb reflectance", colour, "")["rgb reflectance"].tolist() for look in looks]
        self.assertEqual(sorted(values), [[0, 0, 0], [1, 0, 0]])

    def test_strands_that_are_stretched(self):
        hair = hair_of([[[1, 2, 3], [2, 2, 3]]], [[0.1, 0.1]])
        made = hair.stretched(np.diag([2.0, 1, 0.5, 1]))
        np.testing.assert_allclose(made.positions, [[2, 2, 1.5], [4, 2, 1.5]])
        np.testing.assert_allclose(made.radii, hair.radii)
        np.testing.assert_allclose(made.roots.object, hair.roots.object)

    def test_melanin(self):
        def absorbed(melanin, redness, tint=1.0):
            row = [np.array([[v]], dtype=np.float32) for v in (melanin, redness)]
            return absorption_of_melanin(*row, np.full((1, 3), tint, np.float32), np.array([[0.3]]))[0]

        np.testing.assert_allclose(absorbed(0, 0.5), 0, atol=1e-9)
        self.assertTrue((absorbed(0.8, 0.0) > absorbed(0.4, 0.0)).all())
        np.testing.assert_allclose(absorbed(1 - np.exp(-1), 0), (0.506, 0.841, 1.653), rtol=1e-5)
        np.testing.assert_allclose(absorbed(1 - np.exp(-1), 1), (0.343, 0.733, 1.924), rtol=1e-5)
        self.assertTrue((absorbed(0.4, 0.5, 0.5) > absorbed(0.4, 0.5)).all())


if __name__ == "__main__":
    unittest.main()
