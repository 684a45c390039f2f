"""Rendered references: their samples, their noise, and how they are kept."""

import unittest

import numpy as np
from drc_lab.exr_file import write_exr
from drc_lab.interrupt import Cancel
from drc_lab.program import Program
from drc_lab.reference import ReferenceSettings, render_references
from drc_lab.reference_noise import reference_noise, standard_error
from lab_testing import FolderTest, picture_of, the_program

# Renders by copying the picture of a stream, which the seed modulo four names; all else is the real program's.
_RENDERER = """#!/bin/sh
if [ "$1" != render ]; then exec {drc} "$@"; fi
while [ $# -gt 0 ]; do case $1 in
  --seed) seed=$2;; --spp) spp=$2;; -o) out=$2;; esac; shift; done
echo $spp $seed >>{folder}/log
cp {folder}/$((seed % 4)).exr $out
"""


class ExrFiles(FolderTest):
    def test_come_back_as_they_were(self):
        program = the_program()
        pixels = picture_of(3, 37, 41)
        pixels[5, 7] = (1e6, -2.5, 1e-8)
        path = self.folder / "picture.exr"
        write_exr(path, pixels, {"drc:bench_key": "two\nlines", "drc:bench_spp": "48"})
        np.testing.assert_array_equal(program.pixels(str(path)), pixels)
        self.assertEqual(program.metadata(str(path)), {"drc:bench_key": "two\nlines", "drc:bench_spp": "48"})


class Noise(FolderTest):
    def test_is_that_of_drc_compare(self):
        program, random = the_program(), np.random.default_rng(1)
        truth = picture_of(20, 70, 50)
        pair = [(truth + random.normal(0, 0.1, truth.shape)).astype(np.float32) for _ in range(2)]
        pair[0][9, 9] = 40  # a firefly
        pair[1][20, 30] = pair[0][20, 30] = 8  # a highlight
        paths = [str(self.folder / f"{i}.exr") for i in (1, 2)]
        for path, image in zip(paths, pair):
            write_exr(path, image, {})
        write_exr(self.folder / "test.exr", truth, {})
        told = program.compare(paths, str(self.folder / "test.exr"))
        self.assertAlmostEqual(reference_noise(*pair) / told["reference_noise"], 1, 4)

    def test_the_standard_error_is_that_of_the_products(self):
        random = np.random.default_rng(2)
        halves = [random.normal(1, 0.2, (48, 48, 1)).repeat(3, axis=2) for _ in range(4)]
        # Each reference has the variance 0.02; the mean of 48 x 48 products has the deviation 0.02 / 48 / 1.01.
        self.assertAlmostEqual(standard_error(halves), 0.02 / 48 / 1.01, delta=0.35 * 0.02 / 48)


class References(FolderTest):
    def setUp(self):
        super().setUp()
        renderer = _RENDERER.format(drc=the_program().path, folder=self.folder)
        self.program = Program(self.write("drc", renderer, executable=True))
        self.settings = ReferenceSettings(error=1e-4, threads=1)
        self.pictures(0)
        (self.folder / "references").mkdir()

    def pictures(self, deviation):
        """Streams that are 1 on average."""
        random = np.random.default_rng(1)
        for stream in range(4):
            image = 1 + deviation * random.standard_normal((48, 48, 1)).repeat(3, axis=2)
            image[0, 0] = 1 + 0.01 * stream
            write_exr(self.folder / f"{stream}.exr", image.astype(np.float32), {})

    def render(self, key="key", cancel=None):
        folder = self.folder / "references"
        return render_references(self.program, "room.pbrt", "room", 48, 48, folder, key, self.settings, cancel)

    def calls(self):
        """Samples and seeds of the renders since the last time."""
        log = self.folder / "log"
        lines = log.read_text().splitlines() if log.exists() else []
        log.unlink(missing_ok=True)
        return lines

    def test_are_two_of_four_seeds(self):
        references = self.render()
        calls = self.calls()
        self.assertEqual(len(calls), 4)
        self.assertEqual(calls[0], f"32 {1 << 20}")
        self.assertEqual(len(set(calls)), 4)
        first, second = (self.program.pixels(str(path)) for path in (references.first, references.second))
        self.assertEqual(first[3, 3, 0], 1)
        self.assertAlmostEqual(first[0, 0, 0], 1.005, 6)  # of streams 0 and 1
        self.assertAlmostEqual(second[0, 0, 0], 1.025, 6)  # of streams 2 and 3
        self.assertIn("path, 2 x 64 spp", references.origin)
        names = sorted(
            str(path.relative_to(self.folder / "references")) for path in self.folder.rglob("references/**/*.exr")
        )
        parts = [f"room-48x48/{stream}.exr" for stream in ("1a", "1b", "2a", "2b")]
        self.assertEqual(names, ["room-48x48-1.exr", "room-48x48-2.exr", *parts])

    def test_get_more_samples_until_they_are_good_enough(self):
        self.pictures(0.2)  # the same in each part: never good enough
        self.settings.max_spp = 200
        self.assertIn("2 x 144 spp", self.render().origin)  # 64, 96, 144; then 216 would be
        calls = self.calls()
        self.assertEqual([call.split()[0] for call in calls], ["32"] * 4 + ["16"] * 4 + ["24"] * 4)
        self.assertEqual({int(call.split()[1]) for call in calls}, set(range(1 << 20, (1 << 20) + 12)))
        self.settings.error = 1e-2  # they are good enough for a caller who wants less
        self.render()
        self.assertEqual(self.calls(), [])
        self.settings.error, self.settings.max_spp = 1e-5, 220  # one who wants more goes on
        self.assertIn("2 x 216 spp", self.render().origin)
        calls = self.calls()
        self.assertEqual(len(calls), 4)
        self.assertTrue(calls[0].startswith("36 "))

    def test_are_kept_for_their_key(self):
        self.render()
        self.calls()
        self.render()
        self.assertEqual(self.calls(), [])
        self.render("another state of the scene")
        self.assertEqual(len(self.calls()), 4)
        self.settings.integrator = "bdpt"
        self.render("another state of the scene")
        self.assertEqual(len(self.calls()), 4)
        lost = self.folder / "references/room-48x48-2.exr"
        lost.unlink()
        self.render("another state of the scene")
        self.assertEqual(self.calls(), [])  # the samples are there
        self.assertTrue(lost.exists())

    def test_go_on_after_an_interruption(self):
        (self.folder / "2.exr").rename(self.folder / "hidden.exr")
        self.assert_error(self.render, "references of room could not be rendered")
        self.assertEqual(len(self.calls()), 3)
        self.assertFalse((self.folder / "references/room-48x48-1.exr").exists())
        (self.folder / "hidden.exr").rename(self.folder / "2.exr")
        self.render()
        self.assertEqual(len(self.calls()), 2)  # the first two parts were there

    def test_cancelled_there_are_none(self):
        cancel = Cancel()
        cancel.cancel()
        self.assertIsNone(self.render(cancel=cancel))

    def test_too_few_samples_are_an_error(self):
        self.settings.max_spp = 40
        self.assert_error(self.render, "64 spp")


if __name__ == "__main__":
    unittest.main()
