#!/usr/bin/env python3
"""Computed textures, by what must hold of them whatever Blender does; test_textures.py has them beside Cycles.

    integrations/blender/tests/test_patterns.py

Without numpy the test is skipped: it ends with status 77.
"""

import itertools
import os
import sys
import tracemalloc
import unittest
from dataclasses import replace

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
try:
    import numpy as np
except ImportError:
    print("skipped: this Python has no numpy")
    sys.exit(77)

from drc_blender.materials.blocks import BLOCK, beside
from drc_blender.materials.hashes import IntegerCells, NumberedCells, colour_of_numbers, of_numbers
from drc_blender.materials.noise import Noise
from drc_blender.materials.perlin import perlin
from drc_blender.materials.voronoi import Voronoi
from drc_blender.materials.waves import Wave, magic

DIMENSIONS = range(1, 5)
HASHES = (NumberedCells, IntegerCells)


def points(dimensions, count=2000, size=8.0, seed=1):
    """Some of them at negative coordinates."""
    made = np.random.default_rng(seed).uniform(-size / 2, size / 2, (count, dimensions))
    return made.astype(np.float32)


class Hashes(unittest.TestCase):
    def check_uniform(self, numbers):
        """In [0, 1], each evenly, and no two together."""
        numbers = np.stack(numbers)
        self.assertTrue(np.all((numbers >= 0) & (numbers <= 1)))
        deviation = 4 / np.sqrt(12 * numbers.shape[1])
        np.testing.assert_allclose(numbers.mean(axis=1), 0.5, atol=deviation)
        if len(numbers) > 1:
            correlation = np.corrcoef(numbers) - np.eye(len(numbers))
            self.assertLess(abs(correlation).max(), 4 / np.sqrt(numbers.shape[1]))

    def test_cells(self):
        for hashes, dimensions in itertools.product(HASHES, DIMENSIONS):
            side = round(4096 ** (1 / dimensions))
            cell = [c.ravel() - np.int32(side // 2) for c in np.indices((side,) * dimensions, dtype=np.int32)]
            with self.subTest(hashes=hashes.__name__, dimensions=dimensions):
                point, colour = hashes.point(cell), hashes.colour(cell)
                self.assertEqual((len(point), len(colour)), (dimensions, 3))
                self.check_uniform(point)
                self.check_uniform(colour)

    def test_numbers(self):
        for dimensions in DIMENSIONS:
            numbers = list(points(dimensions, 4096).T)
            colour = colour_of_numbers(*numbers)
            self.check_uniform(colour)
            np.testing.assert_array_equal(of_numbers(*numbers), colour[0])


class Cells(unittest.TestCase):
    def near(self, voronoi, place):
        """The vectors to the points of all cells within two, n x cells x dimensions."""
        place = place.astype(np.float64)
        offsets = np.array(list(itertools.product(range(-2, 3), repeat=place.shape[1])))
        cells = np.floor(place)[:, None] + offsets
        flat = [c.astype(np.int32) for c in cells.reshape(-1, place.shape[1]).T]
        inside = np.stack(voronoi.hashes.point(flat), axis=1).reshape(cells.shape) * voronoi.randomness
        return cells + inside - place[:, None]

    def test_nearest_points(self):
        metrics = {
            "EUCLIDEAN": lambda v: np.sqrt((v * v).sum(axis=-1)),
            "MANHATTAN": lambda v: abs(v).sum(axis=-1),
            "CHEBYCHEV": lambda v: abs(v).max(axis=-1),
            "MINKOWSKI": lambda v: (abs(v) ** 3).sum(axis=-1) ** (1 / 3),
        }
        for (metric, length), hashes, dimensions in itertools.product(metrics.items(), HASHES, (2, 3)):
            place = points(dimensions)
            voronoi = Voronoi("F1", metric, exponent=3.0, randomness=0.8, hashes=hashes)
            first, second = np.sort(length(self.near(voronoi, place)), axis=1)[:, :2].T
            with self.subTest(metric=metric, hashes=hashes.__name__, dimensions=dimensions):
                for feature, expected in (("F1", first), ("F2", second)):
                    found = replace(voronoi, feature=feature).distances(place)[:, 0]
                    # A point two cells away is seldom the nearest, and then is not found, as in Blender.
                    self.assertTrue(np.all(found > expected - 1e-5))
                    self.assertGreater(np.mean(abs(found - expected) < 1e-5), 0.93)

    def test_positions_are_at_the_distances(self):
        for feature, dimensions in itertools.product(("F1", "F2"), DIMENSIONS):
            place, voronoi = points(dimensions), Voronoi(feature)
            apart = np.linalg.norm(voronoi.positions(place) - place, axis=1)
            np.testing.assert_allclose(apart, voronoi.distances(place)[:, 0], atol=1e-5)

    def test_edges_are_where_two_points_are_as_near(self):
        for dimensions in DIMENSIONS:
            place = points(dimensions)
            first, second, edge = (Voronoi(feature).distances(place) for feature in ("F1", "F2", "DISTANCE_TO_EDGE"))
            # By the triangle of the two points and the place; the second may be missed, or too near to have an edge.
            self.assertGreater(np.mean(edge > (second - first) / 2 - 1e-5), 0.99)
            self.assertTrue(np.all(edge >= 0))
            self.assertLess(edge.min(), 0.01)

    def test_balls_have_a_radius_each_and_do_not_meet(self):
        for dimensions in (2, 3):
            place = points(dimensions)
            radius = Voronoi("N_SPHERE_RADIUS").distances(place)[:, 0]
            centre = Voronoi().positions(place)
            _, owner = np.unique(np.round(centre, 3), axis=0, return_inverse=True)
            owner = owner.ravel()
            for ball in range(owner.max() + 1):
                self.assertLess(np.ptp(radius[owner == ball]), 1e-5)
            apart = np.linalg.norm(centre[:300, None] - centre[None, :300], axis=2)
            others = owner[:300, None] != owner[None, :300]
            self.assertTrue(np.all(apart[others] > (radius[:300, None] + radius[None, :300])[others] - 1e-4))

    def test_smoothness(self):
        for dimensions in (1, 2, 3):
            place = points(dimensions)
            sharp = Voronoi("F1").distances(place)
            np.testing.assert_allclose(Voronoi("SMOOTH_F1", smoothness=0.0).distances(place), sharp, atol=1e-5)
            before = sharp
            for smoothness in (0.2, 0.6, 1.0):
                smooth = Voronoi("SMOOTH_F1", smoothness=smoothness).distances(place)
                self.assertTrue(np.all(smooth <= before + 1e-5))
                self.assertLess(smooth.mean(), before.mean())
                before = smooth

    def test_normalized_distances(self):
        for feature, dimensions in itertools.product(("F1", "F2", "DISTANCE_TO_EDGE"), DIMENSIONS):
            for detail in (0.0, 2.5):
                value = Voronoi(feature, normalized=True, detail=detail).distances(points(dimensions))
                self.assertTrue(np.all((value >= 0) & (value <= 1)), (feature, dimensions, detail))

    def test_octaves_come_gradually(self):
        place = points(2)
        for feature in ("F1", "SMOOTH_F1", "DISTANCE_TO_EDGE"):
            values = [Voronoi(feature, detail=d).distances(place) for d in (1.0, 1.001, 1.999, 2.0)]
            np.testing.assert_allclose(values[0], values[1], atol=1e-3)
            np.testing.assert_allclose(values[2], values[3], atol=1e-3)
            self.assertGreater(abs(values[0] - values[3]).max(), 0.02)

    def test_blocks_are_the_same_and_bound_the_memory(self):
        place = points(3, 3 * BLOCK + 5)
        voronoi = Voronoi("F2", detail=1.0)
        alone = voronoi.distances(place[2 * BLOCK - 1 : 2 * BLOCK + 1])
        # Two points hash their own cells, a block all cells that it has.
        np.testing.assert_array_equal(voronoi.distances(place)[2 * BLOCK - 1 : 2 * BLOCK + 1], alone)
        many = points(3, 64 * BLOCK)
        for function in (Voronoi("DISTANCE_TO_EDGE").distances, Noise().values, Wave().values):
            tracemalloc.start()
            function(many)
            most = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
            self.assertLess(most, 2**25 + many.nbytes * 3)


class Noises(unittest.TestCase):
    def test_gradient_noise(self):
        for dimensions in DIMENSIONS:
            place = points(dimensions, 20000)
            value = perlin(list(place.T))
            self.assertLess(abs(value).max(), 1.1)
            self.assertLess(abs(value.mean()), 0.03)
            self.assertGreater(value.std(), 0.2)
            np.testing.assert_array_equal(perlin(list(np.floor(place).T)), 0)
            near = perlin(list((place + np.float32(1e-3)).T))
            self.assertLess(abs(near - value).max(), 0.02)

    def test_it_repeats_far_away(self):
        place = (np.round(points(2) * 16) / 16).astype(np.float32)  # exact at both places
        place = abs(place)
        np.testing.assert_allclose(perlin(list((place + np.float32(100000)).T)), perlin(list(place.T)), atol=1e-5)

    def test_kinds(self):
        place = points(3)
        fbm = Noise().values(place)
        self.assertTrue(np.all((fbm >= 0) & (fbm <= 1)))
        self.assertTrue(np.all(Noise("RIDGED_MULTIFRACTAL", offset=1.0).values(place) >= 0))
        one = perlin(list(place.T))[:, None]
        expected = {
            "FBM": one,
            "MULTIFRACTAL": 1 + one,
            "RIDGED_MULTIFRACTAL": (0.7 - abs(one)) ** 2,
            "HYBRID_MULTIFRACTAL": one + 0.7,
            "HETERO_TERRAIN": one + 0.7,
        }
        for kind, values in expected.items():
            noise = Noise(kind, normalized=False, detail=0.0, offset=0.7)
            np.testing.assert_allclose(noise.values(place), values, atol=1e-6, err_msg=kind)
            # Without roughness only the coarsest octave counts.
            rough = replace(noise, detail=3.5, roughness=0.0)
            np.testing.assert_allclose(rough.values(place), values, atol=1e-6, err_msg=kind)
            self.assertGreater(abs(replace(rough, roughness=0.6).values(place) - values).max(), 0.1)

    def test_colours_and_distortion(self):
        for dimensions in DIMENSIONS:
            place, noise = points(dimensions), Noise(distortion=0.5)
            colours = noise.colours(place)
            np.testing.assert_array_equal(colours[:, :1], noise.values(place))
            self.assertLess(abs(np.corrcoef(colours.T) - np.eye(3)).max(), 0.3)
            self.assertGreater(abs(noise.values(place) - Noise().values(place)).max(), 0.05)


class Waves(unittest.TestCase):
    def test_profiles(self):
        x = np.linspace(0, np.pi / 10, 1001, dtype=np.float32)  # a period
        place = np.stack([x, np.zeros_like(x), np.zeros_like(x)], axis=1)
        turn = np.linspace(0, 1, 1001)
        expected = {"SIN": 0.5 - 0.5 * np.cos(2 * np.pi * turn), "SAW": turn, "TRI": 1 - abs(1 - 2 * turn)}
        for profile, values in expected.items():
            found = Wave(profile=profile).values(place)[1:-1, 0]
            np.testing.assert_allclose(found, values[1:-1], atol=2e-4, err_msg=profile)

    def test_directions(self):
        place, turned = points(3), points(3)
        turned[:, :2] = turned[:, 1::-1] * (1, -1)  # a quarter about z
        for shape, axis, same in (
            ("RINGS", "Z", True),
            ("RINGS", "SPHERICAL", True),
            ("RINGS", "X", False),
            ("BANDS", "Z", True),
            ("BANDS", "X", False),
            ("BANDS", "DIAGONAL", False),
        ):
            apart = abs(Wave(shape, axis, "TRI").values(place) - Wave(shape, axis, "TRI").values(turned)).max()
            self.assertEqual(apart < 1e-3, same, (shape, axis, apart))

    def test_arguments_may_change_over_a_surface(self):
        place, phase = points(3), points(1)
        together = Wave().values(place, 2.0, 1.5, phase)
        np.testing.assert_allclose(together[7:8], Wave().values(place[7:8], 2.0, 1.5, float(phase[7, 0])), atol=1e-6)
        single = Wave().values(place[:1], 2.0, 1.5, phase)  # one place, many phases
        np.testing.assert_allclose(single[0], together[0], atol=1e-6)
        self.assertEqual(len(single), len(phase))

    def test_magic(self):
        place = points(3)
        x, y, z = 5 * place.astype(np.float64).T
        waves = np.stack([np.sin(x + y + z), np.cos(-x + y - z), -np.cos(-x - y + z)], axis=1)
        np.testing.assert_allclose(magic(place, 0, 1.0), 0.5 - waves / 2, atol=1e-4)
        for depth in range(1, 11):
            colour = magic(place, depth, 1.0)
            self.assertTrue(np.all((colour >= -1e-6) & (colour <= 1 + 1e-6)))
            changed = abs(colour - magic(place, depth - 1, 1.0)).max(axis=0) > 0.1
            self.assertEqual(changed.sum(), 1, depth)  # each step has a channel
            np.testing.assert_array_equal(magic(place, depth, 0.0), 0.5)


class Columns(unittest.TestCase):
    def test_arrays_beside_each_other(self):
        made = beside(np.ones((4, 2)), np.full((1, 1), 2.0), 3.0)
        np.testing.assert_array_equal(made, [[1, 1, 2, 3]] * 4)


if __name__ == "__main__":
    unittest.main()
