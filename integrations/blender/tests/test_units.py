#!/usr/bin/env python3
"""What of the add-on needs no Blender: scene text, PLY, pictures, camera maths, patterns, the receiver of pictures, the
renderer as a child, the client of the live view.

    integrations/blender/tests/test_units.py [--drc build/release/drc]

Without the program, the tests that need it are skipped; without numpy all are: it ends with status 77.
"""

import json
import math
import os
import re
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib
from dataclasses import replace

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
try:
    import numpy as np
except ImportError:
    print("skipped: this Python has no numpy")
    sys.exit(77)

from drc_blender.commands import render_command, scene_file_name, view_command
from drc_blender.export.cache import FileCache, digest
from drc_blender.export.camera_maths import Lens, lens_radius, pixel_bounds, screen_window
from drc_blender.export.equal_area import directions
from drc_blender.export.image_files import pfm_bytes, png_bytes, srgb_to_linear
from drc_blender.export.objects import invertible, stretch_of
from drc_blender.export.pbrt_text import Names, number, quoted, statement, transform
from drc_blender.export.ply import merged_corners, ply_bytes
from drc_blender.export.report import Report
from drc_blender.export.spaces import world_to_camera, world_to_panorama
from drc_blender.materials.atlas import Atlas
from drc_blender.materials.blackbody import blackbody
from drc_blender.materials.image_lookup import Pixels, equirectangular
from drc_blender.materials.light_profile import LightProfile
from drc_blender.program import Child, UserError, ends_with_us, find_program
from drc_blender.render_passes import pass_values
from drc_blender.tev_receiver import Picture, TevReceiver
from drc_blender.view_camera import frame_size, is_view, view_of
from drc_blender.view_client import ViewClient, frame_of, origin_of, progress_of, resting

DRC = None
ROOT = os.path.abspath(os.path.join(HERE, *[os.pardir] * 3))
CORNELL = os.path.join(ROOT, "scenes", "cornell", "scene.pbrt")
PATIENCE = 60


def wait_for(condition, seconds=PATIENCE):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise AssertionError("waited in vain")
        time.sleep(0.01)


def runs(pid):
    """Whether the process has not ended, be it waited for or not."""
    try:
        with open(f"/proc/{pid}/stat") as f:
            return f.read().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False


def command_line(pid):
    with open(f"/proc/{pid}/cmdline", "rb") as f:
        return f.read()


class SceneText(unittest.TestCase):
    def test_statement(self):
        self.assertEqual(
            statement(
                "Shape",
                "sphere",
                params={
                    "float radius": 2.5,
                    "rgb L": (1, 0.5, 0),
                    "bool twosided": True,
                    "string filename": "a.ply",
                    "texture alpha": "t",
                    "integer n": [1, 2],
                },
            ),
            'Shape "sphere" "float radius" [2.5] "rgb L" [1 0.5 0] "bool twosided" [true] '
            '"string filename" ["a.ply"] "texture alpha" ["t"] "integer n" [1 2]',
        )

    def test_numbers_keep_their_float(self):
        for value in np.random.default_rng(1).standard_normal(1000).astype(np.float32) * np.float32(1e10):
            self.assertEqual(np.float32(float(number(value))), value)

    def test_what_a_file_cannot_say(self):
        for value in (math.inf, math.nan):
            with self.assertRaisesRegex(ValueError, "^(inf|nan), which a scene file cannot have$"):
                number(value)
        with self.assertRaisesRegex(ValueError, "^radius is nan, "):
            statement("Shape", "sphere", params={"float radius": math.nan})
        self.assertEqual(quoted('a"b\\c\nd'), '"a_b_c_d"')

    def test_transform_is_written_by_columns(self):
        rows = [[1, 2, 3, 4], [5, 6, 7, 8], [9, 10, 11, 12], [0, 0, 0, 1]]
        self.assertEqual(transform(rows), "Transform [1 5 9 0 2 6 10 0 3 7 11 0 4 8 12 1]")

    def test_names_differ(self):
        names = Names()
        self.assertEqual([names.of(n) for n in ("a b", "a_b", "", "ä")], ["a_b", "a_b.2", "unnamed", "ä"])

    def test_report_has_each_message_once(self):
        report = Report()
        for name in "abcde":
            report.add("no equal", name, "node")
        report.add("whole")
        self.assertEqual(report.lines(), ["a > node, b > node, c > node and 2 more: no equal", "whole"])

    def test_report_has_a_line_for_each_message_whatever_the_names(self):
        report = Report()
        report.add("no equal", "of two\nlines", "node\t")
        self.assertEqual(report.lines(), ["of two lines > node: no equal"])


class Files(unittest.TestCase):
    def test_ply(self):
        data = ply_bytes([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], uvs=[[0, 0], [1, 0], [0, 1]])
        head, body = data.split(b"end_header\n")
        self.assertIn(b"element vertex 3\n", head)
        self.assertIn(b"property float u\nproperty float v\nelement face 1\n", head)
        self.assertEqual(
            body, struct.pack("<15f", 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1) + struct.pack("<B3i", 3, 0, 1, 2)
        )

    def test_equal_corners_become_one_vertex(self):
        rows = np.random.default_rng(2).integers(0, 50, (5000, 3)).astype(np.uint32)
        first, vertex = merged_corners(rows)
        self.assertTrue(np.array_equal(rows[first][vertex], rows))
        self.assertEqual(len(first), len(np.unique(rows, axis=0)))

    def test_pfm_and_png(self):
        self.assertEqual(pfm_bytes(np.array([[1, 2], [3, 4]])), b"Pf\n2 2\n-1.0\n" + struct.pack("<4f", 3, 4, 1, 2))
        pixels = np.arange(24, dtype=np.uint8).reshape(2, 4, 3)
        data = png_bytes(pixels)
        start = data.index(b"IDAT") + 4
        self.assertEqual(zlib.decompress(data[start:-16]), b"\0" + pixels[0].tobytes() + b"\0" + pixels[1].tobytes())

    def test_a_file_is_written_once(self):
        with tempfile.TemporaryDirectory() as folder:
            cache = FileCache(folder, "meshes")
            made = []
            for _ in range(2):
                cache.file("k", "ply", lambda: made.append(1) or b"data")
            cache.file("other", "ply", lambda: b"")
            self.assertEqual((made, cache.written), ([1], 2))
            again = FileCache(folder, "meshes")
            again.file("k", "ply", lambda: self.fail("it is there"))
            again.remove_unused()
            self.assertEqual(os.listdir(os.path.join(folder, "meshes")), ["k.ply"])

    def test_digests_tell_apart(self):
        a = np.arange(4, dtype=np.float32)
        keys = [
            digest(a),
            digest(a.astype(np.float64)),
            digest(a.reshape(2, 2)),
            digest("ab", "c"),
            digest("a", "bc"),
            digest(a[::2]),
        ]
        self.assertEqual(len(set(keys)), len(keys))
        self.assertEqual(digest(a[::2]), digest(a[::2].copy()))


class Cameras(unittest.TestCase):
    def test_window_of_a_wide_picture(self):
        x = 18 / 50
        np.testing.assert_allclose(screen_window(Lens(), 1920, 1080), (-x, x, -x * 9 / 16, x * 9 / 16))

    def test_window_of_a_tall_picture(self):
        y = 18 / 50  # the sensor's width is along the longer side
        np.testing.assert_allclose(screen_window(Lens(), 600, 800), (-y * 0.75, y * 0.75, -y, y))

    def test_vertical_fit_shift_and_pixel_aspect(self):
        window = screen_window(Lens(sensor_fit="VERTICAL", shift_x=0.25), 400, 200, 2.0)
        y = 12 / 50
        np.testing.assert_allclose(window, (-y + 0.5 * y, y + 0.5 * y, -y, y))

    def test_orthographic(self):
        np.testing.assert_allclose(screen_window(Lens(orthographic=True, ortho_scale=4), 200, 100), (-2, 2, -1, 1))

    def test_lens(self):
        self.assertAlmostEqual(lens_radius(False, 50, 2.8), 0.05 / 5.6)
        self.assertAlmostEqual(lens_radius(True, 50, 2.0), 0.25)

    def test_region(self):
        self.assertEqual(pixel_bounds((0.25, 0.75, 0.0, 0.5), 100, 40), (25, 75, 20, 40))
        x0, x1, y0, y1 = pixel_bounds((1, 1, 0.5, 0.5), 10, 10)
        self.assertTrue(0 <= x0 < x1 <= 10 and 0 <= y0 < y1 <= 10)

    def test_a_blender_camera_looks_along_its_minus_z(self):
        m = np.eye(4)
        m[:3, :3] *= 3  # the scale of a camera does not count
        m[:3, 3] = 1, 2, 3
        to_camera = world_to_camera(m)
        np.testing.assert_allclose(to_camera @ (1, 2, 2, 1), (0, 0, 1, 1), atol=1e-12)
        np.testing.assert_allclose(to_camera @ (2, 3, 3, 1), (1, 1, 0, 1), atol=1e-12)

    def test_a_panorama_has_the_direction_of_view_in_its_middle(self):
        to_camera = world_to_panorama(np.eye(4))
        np.testing.assert_allclose(to_camera @ (0, 0, -1, 0), (-1, 0, 0, 0))  # which DRC has in the middle
        np.testing.assert_allclose(to_camera @ (1, 0, 0, 0), (0, 0, -1, 0))  # and this at three quarters
        np.testing.assert_allclose(to_camera @ (0, 1, 0, 0), (0, 1, 0, 0))

    def test_view_from_opengl(self):
        n, f, w = 0.1, 100, (-0.3, 0.5, -0.2, 0.4)
        p = np.zeros((4, 4))
        for axis in (0, 1):
            low, high = n * w[2 * axis], n * w[2 * axis + 1]
            p[axis, axis], p[axis, 2] = 2 * n / (high - low), (high + low) / (high - low)
        p[2, 2], p[2, 3], p[3, 2] = -(f + n) / (f - n), -2 * f * n / (f - n), -1
        to_world = np.eye(4)
        to_world[:3, 3] = 4, 5, 6
        view = view_of(np.linalg.inv(to_world), p)
        np.testing.assert_allclose(view.window, w)
        self.assertFalse(view.orthographic)
        eye, look, up = view.eye_look_up((1, 1, 1))
        np.testing.assert_allclose((eye, look, up), ((3, 4, 5), (3, 4, 4), (0, 1, 0)))
        camera = view_of(np.linalg.inv(to_world), p, (0.25, 7)).as_camera((1, 1, 1))
        self.assertEqual(camera["eye"], list(eye))
        self.assertEqual(
            camera["lens"], {"orthographic": False, "window": list(view.window), "radius": 0.25, "focalDistance": 7}
        )

    def test_orthographic_view_from_opengl(self):
        w = (-3, 5, -2, 4)
        p = np.eye(4)
        for axis in (0, 1):
            low, high = w[2 * axis : 2 * axis + 2]
            p[axis, axis], p[axis, 3] = 2 / (high - low), -(high + low) / (high - low)
        view = view_of(np.eye(4), p)
        np.testing.assert_allclose(view.window, w)
        self.assertTrue(view.orthographic)

    def test_orthographic_views_are_taken_from_before_the_scene(self):
        n, f = -1000, 1000
        p = np.diag([1, 1, -2 / (f - n), 1.0])
        p[2, 3] = -(f + n) / (f - n)
        view = view_of(np.eye(4), p)  # from the origin, along -z
        self.assertAlmostEqual(view.near, -1000)
        moved = view.before((np.array((3, 4, 5)), 10))
        np.testing.assert_allclose(moved.matrix()[:3, 3], (0, 0, 5 + 10.1))
        self.assertEqual((moved.window, moved.orthographic), (view.window, view.orthographic))
        self.assertAlmostEqual(moved.focus - view.focus, 15.1)
        self.assertEqual(view.before((np.array((3, 4, -50)), 10)), view)
        # Not farther than Blender sees.
        np.testing.assert_allclose(view.before((np.zeros(3), 1e6)).matrix()[:3, 3], (0, 0, 1000))

    def test_views_of_nothing(self):
        good, projection = np.eye(4), np.diag([1.0, 1, 1, 0])
        self.assertTrue(is_view(good, projection))
        self.assertFalse(is_view(np.diag([1.0, 0, 1, 1]), projection))
        self.assertFalse(is_view(good * np.nan, projection))
        self.assertFalse(is_view(good, projection * np.inf))

    def test_frame_sizes(self):
        self.assertEqual(frame_size(1920, 1080, 640), (640, 360))
        self.assertEqual(frame_size(10000, 5), (4096, 16))


class Placings(unittest.TestCase):
    def place(self, *scale):
        turned = np.linalg.qr(np.random.default_rng(3).standard_normal((3, 3)))[0]
        matrix = np.eye(4)
        matrix[:3, :3] = turned @ np.diag(scale)
        matrix[:3, 3] = 4, 5, 6
        return matrix

    def test_what_can_be_inverted_stays(self):
        for scale in ((1, 1, 1), (-1, 2, 3), (1e-6, 1e-6, 1e-6), (1, 1, 1e-5), (1e5, 1, 1)):
            np.testing.assert_array_equal(invertible(self.place(*scale)), self.place(*scale))

    def test_flat_objects_get_the_thickness_of_paper(self):
        for axis in range(3):
            scale = [2.0, 3.0, 4.0]
            scale[axis] = 0
            flat, made = self.place(*scale), invertible(self.place(*scale))
            self.assertLess(np.abs(made - flat).max(), 4e-4)
            self.assertLess(np.linalg.cond(made[:3, :3]), 1e5)
            np.testing.assert_array_equal(made[:, 3], flat[:, 3])

    def test_what_stretches(self):
        for scale in ((2, 2, 2), (-3, 3, 3), (1, 1, 1.005)):
            self.assertIsNone(stretch_of(self.place(*scale)))
        for scale in ((1, 2, 3), (-1, 1, 5), (1, 1, 1e-4)):
            matrix = self.place(*scale)
            stretch = stretch_of(matrix)
            self.assertAlmostEqual(np.linalg.det(stretch), 1)
            rest = matrix @ np.linalg.inv(stretch)
            lengths = np.linalg.norm(rest[:3, :3], axis=0)
            np.testing.assert_allclose(lengths, abs(np.prod(scale)) ** (1 / 3), rtol=1e-6)
            np.testing.assert_allclose(rest[:3, 3], (4, 5, 6))

    def test_lines_and_points_are_not_seen(self):
        self.assertIsNone(invertible(self.place(0, 0, 0)))
        self.assertIsNone(invertible(self.place(0, 7, 0)))

    def test_no_numbers(self):
        with self.assertRaisesRegex(ValueError, "no number"):
            invertible(self.place(1, math.nan, 1))
        for scale in ((0, 1, 1), (1, math.inf, 1)):
            with self.assertRaisesRegex(ValueError, "camera has a scale"):
                world_to_camera(np.diag([*scale, 1]))


class Pictures(unittest.TestCase):
    def test_equal_areas(self):
        d = directions(64)
        np.testing.assert_allclose(np.linalg.norm(d, axis=-1), 1, atol=1e-12)
        np.testing.assert_allclose(d.mean(axis=(0, 1)), 0, atol=1e-3)
        # The mean of the squares of coordinates over the sphere is a third.
        np.testing.assert_allclose((d**2).mean(axis=(0, 1)), 1 / 3, atol=1e-3)
        self.assertGreater(d[32, 32, 2], 0.99)  # the middle is up
        self.assertGreater(d[32, 40, 0], 0)
        self.assertGreater(d[40, 32, 1], 0)

    def test_equirectangular(self):
        uv = equirectangular(np.array([[1.0, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1]]))
        np.testing.assert_allclose(uv[:3], [[0.5, 0.5], [0.25, 0.5], [0.75, 0.5]])
        self.assertAlmostEqual(uv[3, 1], 1)

    def test_lookup(self):
        values = np.zeros((2, 4, 4), dtype=np.float32)
        values[:, :, 0] = [[0, 1, 2, 3], [0, 1, 2, 3]]
        pixels = Pixels(values, False)
        at = np.array([[0.375, 0.5], [0.5, 0.5], [0.0, 0.5], [-0.125, 0.5], [1.25, 0.5]])
        np.testing.assert_allclose(pixels.lookup(at, "REPEAT", "Linear")[:, 0], [1, 1.5, 1.5, 3, 0.5])
        np.testing.assert_allclose(pixels.lookup(at, "EXTEND", "Linear")[:, 0], [1, 1.5, 0, 0, 3])
        np.testing.assert_allclose(pixels.lookup(at, "CLIP", "Closest")[:, 0], [1, 2, 0, 0, 0])

    def test_srgb(self):
        np.testing.assert_allclose(srgb_to_linear([0, 0.04045, 0.5, 1]), [0, 0.0031308, 0.2140411, 1], rtol=1e-4)

    def test_blackbody(self):
        white, warm = blackbody(6500), blackbody(2000)
        np.testing.assert_allclose(white, (1, 1, 1), atol=0.08)
        self.assertTrue(warm[0] > warm[1] > warm[2])
        self.assertAlmostEqual(np.dot(warm, (0.2126, 0.7152, 0.0722)), 1)

    def test_texels_of_an_atlas_are_where_the_mesh_shows_them(self):
        atlas = Atlas(7, 256)
        owner, weights = atlas.texels()
        corners = atlas.corners()
        y, x = np.divmod(np.arange(atlas.size**2), atlas.size)
        inside = (owner >= 0) & (weights > 0).all(axis=1)
        self.assertEqual(set(owner[inside]), set(range(7)))
        np.testing.assert_allclose(weights.sum(axis=1), 1, atol=1e-5)
        at = np.einsum("nk,nkc->nc", weights[inside], corners[owner[inside]])
        np.testing.assert_allclose(at, np.stack([x, y], axis=1)[inside] + 0.5, atol=1e-3)

    def test_passes(self):
        values = np.arange(2 * 3 * 4, dtype=np.float32).reshape(2, 3, 4)
        picture = Picture(["R", "G", "B", "depth.Z"], np.moveaxis(values, -1, 0))
        np.testing.assert_array_equal(pass_values(picture, "Depth", (1, 3, 0, 2)), [19, 23, 7, 11])
        np.testing.assert_array_equal(pass_values(picture, "Combined", (0, 1, 1, 2)), [12, 13, 14, 1])
        self.assertIsNone(pass_values(picture, "Direct", (0, 1, 0, 1)))


def packet(kind, payload):
    return struct.pack("<Ib", len(payload) + 5, kind) + payload


def create(width, height, *channels):
    names = b"".join(c.encode() + b"\0" for c in channels)
    return packet(4, b"\0image\0" + struct.pack("<3i", width, height, len(channels)) + names)


def update(channels, x, y, width, height, values):
    count = len(channels)
    names = b"".join(c.encode() + b"\0" for c in channels)
    return packet(
        6,
        b"\0image\0"
        + struct.pack("<i", count)
        + names
        + struct.pack("<4i", x, y, width, height)
        + struct.pack(f"<{count}q", *range(count))
        + struct.pack(f"<{count}q", *[count] * count)
        + np.asarray(values, "<f4").tobytes(),
    )


class Receiver(unittest.TestCase):
    def setUp(self):
        self.receiver = TevReceiver()
        self.addCleanup(self.receiver.close)

    def send(self, *pieces):
        with socket.socket(socket.AF_UNIX) as connection:
            connection.connect(self.receiver.address.removeprefix("unix:"))
            for piece in pieces:
                connection.sendall(piece)

    def wait_for_picture(self):
        found = []
        wait_for(lambda: found.append(self.receiver.changed()) or found[-1] is not None)
        return found[-1]

    def test_tiles(self):
        data = create(4, 2, "R", "G") + update(["R", "G"], 1, 0, 2, 2, range(8)) + update(["G"], 3, 1, 1, 1, [9])
        self.send(data[:7], data[7:50], data[50:])
        self.receiver.drain(PATIENCE)
        picture = self.wait_for_picture()
        self.assertEqual(picture.channels, ["R", "G"])
        np.testing.assert_array_equal(picture.planes[0], [[0, 0, 2, 0], [0, 4, 6, 0]])
        np.testing.assert_array_equal(picture.planes[1], [[0, 1, 3, 0], [0, 5, 7, 9]])
        self.assertIsNone(self.receiver.changed())

    def test_nobody_else_can_connect(self):
        folder = os.path.dirname(self.receiver.address.removeprefix("unix:"))
        self.assertEqual(os.stat(folder).st_mode & 0o077, 0)
        self.receiver.close()
        self.assertFalse(os.path.exists(folder))

    def test_nonsense_ends_a_connection_and_no_more(self):
        bad = [
            b"\xff\xff\xff\xff",
            struct.pack("<I", 3),
            create(0, 2, "R"),
            create(1 << 20, 1 << 20, "R"),
            packet(6, b"\0im"),
            create(2, 2, "R") + update(["R"], 1, 1, 2, 1, [0, 0]),
            create(2, 2, "R") + update(["X"], 0, 0, 1, 1, [0]),
            create(2, 2, "R") + update(["R"], 0, 0, 2, 2, [0]),
        ]
        for data in bad:
            with self.subTest(data[:40]):
                self.receiver.error = None
                self.send(data)
                wait_for(lambda: self.receiver.error)
        self.send(create(1, 1, "R") + update(["R"], 0, 0, 1, 1, [5]))
        self.assertEqual(self.wait_for_picture().planes[0, 0, 0], 5)


class Programs(unittest.TestCase):
    def test_missing_program(self):
        with self.assertRaisesRegex(UserError, "there is no program /nowhere/drc: choose"):
            find_program("/nowhere/drc")
        with self.assertRaisesRegex(UserError, "cannot start /nowhere/drc: there is no such program"):
            Child(["/nowhere/drc"])

    def test_failures(self):
        def ended(code):
            child = Child([sys.executable, "-c", code])
            child.finish()
            return child.failure()

        self.assertEqual(ended("import sys; print('drc: error: no\\n    more', file=sys.stderr); sys.exit(1)"), "no")
        self.assertIn("ended from outside (SIGKILL)", ended("import os; os.kill(os.getpid(), 9)"))
        self.assertIn("crashed (SIGSEGV)", ended("import os; os.kill(os.getpid(), 11)"))
        self.assertIn("status 3", ended("import os; os._exit(3)"))

    def test_stop(self):
        child = Child([sys.executable, "-c", "import time; time.sleep(100)"])
        time.sleep(0.2)
        child.stop()
        self.assertFalse(child.running())
        stubborn = Child(
            [
                sys.executable,
                "-c",
                "import signal, time; signal.signal(signal.SIGINT, signal.SIG_IGN); print(1, flush=True); time.sleep(100)",
            ],
            True,
        )
        wait_for(lambda: stubborn.output)
        began = time.monotonic()
        stubborn.stop(grace=0.3)
        self.assertFalse(stubborn.running())
        self.assertLess(time.monotonic() - began, 10)

    @unittest.skipUnless(ends_with_us(), "no setpriv")
    def test_it_ends_when_its_parent_is_killed(self):
        code = (
            "import sys, time; from drc_blender.program import Child;"
            "child = Child([sys.executable, '-c', 'import time; time.sleep(100)']);"
            "print(child.process.pid, flush=True); time.sleep(100)"
        )
        parent = subprocess.Popen(
            [sys.executable, "-c", code],
            env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
            stdout=subprocess.PIPE,
            text=True,
        )
        self.addCleanup(parent.stdout.close)
        child = int(parent.stdout.readline())
        wait_for(lambda: b"setpriv" not in command_line(child))  # so the kernel knows of the wish
        self.assertTrue(runs(child))
        parent.kill()
        parent.wait()
        wait_for(lambda: not runs(child))

    def test_commands(self):
        class Drc:
            stop, time, noise, most_time, samples, cells, denoise, max_bounces, seed = (
                "NOISE",
                1,
                0.05,
                9,
                4,
                False,
                False,
                8,
                3,
            )

        command = render_command("drc", "s.pbrt", "o.exr", Drc, "unix:here", 2)
        for words in (
            ["--noise-threshold", "0.05", "--time", "9"],
            ["--cells", "off"],
            ["--denoise", "off"],
            ["--nthreads", "2"],
            ["--display-server", "unix:here"],
        ):
            self.assertIn(" ".join(words), " ".join(command))
        self.assertEqual(
            view_command("drc", "s.pbrt", 32, 16, Drc, 0, True),
            ["drc", "view", "s.pbrt", "--resolution", "32x16", "--integrator", "path", "--open"],
        )


class WithTheProgram(unittest.TestCase):
    def setUp(self):
        if DRC is None:
            self.skipTest("no --drc")

    def test_the_number_of_a_frame_is_known_by_its_file(self):
        with tempfile.TemporaryDirectory() as folder:
            for frame, number in ((7, "7"), (12345, "12345"), (0, "0"), (-3, "3")):
                scene = os.path.join(folder, scene_file_name(frame))
                output = os.path.join(folder, "o.exr")
                shutil.copy(CORNELL, scene)
                options = ["--spp", "1", "--resolution", "8x8", "--quiet", "--denoise", "off"]
                subprocess.run([DRC, "render", scene, "-o", output, *options], check=True)
                told = json.loads(subprocess.run([DRC, "image", "info", "--json", output], capture_output=True).stdout)
                self.assertEqual(told[0]["metadata"]["drc:frame"], number)

    def test_a_render_is_received(self):
        receiver = TevReceiver()
        self.addCleanup(receiver.close)
        with tempfile.TemporaryDirectory() as folder:
            output = os.path.join(folder, "o.exr")
            child = Child(
                [
                    DRC,
                    "render",
                    CORNELL,
                    "-o",
                    output,
                    "--aovs",
                    "--spp",
                    "4",
                    "--resolution",
                    "64x48",
                    "--quiet",
                    "--display-server",
                    receiver.address,
                ]
            )
            self.assertEqual(child.finish(), 0, child.lines)
            receiver.drain(PATIENCE)
            picture = receiver.last()
            self.assertEqual(picture.planes.shape[1:], (48, 64))
            self.assertTrue(
                {"R", "albedo.R", "normal.X", "depth.Z", "variance.R", "samples.X"} <= set(picture.channels),
                picture.channels,
            )
            self.assertGreater(np.mean(picture.layer("R", "G", "B")), 0.01)
            self.assertAlmostEqual(float(picture.layer("samples.X")[0].mean()), 4, delta=0.5)

    def test_view(self):
        class Drc:
            cells = True

        client = ViewClient(view_command(DRC, CORNELL, 64, 64, Drc))
        self.addCleanup(client.close)
        wait_for(lambda: client.has_news())
        self.assertIsNone(client.error)
        first = client.frame().astype(np.float32)
        self.assertEqual(first.shape, (64, 64, 3))
        # The camera turned to the light's surroundings, from where the scene's own is.
        state = view_of(
            np.linalg.inv(np.diag([1.0, 1, 1, 1])), np.diag([1.0, 1, 1, 0]) - np.eye(4)[[0, 1, 3, 2]] * [0, 0, 1, 1]
        )
        client.move(state, 48, 32, True)

        def moved():
            frame = client.frame() if client.has_news() and not client.error else None
            return client.error or (frame is not None and frame.shape == (32, 48, 3))

        wait_for(moved)
        self.assertIsNone(client.error)
        # While something is rendered, it rests; a part gets the samples that the rest of the picture would.
        resting.set()
        self.addCleanup(resting.clear)
        wait_for(lambda: client._rests)
        client.move(state, 48, 32, True, (0.25, 0.5, 0.25, 0.5))
        wait_for(lambda: client._sent[-1] is not None)
        resting.clear()
        wait_for(lambda: not client._rests)
        wait_for(lambda: client.error or re.fullmatch("[0-9]+ samples? a pixel", client.progress))
        self.assertIsNone(client.error)
        # Another lens is another picture by the same renderer, here the upper left quarter of the one before.
        left, right, bottom, top = state.window
        quarter = replace(state, window=(left, (left + right) / 2, (bottom + top) / 2, top))
        whole, part = self.shown(client, state, 48, 32), self.shown(client, quarter, 24, 16)
        apart = [abs(part - other).mean() / whole.mean() for other in (whole[:16, :24], whole[::2, ::2])]
        self.assertLess(apart[0], 0.1)
        self.assertGreater(apart[1], 0.2)

    def shown(self, client, view, width, height):
        """The frame of this view after a hundred samples."""
        frames = []

        def settled():
            if client.has_news() and not client.error:
                frames.append(client.frame())
            size = frames[-1].shape[:2] if frames else None
            return client.error or (size == (height, width) and re.match("[0-9]{3} samples", client.progress))

        client.move(view, width, height, False)
        wait_for(settled)
        self.assertIsNone(client.error)
        return frames[-1].astype(np.float32)

    def test_view_of_a_broken_scene(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = os.path.join(folder, "bad.pbrt")
            with open(scene, "w") as f:
                f.write('WorldBegin\nShape "sphere" "float radius" [-1]\n')

            class Drc:
                cells = True

            client = ViewClient(view_command(DRC, scene, 64, 64, Drc))
            wait_for(lambda: client.error)
            self.assertIn("must be positive", client.error)
            client.close()

    def test_view_that_is_killed(self):
        class Drc:
            cells = False

        client = ViewClient(view_command(DRC, CORNELL, 64, 64, Drc))
        wait_for(lambda: client.has_news())
        client.child.process.kill()
        wait_for(lambda: client.error)
        self.assertIn("SIGKILL", client.error)
        client.close()


class DyingRenderers(unittest.TestCase):
    def test_a_connection_that_breaks_before_the_renderer_ends(self):
        """The message is that of the renderer's end, and no process is left."""
        dies = """
import os, socket, time
server = socket.create_server(("127.0.0.1", 0))
print(f"http://127.0.0.1:{server.getsockname()[1]}/", flush=True)
server.accept()[0].close()
server.close()
time.sleep(0.3)
os.kill(os.getpid(), 9)
"""
        client = ViewClient([sys.executable, "-c", dies])
        wait_for(lambda: client.error)
        self.assertEqual(client.error, "the renderer was ended from outside (SIGKILL)")
        self.assertFalse(os.path.exists(f"/proc/{client.child.process.pid}"))
        client.close()


def photometric(around, rows, down="0 45 90", tilt="TILT=NONE", kind=1):
    counts = f"{len(down.split())} {len(around.split())}"
    return "\n".join(["IESNA:LM-63-1995", "[TEST] x", tilt, f"1 1000 2 {counts} {kind} 1 0 0 0", "1 1 50", down, around, *rows])


class LightProfiles(unittest.TestCase):
    def candelas(self, text, down, about):
        """At an angle from the nadir and one about the axis, degrees."""
        d, a = np.radians(down), np.radians(about - 180)
        direction = np.array([[np.sin(d) * np.sin(a), np.sin(d) * np.cos(a), -np.cos(d)]])
        return float(LightProfile.parse(text).candelas_at(direction)[0, 0])

    def test_the_same_all_around(self):
        text = photometric("0", ["100 50 10"])
        for about in (1, 100, 359):
            for down, candelas in ((0, 200), (45, 100), (90, 20)):
                self.assertAlmostEqual(self.candelas(text, down, about), candelas, places=3)
        self.assertTrue(100 < self.candelas(text, 20, 5) < 200)
        self.assertEqual(self.candelas(text, 91, 5), 0)

    def test_symmetries(self):
        quarter = photometric("0 45 90", ["100 50 10", "200 60 20", "300 70 30"])
        for about, candelas in ((0, 100), (45, 120), (90, 140), (135, 120), (180, 100), (270, 140), (315, 120)):
            self.assertAlmostEqual(self.candelas(quarter, 45, about), candelas, places=2)
        half = photometric("0 90 180", ["100 50 10", "200 60 20", "300 70 30"])
        for about, candelas in ((0, 100), (90, 120), (180, 140), (270, 120)):
            self.assertAlmostEqual(self.candelas(half, 45, about), candelas, places=2)
        whole = photometric("0 90 180 270 360", [f"100 {50 + 10 * i} 10" for i in (0, 1, 2, 3, 0)])
        for about, candelas in ((0, 100), (90, 120), (180, 140), (270, 160)):
            self.assertAlmostEqual(self.candelas(whole, 45, about), candelas, places=2)

    def test_constants_stay_constant(self):
        text = photometric("0 90 180 270 360", ["7 7 7"] * 5, down="0 30 180")
        for down, about in ((3, 1), (70, 200), (179, 359)):
            self.assertAlmostEqual(self.candelas(text, down, about), 14, places=4)

    def test_tilt_is_passed_over(self):
        text = photometric("0", ["100 50 10"], tilt="TILT=INCLUDE\n1\n2\n0 90\n1 0.9")
        self.assertAlmostEqual(self.candelas(text, 45, 0), 100, places=3)

    def test_files_that_are_broken(self):
        good = photometric("0", ["100 50 10"])
        for text, what in (
            ("", "no line TILT="),
            (photometric("0", ["1 1 1"], tilt="TILT=other.til"), "OTHER.TIL"),
            (good.rsplit(" ", 1)[0], "numbers are not"),
            (good.replace("100", "x"), "numbers are not"),
            (good.replace("100 ", "nan "), "numbers that are none"),
            (good.replace("2 3 1 ", "2 inf 1 "), "numbers are not"),
            (photometric("0", ["1 1 1"], kind=2), "not of type C"),
            (photometric("0", ["1 1 1"], down="0 90 45"), "do not rise"),
            (photometric("0 50", ["1 1 1"] * 2), "end at 50 degrees"),
        ):
            with self.assertRaisesRegex(ValueError, what):
                LightProfile.parse(text)


class Frames(unittest.TestCase):
    def test_progress(self):
        self.assertEqual(progress_of({"samples": 0, "share": 0.25}), "25% of the pixels")
        self.assertEqual(progress_of({"samples": 1, "share": 1}), "1 sample a pixel")

    def test_frames(self):
        values = np.arange(6, dtype="<f2")
        number_, frame = frame_of(struct.pack("<4I", 2, 1, 3, 7) + values.tobytes())
        self.assertEqual((number_, frame.shape), (7, (1, 2, 3)))
        for data in (b"", struct.pack("<4I", 2, 1, 3, 7)):
            with self.assertRaises(ValueError):
                frame_of(data)

    def test_origin(self):
        self.assertEqual(
            origin_of({"eye": [1, 2, 3], "pbrt": "Scale -1 1 1\nLookAt 101 2 3  0 0 0  0 0 1\n"}), (100, 0, 0)
        )


if __name__ == "__main__":
    if "--drc" in sys.argv:
        at = sys.argv.index("--drc")
        DRC = os.path.abspath(sys.argv[at + 1])
        del sys.argv[at : at + 2]
    unittest.main()
