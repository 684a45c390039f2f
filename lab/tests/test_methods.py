"""Methods, adapters, and the modes of Open Image Denoise."""

import json
import re
import subprocess
import unittest

from drc_lab.adapter import Adapter, read_adapter
from drc_lab.budget import SECONDS, SPP, TASKS
from drc_lab.errors import Error
from drc_lab.method import INTEGRATORS, Job, Method, OwnProgram
from drc_lab.oidn_mode import MODES, best_mode, find_mode
from lab_testing import FolderTest, seconds, spp, tasks, the_program


def only_other(name):
    return (
        Adapter("other", denoisers=["oidn"], commands={SPP: ["run", "{spp}", "{denoiser}", "{drc}"]})
        if name == "other"
        else None
    )


def job(budget):
    return Job("s.pbrt", "o.exr", "t.json", width=32, height=16, threads=2, seed=5, budget=budget)


def line(method, budget, own=OwnProgram("drc")):
    return " ".join(Method(method, only_other).command(job(budget), own)) + " "


class Methods(FolderTest):
    def test_our_integrators_get_their_budget(self):
        self.assertEqual(
            line("path", seconds(2.5)),
            "drc render s.pbrt --integrator path --denoise off --time 2.5 --resolution 32x16 --nthreads 2 --seed 5 "
            "--timing t.json --quiet -o o.exr ",
        )
        self.assertIn("--integrator bdpt --denoise off --spp 64 ", line("bdpt", spp(64)))
        self.assertIn("--integrator drc --spp 64 ", line("drc", spp(64)))
        maps = line("drc-maps", tasks(256), OwnProgram("drc", 8))
        self.assertIn("--indirect-tasks 256 --spp 8 ", maps)
        self.assertNotIn("--denoise", maps)

    def test_map_denoisers_networks_and_denoisers(self):
        own = OwnProgram("drc", oidn_library="lib.so")
        self.assertIn("--integrator drc-maps --map-denoiser gaussian ", line("drc-maps:gaussian", seconds(1)))
        self.assertIn("--weights paper-k64 --denoise off ", line("drc-maps:paper-k64+off", seconds(1)))
        self.assertIn("--denoise oidn --oidn-library lib.so ", line("path+oidn", seconds(1), own))
        self.assertNotIn("lib.so", line("path", seconds(1), own))

    def test_open_image_denoise_is_asked_for_a_mode(self):
        """32x16 pixels are denoised in no time; of a budget in samples denoising takes nothing."""
        best = "--denoise oidn --oidn-quality high --oidn-prefilter on "
        for method, budget in (("path+oidn", seconds(1)), ("path+oidn", spp(1)), ("path+oidn:high", seconds(1e-4))):
            self.assertIn(best, line(method, budget))
        self.assertIn("--oidn-quality fast --oidn-prefilter off ", line("path+oidn", seconds(1e-4)))
        self.assertIn("--oidn-quality balanced --oidn-prefilter off ", line("path+oidn:balanced-raw", seconds(1)))
        self.assertIn("--denoise oidn-direct --oidn-quality fast ", line("drc-maps+oidn-direct:fast-raw", seconds(1)))
        self.assertNotIn("--oidn", line("drc+off", seconds(1)))
        self.assertEqual(Method("path+oidn:fast-raw", only_other).oidn_mode(job(seconds(1))).name, "fast-raw")
        for method in ("path", "other+oidn"):
            self.assertIsNone(Method(method, only_other).oidn_mode(job(seconds(1))))

    def test_options_of_ones_own(self):
        many = Method("many maps=--integrator drc-maps --spacing 2", only_other)
        self.assertEqual(many.name, "many maps")
        self.assertEqual(
            many.command(job(tasks(4)), OwnProgram("drc"))[3:7], ["--integrator", "drc-maps", "--spacing", "2"]
        )
        self.assertTrue(many.keeps(TASKS))
        for text in ("a=--integrator path", "a=--integrator=bdpt", "a=--integrator scene", "a=--clamp 2"):
            self.assertFalse(Method(text, only_other).keeps(TASKS), text)
            self.assertTrue(Method(text, only_other).keeps(SPP), text)

    def test_other_programs_by_their_adapter(self):
        self.assertEqual(line("other", spp(8)), "run 8 off drc ")
        self.assertEqual(line("other+oidn", spp(8)), "run 8 oidn drc ")
        self.assertFalse(Method("other", only_other).keeps(SECONDS))

    def test_units_that_ours_keep(self):
        for name in INTEGRATORS:
            method = Method(name, only_other)
            kept = [method.keeps(unit) for unit in (SECONDS, SPP, TASKS)]
            self.assertEqual(kept, [True, name != "drc-maps", name == "drc-maps"], name)

    def test_integrators_are_those_of_the_program(self):
        help_text = subprocess.run([the_program().path, "render", "--help"], capture_output=True, text=True).stdout
        listed = re.search(r"--integrator TEXT:\{([^}]*)\}", help_text)
        self.assertIsNotNone(listed)
        self.assertEqual(set(listed[1].split(",")) - {"scene"}, set(INTEGRATORS))

    def test_errors_say_what_would_be_right(self):
        cases = {
            "pathh": ("'pathh'", "bdpt"), "path:gaussian": ("only drc-maps takes",),
            "drc-maps:": ("only drc-maps takes",),
            "drc+nlm": ("oidn-direct",), "path+surface": ("only drc-maps has",),
            "drc+oidn-direct": ("only drc-maps has",),
            "a=--integrator photon": ("no integrator 'photon'",), "other+optix": ("'optix'",),
            "path+oidn:best": ("'path+oidn:best'", "balanced-raw, fast-raw"),
            "drc-maps+surface:high": ("have the modes",), "=--spacing 2": ("no name",),
        }  # fmt: skip
        for text, parts in cases.items():
            with self.subTest(text):
                self.assert_error(lambda: Method(text, only_other), *parts)


class Modes(unittest.TestCase):
    def test_the_budget_pays_for_it(self):
        users = 1280 * 720
        for budget, pixels, threads, name in (
            (10, users, 2, "balanced-raw"), (30, users, 2, "balanced-raw"), (60, users, 2, "high"),
            (30, users, 16, "high"), (7.5, users / 4, 2, "balanced-raw"), (0.1, users, 2, "fast-raw"),
        ):  # fmt: skip
            self.assertEqual(best_mode(budget, pixels, threads).name, name, (budget, pixels, threads))

    def test_by_name(self):
        self.assertTrue(all(find_mode(mode.name) is mode for mode in MODES))
        self.assertIsNone(find_mode("best"))


WHOLE = {
    "name": "other", "about": "another renderer", "install": "buy it", "check": ["{folder}/check", "--version"],
    "denoisers": ["oidn"],
    "command": {
        "seconds": ["run", "--time={seconds}", "{scene}", "{output}"],
        "spp": ["run", "{spp}", "{width}x{height}", "{seed}", "{threads}", "{denoiser}", "{timing}", "{{x}}"],
    },
}  # fmt: skip


class Adapters(FolderTest):
    def read(self, text):
        return read_adapter(self.write("adapter.json", text))

    def test_say_how_to_run_a_program(self):
        adapter = self.read(json.dumps(WHOLE))
        self.assertEqual(adapter.check, [f"{self.folder}/check", "--version"])
        values = {"scene": "a {b}.pbrt", "output": "o.exr", "timing": "t.json", "denoiser": "", "width": "64",
                  "height": "48", "threads": "2", "seed": "3", "seconds": "2.5", "spp": "16"}  # fmt: skip
        self.assertEqual(adapter.command(SECONDS, values), ["run", "--time=2.5", "a {b}.pbrt", "o.exr"])
        self.assertEqual(adapter.command(SPP, values), ["run", "16", "64x48", "3", "2", "off", "t.json", "{x}"])
        self.assertEqual(read_adapter(str(self.folder)).name, "other")  # by its folder

    def test_errors_name_the_file_and_the_key(self):
        whole = json.dumps(WHOLE)
        cases = [
            ("{", "not JSON"), ("[]", "object"), (whole.replace('"name"', '"nome"'), '"nome"'),
            (whole.replace('"name": "other", ', ""), '"name" is missing'), (whole.replace('"other"', '"a+b"'), "a+b"),
            (whole.replace('"other"', "7"), '"name"'), (whole.replace('["oidn"]', '"oidn"'), '"denoisers"'),
            (whole.replace("{scene}", "{scone}"), "{scone}"), (whole.replace("{seconds}", "{spp}"), "{spp}"),
            (whole.replace("{scene}", "{scene"), "not closed"), (whole.replace("{scene}", "scene}"), "not opened"),
            (whole.replace('"spp":', '"tasks":'), '"tasks"'), (whole.replace("{folder}", "{scene}"), '"check"'),
        ]  # fmt: skip
        for text, part in cases:
            with self.subTest(part):
                self.assert_error(lambda: self.read(text), "adapter.json", part)
        with self.assertRaises(Error):
            read_adapter(str(self.folder / "none.json"))


if __name__ == "__main__":
    unittest.main()
