"""The bench: what it runs, in which order, and what it does not run again. Other programs are shell scripts."""

import math
import os
import unittest

import numpy as np
from drc_lab.adapter import Adapter
from drc_lab.bench import BenchSettings, run_bench, scene_name
from drc_lab.budget import SPP
from drc_lab.exr_file import write_exr
from drc_lab.interrupt import Cancel
from drc_lab.log import QUIET, set_level
from drc_lab.method import Method, OwnProgram
from drc_lab.scene_references import given_references
from lab_testing import FolderTest, flat, seconds, spp, tasks, the_program


class Bench(FolderTest):
    def setUp(self):
        super().setUp()
        set_level(QUIET)
        (self.folder / "references").mkdir()
        write_exr(self.folder / "half.exr", flat(0.5), {})
        write_exr(self.folder / "large.exr", flat(0.5, 32, 12), {})
        self.reference(0.4)
        self.settings = BenchSettings(
            scenes=[self.write("room.pbrt", "WorldBegin\nWorldEnd\n")], methods=[], budgets=[spp(4)],
            own=OwnProgram(the_program().path), output=self.folder / "out", threads=2,
            references=str(self.folder / "references"),
        )  # fmt: skip

    def reference(self, value):
        write_exr(self.folder / "references/room.exr", flat(value), {})

    def add_method(self, name, script, **adapter):
        command = ["sh", "-c", f"echo {name} {{seed}} {{spp}} >>{self.folder}/log; {script}"]
        made = Adapter(name, install="write it.", commands={SPP: command}, **adapter)
        self.settings.methods.append(Method(name, lambda _: made))

    def copying(self, picture):
        return f"cp {self.folder}/{picture} {{output}}"

    def calls(self):
        log = self.folder / "log"
        lines = log.read_text().splitlines() if log.exists() else []
        log.unlink(missing_ok=True)
        return lines

    def run_bench(self, cancel=None):
        return run_bench(self.settings, cancel)

    def test_measures_what_programs_do(self):
        timing = """; echo '{{"render_seconds": 1.25, "spp": 7}}' >{timing}"""
        self.add_method("copy", self.copying("half.exr") + timing)
        report = self.run_bench()
        (run,), (scene,) = report.runs, report.scenes
        self.assertEqual(run.failure, "")
        self.assertAlmostEqual(run.mean_ratio[0], 1.25, 6)
        self.assertAlmostEqual(run.error, 0.01 / 0.17, 6)
        self.assertAlmostEqual(run.block_error, 0.01 / 0.17, 6)
        self.assertTrue(math.isnan(run.error_se) and math.isnan(run.trimmed_error))
        self.assertEqual((run.render_seconds, run.spp), (1.25, 7))
        self.assertTrue(math.isnan(run.denoise_seconds))  # nobody says that it took none
        self.assertGreater(run.png_kb, 0)
        self.assertGreater(run.peak_mb, 0)
        self.assertEqual(run.picture, "runs/room/copy/4spp-0.exr")
        self.assertTrue((self.folder / "out" / run.picture).exists())
        self.assertEqual((scene.width, scene.height, scene.reference_origin, scene.pair), (16, 12, "given", []))

    def test_of_a_pair_of_references_the_noise_is_left_out(self):
        """Against 0.4 +- 0.05 in two checkerboards that do not agree."""
        y, x = np.mgrid[:12, :16]
        for number, odd in ((1, (x + y) % 2), (2, x % 2)):
            image = flat(0.4) + np.where(odd, 0.05, -0.05)[:, :, None].astype(np.float32)
            write_exr(self.folder / f"references/room-{number}.exr", image, {})
        self.add_method("copy", self.copying("half.exr"))
        report = self.run_bench()
        (run,), (scene,) = report.runs, report.scenes
        self.assertEqual(run.failure, "")
        self.assertAlmostEqual(run.error, 0.01 / 0.17, delta=1e-3)
        self.assertTrue(math.isfinite(run.error_se) and math.isfinite(run.trimmed_error_se))
        self.assertEqual(len(scene.pair), 2)
        self.assertAlmostEqual(scene.reference_noise, 0.0025 / 0.17, delta=1e-3)
        self.assertGreater(scene.flip_noise, 0)
        self.assertEqual(scene.reference, "references/room-16x12-mean.exr")
        mean = the_program().pixels(str(self.folder / "out" / scene.reference))
        self.assertAlmostEqual(mean[1, 1, 0], 0.4, 6)

    def test_given_references_are_whole(self):
        folder = self.folder / "references"
        self.assertEqual(given_references(str(folder), "room"), [str(folder / "room.exr")])
        os.rename(folder / "room.exr", folder / "room-1.exr")
        self.assert_error(lambda: given_references(str(folder), "room"), "room-1.exr is there", "room-2.exr")
        self.assert_error(lambda: given_references(str(folder), "yard"), "yard.exr", "yard-1.exr")

    def test_pictures_are_measured_anew_when_references_change(self):
        self.add_method("a", self.copying("half.exr"))
        self.assertGreater(self.run_bench().runs[0].error, 0.01)
        self.calls()
        self.reference(0.5)
        for _ in range(2):
            self.assertAlmostEqual(self.run_bench().runs[0].error, 0, 9)
        self.assertEqual(self.calls(), [])

    def test_methods_are_innermost_and_repeats_outermost(self):
        for name in "ab":
            self.add_method(name, self.copying("half.exr"))
        self.settings.budgets, self.settings.repeats = [spp(4), spp(8)], 2
        self.run_bench()
        self.assertEqual(self.calls(), ["a 0 4", "b 0 4", "a 0 8", "b 0 8", "a 1 4", "b 1 4", "a 1 8", "b 1 8"])

    def test_what_is_known_is_not_run_again(self):
        self.add_method("a", self.copying("half.exr"))
        took = self.run_bench().runs[0].seconds
        self.calls()
        self.assertEqual(self.run_bench().runs[0].seconds, took)
        self.assertEqual(self.calls(), [])
        self.add_method("b", self.copying("half.exr"))
        self.assertEqual(len(self.run_bench().runs), 2)
        self.assertEqual(self.calls(), ["b 0 4"])
        self.write("room.pbrt", "# changed\nWorldBegin\nWorldEnd\n")
        self.run_bench()
        self.assertEqual(len(self.calls()), 2)

    def test_removed_pictures_and_damaged_records_are_made_again(self):
        self.add_method("a", self.copying("half.exr"))
        picture = self.folder / "out" / self.run_bench().runs[0].picture
        for damage in (picture.unlink, lambda: os.truncate(picture.with_suffix(".json"), 20)):
            self.calls()
            damage()
            self.run_bench()
            self.assertEqual(len(self.calls()), 1)

    def test_failures_say_what_the_program_said(self):
        for name, script in (
            ("refuses", f"echo loading; cp {self.folder}/half.exr {{output}}; echo 'line 3: no such shape' >&2; exit 1"),
            ("silent", "exit 3"),
            ("lazy", "true"),
            ("large", self.copying("large.exr")), ("damaged", "echo >{output}"), ("slow", "sleep 60"),
        ):  # fmt: skip
            self.add_method(name, script)
        self.settings.limit_seconds = 1
        failures = [run.failure for run in self.run_bench().runs]
        self.assertEqual(failures[:3], ["line 3: no such shape", "exit code 3", "ended without a picture"])
        self.assertEqual(failures[3], "wrote 32x12 pixels, not 16x12")
        self.assertIn(".exr", failures[4])
        self.assertEqual(failures[5], "still running after 1 s")
        self.calls()
        del self.settings.methods[1:]
        self.run_bench()
        self.assertEqual(len(self.calls()), 1)  # tried again

    def test_budgets_that_a_method_does_not_keep_are_left_out(self):
        self.add_method("a", self.copying("half.exr"))
        self.settings.budgets = [seconds(1), spp(4), tasks(2)]
        self.assertEqual(len(self.run_bench().runs), 1)

    def test_cancelling_keeps_what_is_done(self):
        cancel = Cancel()
        self.add_method("a", self.copying("half.exr"))
        self.assertEqual(len(self.run_bench(cancel).runs), 1)
        cancel.cancel()
        self.calls()
        self.assertEqual(self.run_bench(cancel).runs, [])
        self.assertEqual(self.calls(), [])

    def test_what_makes_it_pointless_is_an_error(self):
        self.add_method("a", self.copying("half.exr"))
        room = self.settings.scenes[0]
        self.settings.scenes = [room, self.write("other/room/scene.pbrt", "")]
        self.assert_error(self.run_bench, "called room")
        self.settings.scenes = [self.write("hall.pbrt", "")]
        self.assert_error(self.run_bench, "hall.exr")
        self.settings.scenes, self.settings.width, self.settings.height = [room], 32, 12
        self.assert_error(self.run_bench, "16x12", "32x12")
        self.assertEqual(self.calls(), [])

    def test_programs_that_are_not_installed_are_an_error_at_once(self):
        for check, what in ((["sh", "-c", "echo no module >&2; exit 1"], "no module"), (["drc-none"], "drc-none")):
            self.settings.methods = []
            self.add_method("absent", "true", check=check)
            self.assert_error(self.run_bench, "absent: not installed", what, "write it.")

    def test_a_scene_has_the_name_of_its_file_or_folder(self):
        for path in ("/a/kitchen.pbrt", "/a/kitchen/scene.pbrt", "/a/kitchen/x/../scene.pbrt"):
            self.assertEqual(scene_name(path), "kitchen")


if __name__ == "__main__":
    unittest.main()
