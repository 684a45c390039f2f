"""Runs `drc bench` as a user would, and its command line."""

import json
import os
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from drc_lab.bench_options import bench_parser, bench_settings
from drc_lab.errors import Error, UsageError
from drc_lab.threads import available_cores
from lab_testing import FolderTest, the_program

START = Path(__file__).resolve().parents[1] / "start.py"

SCENE = """
Film "image" "integer xresolution" 24 "integer yresolution" 16
LookAt 0 0 -3  0 0 0  0 1 0
Camera "perspective" "float fov" 60
WorldBegin
AttributeBegin
AreaLightSource "diffuse" "rgb L" [8 8 8]
Translate 0 1.6 0 Shape "sphere" "float radius" .4
AttributeEnd
Shape "sphere" "float radius" 1
ReverseOrientation
Shape "sphere" "float radius" 4
WorldEnd
"""


class CommandLine(FolderTest):
    def settings(self, *words):
        return bench_settings(bench_parser().parse(["room.pbrt", "--drc", sys.executable, *words]))

    def test_defaults(self):
        s = self.settings()
        self.assertEqual([method.name for method in s.methods], ["drc", "path"])
        self.assertEqual([budget.name for budget in s.budgets], ["10 s"])
        self.assertEqual((str(s.output), s.repeats, s.limit_seconds, s.own.direct_spp), ("out/bench", 1, 3600, 16))
        self.assertEqual((s.reference.error, s.reference.max_spp, s.reference.integrator), (2e-5, 65536, "path"))
        self.assertEqual((s.width, s.height), (0, 0))

    def test_lists_may_be_repeated_and_have_commas(self):
        s = self.settings("--methods", "path,bdpt", "--seconds=1,2", "--seconds", "2", "4", "--method", "a=--clamp 2")
        self.assertEqual([method.name for method in s.methods], ["path", "bdpt", "a"])
        self.assertEqual([budget.amount for budget in s.budgets], [1, 2, 4])
        self.assertEqual([m.name for m in self.settings("--method", "a=--clamp 2").methods], ["drc", "path", "a"])

    def test_the_last_of_single_options_counts(self):
        self.assertEqual(self.settings("--repeats", "2", "--repeats", "3").repeats, 3)

    def test_scenes_may_stand_on_both_sides_of_options(self):
        options = bench_parser().parse(["a.pbrt", "--quiet", "b.pbrt"])
        self.assertEqual(options.scenes, ["a.pbrt", "b.pbrt"])

    def test_shipped_adapters_are_found_by_their_name(self):
        self.assertEqual(self.settings("--methods", "cycles+oidn").methods[0].adapter.name, "cycles")

    def test_errors_are_one_line_that_says_what_would_be_right(self):
        for words, part in (
            (["--foo"], "drc bench has no option '--foo'; drc bench --help lists them"),
            (["--repeat", "2"], "did you mean '--repeats'?"), (["--samples", "3"], "did you mean '--spp'?"),
            (["--repeats", "0"], "--repeats: Value 0 not in range 1 to 1000"),
            (["--repeats"], "--repeats needs a value: INT"),
            (["--methods", "--spp", "4"], "--methods: a value is missing before --spp"),
            (["-o", ""], "--output: the value is empty"),
            (["--nthreads", "9999"], "9999 is not a whole number from 0 to"),
            (["--reference-error", "0"], "0 is not a number above 0"),
            (["--reference-error", "nan"], "--reference-error: nan is not a number"),
            (["--limit", "nan"], "--limit: nan is not a number"),
            (["--nthreads", "100000"], "--nthreads: 100000 is not"),
            (["--limit", "0"], "not a number of seconds above 0"),
            (["--reference-integrator", "foo"], "foo not in {path,bdpt}"),
            (["--reference-spp", "1e3"], "1e3 is not a whole number from 1 to 16777216"),
            (["--seconds", "ten"], "--seconds ten: give positive numbers"), (["--seconds", "-1"], "positive"),
            (["--methods", "path", "--spp", "1.5"], "whole"), (["--methods", "pathe"], "'pathe'"),
            (["--methods", "path,path"], "two methods are called path"), (["--methods", "a=b"], "by --method"),
            (["--methods", "drc-maps", "--spp", "4"], "drc-maps keeps none"),
            (["--method", "--clamp 4"], "NAME=OPTIONS"),
            (["--methods", "drc", "--tasks", "4"], "drc keeps none"), (["--resolution", "64"], "as 1280x720"),
            (["--resolution", "64x10"], "from 11 pixels upwards"), (["--methods", "path+oidn:best"], "fast-raw"),
        ):  # fmt: skip
            with self.subTest(words):
                with self.assertRaises(UsageError) as caught:
                    self.settings(*words)
                self.assertIn(part, str(caught.exception))
                self.assertNotIn("\n", str(caught.exception))
        with self.assertRaisesRegex(UsageError, "SCENE is required"):
            bench_parser().parse([])
        with self.assertRaisesRegex(Error, "none"):
            self.settings("--adapter", str(self.folder / "none"))


class Threads(FolderTest):
    def test_no_more_than_the_control_groups_give(self):
        self.write("groups", "0::/a/b\n")
        for group, text in (("", "max 100000"), ("a", "120000 100000"), ("a/b", "max 100000")):
            self.write(f"mount/{group}/cpu.max", text)
        cores = available_cores(self.folder / "groups", self.folder / "mount")
        self.assertEqual(cores, min(2, len(os.sched_getaffinity(0))))
        self.write("mount/a/b/cpu.max", "50000 100000")
        self.assertEqual(available_cores(self.folder / "groups", self.folder / "mount"), 1)
        self.assertEqual(available_cores(self.folder / "none", self.folder), len(os.sched_getaffinity(0)))


class BenchCommand(FolderTest):
    def setUp(self):
        super().setUp()
        self.program = the_program().path
        self.scene = self.write("room/scene.pbrt", SCENE)
        self.out = self.folder / "out"

    def command(self, *words, python=(sys.executable,)):
        return [
            *python,
            str(START),
            "bench",
            "--drc",
            self.program,
            self.scene,
            "-o",
            str(self.out),
            "--nthreads",
            "1",
            *words,
        ]

    def bench(self, *words, **options):
        return subprocess.run(self.command(*words, **options), capture_output=True, text=True)

    def report(self):
        return json.loads((self.out / "bench.json").read_text())

    def test_compares_with_references_of_its_own(self):
        words = ["--methods", "path,bdpt,drc+off,drc-maps:gaussian", "--spp", "2..4", "--tasks", "1",
                 "--direct-spp", "2", "--method", "fine=--integrator drc-maps --spacing 4", "--reference-error", "0.01",
                 "--resolution", "24x16", "--repeats", "2"]  # fmt: skip
        done = self.bench(*words)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("| room  | path", done.stdout)
        self.assertIn("## 1 task\n", done.stdout)
        self.assertIn("0 failed", done.stderr)
        self.assertEqual((self.out / "bench.md").read_text(), done.stdout)
        report = self.report()
        (scene,) = report["scenes"]
        self.assertIn("path, 2 x ", scene["reference_origin"])
        self.assertEqual((scene["width"], len(scene["reference_pair"])), (24, 2))
        self.assertEqual(len(report["runs"]), 2 * (3 * 2 + 2))
        for run in report["runs"]:
            self.assertNotIn("failure", run)
            self.assertGreater(run["error_se"], 0)
            self.assertLess(run["block_error"], run["error"])
            self.assertGreater(run["spp"], 0)
            # Only the layers of radiance maps are denoised here.
            self.assertEqual(run["denoise_seconds"] > 0.0005, run["budget"]["unit"] == "tasks", run)
            for ratio in run["mean_ratio"]:
                self.assertAlmostEqual(ratio, 1, delta=0.2)
            self.assertGreater(run["seconds"], run["render_seconds"])
            self.assertGreater(run["peak_mb"], 1)
        page = (self.out / "index.html").read_text()
        self.assertIn("fine", page)
        self.assertIn("data:image/png;base64,", page)
        self.assertEqual([path.name for path in self.out.rglob("*.tmp")], [])

        # A second call does not measure anything again.
        self.assertEqual(self.bench(*words).returncode, 0)
        self.assertEqual(self.report(), report)

    def test_bad_requests_get_one_line(self):
        for words, status, part in (
            (["--seconds", "ten"], 64, "--seconds ten"), (["--references", str(self.folder / "no")], 1, "room-1.exr"),
            (["--oidn"], 64, "no option '--oidn'"),
        ):  # fmt: skip
            done = self.bench(*words)
            self.assertEqual(done.returncode, status, done.stderr)
            last = done.stderr.strip().splitlines()[-1]
            self.assertTrue(last.startswith("drc: error: ") and part in last, done.stderr)
            self.assertFalse((self.out / "index.html").exists())
        self.write("room/scene.pbrt", 'Shape "sphere"\n')
        self.assertIn("scene.pbrt:1:", self.bench("--quiet", "--resolution", "24x16").stderr)

    def test_an_interruption_ends_the_program_and_keeps_what_is_done(self):
        words = ["--methods", "path", "--seconds", "0.1,60", "--reference-error", "1", "--resolution", "24x16"]
        bench = subprocess.Popen(self.command(*words), stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        for line in bench.stderr:
            if "path, 60 s: rendering" in line:
                break
        time.sleep(0.3)
        bench.send_signal(signal.SIGINT)
        out, err = bench.communicate(timeout=30)
        self.assertEqual(bench.returncode, 130, err)
        self.assertIn("interrupted; called again in the same way, it goes on", err)
        self.assertTrue((self.out / "index.html").exists())
        self.assertEqual([run["budget"]["amount"] for run in self.report()["runs"]], [0.1])
        children = subprocess.run(["pgrep", "-f", str(self.out)], capture_output=True, text=True).stdout
        self.assertEqual(children, "")

    def test_without_modules_there_is_one_line_and_help(self):
        bare = (sys.executable, "-S")  # without site-packages
        small = ["--spp", "1", "--methods", "path", "--resolution", "24x16", "--reference-error", "1"]
        done = self.bench(*small, python=bare)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn("no module numpy and none called matplotlib", done.stderr)
        self.assertIn("apt install python3-numpy python3-matplotlib python3-jinja2", done.stderr)
        self.assertFalse(self.out.exists())
        done = self.bench("--help", python=bare)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("--reference-integrator", done.stdout)


if __name__ == "__main__":
    unittest.main()
