#!/usr/bin/env python3
"""The example program examples/render_file.cpp gives the picture that `drc render` gives: render_file_test.py DRC
RENDER_FILE."""

import json
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

DRC, RENDER_FILE = sys.argv.pop(1), sys.argv.pop(1)
ROOT = Path(__file__).resolve().parent.parent


class RenderFile(unittest.TestCase):
    def test_the_picture_is_that_of_the_program(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            scene = ROOT / "scenes" / "cornell" / "scene.pbrt"
            start = time.monotonic()
            subprocess.run([RENDER_FILE, scene, "3", folder / "mine.exr"], check=True)
            self.assertLess(time.monotonic() - start, 60)
            subprocess.run([DRC, "render", scene, "--time", "3", "--quiet", "-o", folder / "its.exr"], check=True)
            answer = subprocess.run([DRC, "compare", folder / "mine.exr", folder / "its.exr", "--json"],
                                    check=True, capture_output=True, text=True)
            self.assertLess(json.loads(answer.stdout)["relmse"], 0.05, answer.stdout)

    def test_a_wrong_scene_is_an_error(self):
        answer = subprocess.run([RENDER_FILE, "nowhere.pbrt", "1", "out.exr"], capture_output=True, text=True)
        self.assertNotEqual(answer.returncode, 0)
        self.assertEqual(answer.stderr.count("\n"), 1)
        self.assertIn("nowhere.pbrt", answer.stderr)


if __name__ == "__main__":
    unittest.main()
