#!/usr/bin/env python3
"""Computed textures beside Cycles, point by point: every feature, metric, dimension and kind of the nodes.

    integrations/blender/tests/test_textures.py

Run it with a Python that has Blender's module bpy (4.5 or later); without it the test is skipped: it ends with status 77.
"""

import itertools
import os
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
try:
    import bpy
except ImportError:
    print("skipped: this Python has no bpy")
    sys.exit(77)
import numpy as np

from texture_sheet import Sheet, gently, scaled, sloping, stepped, stepped_w

FEATURES = ("F1", "F2", "SMOOTH_F1", "DISTANCE_TO_EDGE", "N_SPHERE_RADIUS")
METRICS = ("EUCLIDEAN", "MANHATTAN", "CHEBYCHEV", "MINKOWSKI")
DIMENSIONS = ("1D", "2D", "3D", "4D")


class Textures(unittest.TestCase):
    def check(self, sheet, but=0.005):
        """Beside Cycles, but for a share of the points: those where the texture jumps."""
        wrong = []
        for name, ours, theirs in sheet.compared():
            error = np.abs(ours - theirs).max(axis=1)
            far = error > 5e-4 * max(1, np.abs(theirs).max())
            if far.mean() > but or not theirs.std() > 1e-3:
                wrong.append(
                    f"{name}: {far.mean():.1%} of {theirs.mean():.3g} +- {theirs.std():.2g} are off by {error.max():.3g}"
                )
        self.assertFalse(wrong, "\n" + "\n".join(wrong))
        self.assertFalse(sheet.report.lines())

    def test_octaves_of_voronoi(self):
        """Detail, Roughness, Lacunarity, Normalize; and the ends of the ranges of the rest."""
        sheet = Sheet()
        usual = dict(W=sloping, Scale=2.3, Detail=2.6, Roughness=0.6, Lacunarity=2.2, Smoothness=0.4, Randomness=0.8)
        for dimensions, feature, normalize in itertools.product(DIMENSIONS, FEATURES[:4], (False, True)):
            settings = {"voronoi_dimensions": dimensions, "feature": feature, "normalize": normalize}
            outputs = ["Distance", "Color", "W" if dimensions == "1D" else "Position"]
            for output in outputs if feature != "DISTANCE_TO_EDGE" else outputs[:1]:
                sheet.add(f"{dimensions} {feature} {normalize} {output}", "TexVoronoi", settings, output, **usual)
        for feature, metric in itertools.product(FEATURES[:3], METRICS):
            settings = {"feature": feature, "distance": metric, "normalize": True}
            sheet.add(f"{feature} {metric}, normalized", "TexVoronoi", settings, **{**usual, "Exponent": 0.5})
        others = (
            {"Detail": 2.0},
            {"Roughness": 0.0},
            {"Roughness": 1.0},
            {"Lacunarity": 0.5},
            {"Randomness": 0.0},
            {"Smoothness": 0.0},
            {"Detail": 0.4},
            {"Scale": -2.0},
        )
        for feature, changed in itertools.product(FEATURES[:4], others):
            settings = {"voronoi_dimensions": "2D", "feature": feature, "normalize": True}
            sheet.add(f"{feature} {changed}", "TexVoronoi", settings, **{**usual, **changed})
        self.check(sheet)

    def test_voronoi(self):
        sheet = Sheet()
        for dimensions, feature, metric in itertools.product(DIMENSIONS, FEATURES, METRICS):
            if metric != "EUCLIDEAN" and (dimensions == "1D" or feature in FEATURES[3:]):
                continue
            settings = {"voronoi_dimensions": dimensions, "feature": feature, "distance": metric}
            outputs = {"DISTANCE_TO_EDGE": ["Distance"], "N_SPHERE_RADIUS": ["Radius"]}.get(feature)
            if outputs is None:
                outputs = (
                    ["Distance", "Color"]
                    + (["Position"] if dimensions != "1D" else [])
                    + (["W"] if dimensions in ("1D", "4D") else [])
                )
            for output in outputs:
                sheet.add(
                    f"{dimensions} {feature} {metric} {output}",
                    "TexVoronoi",
                    settings,
                    output,
                    W=sloping,
                    Scale=3.7,
                    Exponent=1.7,
                    Smoothness=0.7,
                    Randomness=0.9,
                )
        self.check(sheet)

    def test_noise(self):
        sheet = Sheet()
        usual = dict(W=sloping, Scale=2.3, Detail=2.6, Roughness=0.6, Lacunarity=2.2, Offset=0.8, Gain=1.5)
        kinds = ("FBM", "MULTIFRACTAL", "RIDGED_MULTIFRACTAL", "HYBRID_MULTIFRACTAL", "HETERO_TERRAIN")
        for dimensions, kind, output in itertools.product(DIMENSIONS, kinds, (0, "Color")):
            settings = {"noise_dimensions": dimensions, "noise_type": kind, "normalize": True}
            sheet.add(f"{dimensions} {kind} {output}", "TexNoise", settings, output, **usual)
            sheet.add(f"{dimensions} {kind} {output}, distorted", "TexNoise", settings, output, Distortion=0.7, **usual)
        others = (
            {"Detail": 0.0},
            {"Detail": 0.4},
            {"Detail": 3.0},
            {"Roughness": 0.0},
            {"Roughness": 1.0},
            {"Gain": 40.0},
            {"Offset": 0.0},
            {"Lacunarity": 0.5},
            {"Distortion": -1.5},
        )
        for kind, changed in itertools.product(kinds, others):
            settings = {"noise_dimensions": "2D", "noise_type": kind, "normalize": False}
            sheet.add(f"{kind} {changed}", "TexNoise", settings, **{**usual, **changed})
        # Far away, where floats have few fractions: at places that are steps without rounding.
        for dimensions, step in itertools.product(DIMENSIONS[1:], (12345.75, 123456.75)):
            far = lambda *a, step=step: scaled(*a, stepped(*a), step)
            sheet.add(
                f"{dimensions} far",
                "TexNoise",
                {"noise_dimensions": dimensions},
                Vector=far,
                W=3e6,
                Scale=1.0,
                Detail=0.0,
            )
        self.check(sheet)

    def test_waves(self):
        sheet = Sheet()
        for shape, axis, profile in itertools.product(("bands", "rings"), ("X", "Y", "Z", None), ("SIN", "SAW", "TRI")):
            axis = axis or {"bands": "DIAGONAL", "rings": "SPHERICAL"}[shape]
            settings = {"wave_type": shape.upper(), shape + "_direction": axis, "wave_profile": profile}
            for distortion in (0.0, 3.0):
                sheet.add(
                    f"{shape} {axis} {profile} {distortion}",
                    "TexWave",
                    settings,
                    W=sloping,
                    Scale=0.4,
                    Distortion=distortion,
                    Detail=1.5,
                    Detail_Scale=2.5,
                    Detail_Roughness=0.7,
                    Phase_Offset=1.0,
                )
        sheet.add(
            "linked", "TexWave", {}, "Color", Scale=0.4, Distortion=sloping, Detail_Scale=sloping, Phase_Offset=sloping
        )
        self.check(sheet)

    def test_magic(self):
        sheet = Sheet()
        for depth, distortion in itertools.product(range(11), (1.0, 1.2, gently)):
            for output in ("Color", 1):
                sheet.add(
                    f"{depth} {distortion} {output}",
                    "TexMagic",
                    {"turbulence_depth": depth},
                    output,
                    Scale=1.3,
                    Distortion=distortion,
                )
        self.check(sheet)

    def test_white_noise(self):
        """In small cells: the numbers are hashed by their last bit."""

        sheet = Sheet()
        for dimensions, output in itertools.product(DIMENSIONS, ("Value", "Color")):
            settings = {"noise_dimensions": dimensions}
            sheet.add(f"{dimensions} {output}", "TexWhiteNoise", settings, output, Vector=stepped, W=stepped_w)
        self.check(sheet)

    def test_what_must_be_constant_is_named(self):
        sheet = Sheet()
        sheet.add("voronoi", "TexVoronoi", {}, Randomness=sloping)
        sheet.add("noise", "TexNoise", {}, Roughness=sloping, Lacunarity=2.5)
        sheet.add("wave", "TexWave", {}, Detail=sloping)
        sheet.add("unused", "TexVoronoi", {"feature": "F1"}, W=sloping, Smoothness=sloping, Exponent=sloping)
        list(sheet.compared())
        self.assertEqual(
            sorted(sheet.report.lines()),
            [
                "Noise Texture: Roughness of noise is taken as constant",
                "Voronoi Texture: Randomness of Voronoi Texture is taken as constant",
                "Wave Texture: Detail of Wave Texture is taken as constant",
            ],
        )


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0 if result.wasSuccessful() else 1)  # bpy 4.5 does not end by itself
