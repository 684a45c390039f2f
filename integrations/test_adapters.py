#!/usr/bin/env python3
"""Tests of what the adapters share: what they make of scenes, what they refuse, and the adapter files themselves.

    integrations/test_adapters.py [build/release/drc] [unittest's arguments]

Standard library only: the renderers need not be there. pbrt is a stand-in that keeps what it was given.
"""
import glob
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
sys.dont_write_bytecode = True

import budget  # noqa: E402
import pbrt_geometry as geometry  # noqa: E402
from drc_export import Refused, find_drc  # noqa: E402
from pbrt_scene import ImageTexture  # noqa: E402
from pbrt_subset import alpha_of, read_scene  # noqa: E402
from ply_file import read_ply, write_ply  # noqa: E402

TRIANGLE = 'Shape "trianglemesh" "integer indices" [ 0 1 2 ] "point P" [ 0 0 0  1 0 0  0 1 0 ]'


# A PNG of one grey pixel.
PNG = bytes.fromhex("89504e470d0a1a0a0000000d49484452000000010000000108000000003a7e9b550000000a4944415478da6368"
                    "000000820081da45083b0000000049454e44ae426082")


class InFolder(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = kept.name
        os.mkdir(os.path.join(self.folder, "exported"))

    def file(self, name, content):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as f:
            f.write(content if isinstance(content, bytes) else content.encode())
        return path

    def scene(self, text):
        """Of a file that begins like this: the world and its end are added."""
        text += ("" if "WorldBegin" in text else "\nWorldBegin") + "\nWorldEnd\n"
        return read_scene(self.file("scene.pbrt", text), os.path.join(self.folder, "exported"))

    def near(self, values, expected, places=6):
        values, expected = list(values), list(expected)
        self.assertEqual(len(values), len(expected))
        for value, wanted in zip(values, expected):
            self.assertAlmostEqual(value, wanted, places=places)

    def refused(self, text, line, words):
        with self.assertRaises(Refused) as caught:
            for shape in self.scene(text).shapes:
                shape.mesh()
        message = str(caught.exception)
        place = re.escape(os.path.join(self.folder, f"scene.pbrt:{line}:"))
        self.assertRegex(message, rf"^{place}\d+: ")
        self.assertIn(words, message)
        self.assertNotIn("\n", message)


class Transforms(InFolder):
    def test_meshes_and_round_shapes_are_placed_alike(self):
        place = "WorldBegin\nTranslate 1 2 3 Rotate 90 0 0 1 Scale 2 3 4\n"
        mesh, disk = self.scene(f'{place}{TRIANGLE} Shape "disk" "float height" .5').shapes
        self.near(mesh.mesh().positions[3:6], (1, 4, 3))
        self.near(disk.mesh().positions[:3], (1, 2, 5))

    def test_inverse(self):
        m = ((0, -2, 0.5, 4), (1, 0, 0.25, 5), (0, 0, -3, 6), (0, 0, 0, 1.0))
        for row, wanted in zip(geometry.multiply(m, geometry.inverse(m)), geometry.IDENTITY):
            self.near(row, wanted)


class Cameras(InFolder):
    def test_plain_look_at_shows_a_mirror_image_of_what_a_right_handed_camera_sees(self):
        camera = self.scene('LookAt 0 0 5  0 0 0  0 1 0\nCamera "perspective" "float fov" 40\n').camera
        self.near(camera.position, (0, 0, 5))
        self.near(camera.z, (0, 0, -1))
        self.near(camera.y, (0, 1, 0))
        self.near(camera.x, (1, 0, 0))
        self.assertTrue(camera.mirrored)
        self.assertEqual(camera.fov, 40)

    def test_mirrored_once_more_is_plain(self):
        camera = self.scene('Scale -1 1 1 LookAt 0 0 5  0 0 0  0 1 0\nCamera "perspective"\n').camera
        self.near(camera.x, (1, 0, 0))
        self.near(camera.z, (0, 0, -1))
        self.assertFalse(camera.mirrored)
        self.assertEqual(camera.fov, 90)

    def test_axes_are_of_unit_length_whatever_the_scale(self):
        camera = self.scene('Scale 4 4 4\nCamera "perspective"\n').camera
        self.near(camera.z, (0, 0, 1))
        self.refused('\nScale 4 1 1\nCamera "perspective"', 3, "unevenly")

    def test_refusals(self):
        self.refused('\n\nCamera "orthographic"', 3, "orthographic")
        self.refused('Camera "perspective"\n  "float lensradius" 0.1', 2, "lens")
        self.refused('Camera "perspective"\n"float fov" 40\n"float screenwindow" [-1 1 -1 1]', 3, "screenwindow")
        self.refused('Film "image" "integer xresolution" 3\n"float cropwindow" [0 .5 0 1]', 2, "cropwindow")


class Meshes(InFolder):
    def normal(self, text):
        """Which way the winding of the only triangle points."""
        mesh = self.scene("WorldBegin\n" + text).shapes[0].mesh()
        a, b, c = (mesh.positions[3 * i:3 * i + 3] for i in mesh.indices)
        return geometry.normalize(geometry.cross(geometry.subtract(b, a), geometry.subtract(c, a)))

    def test_winding_is_on_pbrts_side(self):
        self.near(self.normal(TRIANGLE), (0, 0, 1))
        self.near(self.normal("ReverseOrientation " + TRIANGLE), (0, 0, -1))
        # What mirrors turns the winding about, and pbrt turns it back.
        self.near(self.normal("Scale 1 1 -1 " + TRIANGLE), (0, 0, -1))
        self.near(self.normal("Scale -1 1 1 " + TRIANGLE), (0, 0, 1))
        self.near(self.normal("Scale -1 1 1 ReverseOrientation " + TRIANGLE), (0, 0, -1))
        self.near(self.normal(TRIANGLE + ' "normal N" [0 0 -1 0 0 -1 0 0 -1]'), (0, 0, -1))

    def test_sides_of_lights_that_pbrt_leaves_open(self):
        light = 'WorldBegin\nAreaLightSource "diffuse"\nReverseOrientation\n'
        self.refused(light + TRIANGLE + '\n"normal N" [0 0 1 0 0 1 0 0 1]', 4, "outer")
        self.refused('WorldBegin\nScale 1 1 -1\nAreaLightSource "diffuse"\nShape "sphere"', 4, "outer")
        self.assertEqual(len(self.scene(light + TRIANGLE).shapes[0].mesh().indices), 3)

    def test_normals_go_by_the_inverse_transpose(self):
        mesh = self.scene('WorldBegin Scale 1 2 1 ' + TRIANGLE + ' "normal N" [0 1 1 0 1 1 0 1 1]').shapes[0].mesh()
        self.near(mesh.normals[:3], geometry.normalize((0, 0.5, 1)))
        self.assertFalse(mesh.normals_follow_faces())

    def test_uvs_that_the_file_leaves_out(self):
        picture = self.file("a.png", PNG)
        scene = self.scene('WorldBegin Texture "t" "spectrum" "imagemap" "string filename" "a.png" '
                           '"float uscale" 2 Material "matte" "texture Kd" "t" ' + TRIANGLE)
        texture = scene.shapes[0].material.Kd
        self.assertIsInstance(texture, ImageTexture)
        self.assertEqual((texture.path, texture.srgb, texture.wrap), (picture, True, "repeat"))
        self.assertEqual(texture.uv_scale, (2, 1))
        self.near(scene.shapes[0].mesh().uvs, (0, 0, 1, 0, 1, 1))

    def test_uvs_of_triangles_that_are_turned_about(self):
        self.file("a.png", PNG)
        square = TRIANGLE.replace("0 0 0  1 0 0  0 1 0", "0 0 0  1 0 0  1 1 0")
        mesh = self.scene('WorldBegin Texture "t" "spectrum" "imagemap" "string filename" "a.png" '
                          f'Material "matte" "texture Kd" "t" ReverseOrientation {square}').shapes[0].mesh()
        at = {tuple(mesh.positions[3 * i:3 * i + 2]): tuple(mesh.uvs[2 * i:2 * i + 2]) for i in mesh.indices}
        self.assertEqual(at, {(0, 0): (0, 0), (1, 0): (1, 0), (1, 1): (1, 1)})

    def test_ply_files(self):
        head = ("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                "property float s\nproperty float t\nelement face 1\nproperty list uchar int vertex_indices\n"
                "end_header\n")
        self.file("a.ply", head + "0 0 0 0 0\n1 0 0 1 0\n1 1 .5 1 1\n0 1 0 0 1\n4 0 1 2 3\n")
        world = 'WorldBegin\nShape "plymesh" "string filename" "a.ply"'
        mesh = self.scene(world).shapes[0].mesh()
        self.assertEqual(list(mesh.indices), [0, 1, 2, 3, 0, 2])  # as pbrt divides it
        self.near(mesh.positions, (0, 0, 0, 1, 0, 0, 1, 1, 0.5, 0, 1, 0))
        self.near(mesh.uvs, (0, 0, 1, 0, 1, 1, 0, 1))
        self.assertIsNone(mesh.normals)
        self.file("a.ply", head + "0 0 0 9 0")
        self.refused(world, 2, "cut short")
        self.file("a.ply", head + "0 0 0 0 0\n" * 4 + "3 0 1 4\n")
        self.refused(world, 2, "a.ply")

    def test_ply_goes_round(self):
        sphere = geometry.sphere_mesh(2.0, 8, 4)
        path = os.path.join(self.folder, "s.ply")
        write_ply(sphere, path)
        again = read_ply(path)
        self.assertEqual(list(again.indices), list(sphere.indices))
        self.near(again.positions, sphere.positions)
        self.near(again.normals, sphere.normals)
        self.near(again.uvs, sphere.uvs)

    def test_round_shapes(self):
        sphere = geometry.sphere_mesh(2.0)
        self.assertAlmostEqual(geometry.area(sphere), 16 * math.pi, places=4)
        self.assertTrue(all(abs(geometry.length(sphere.positions[i:i + 3]) - 2) < 1e-3
                            for i in range(0, len(sphere.positions), 3)))
        self.assertEqual(list(sphere.oriented(False).indices), list(sphere.indices))  # wound outwards as it is
        disk = geometry.disk_mesh(3.0, 1.0)
        self.assertAlmostEqual(geometry.area(disk), 9 * math.pi, places=4)
        self.assertEqual(set(disk.positions[2::3]), {1.0})
        for i in range(0, len(disk.indices), 3):
            a, b, c = (disk.positions[3 * k:3 * k + 3] for k in disk.indices[i:i + 3])
            self.assertGreater(geometry.cross(geometry.subtract(b, a), geometry.subtract(c, a))[2], 0)


class Materials(InFolder):
    def material(self, text):
        return self.scene(f"WorldBegin {text} {TRIANGLE}").shapes[0].material

    def test_usual_values(self):
        self.assertEqual(self.material("").Kd, (0.5, 0.5, 0.5))
        self.assertEqual(self.material('Material "mirror"').Kr, (0.9, 0.9, 0.9))
        glass = self.material('Material "glass" "rgb Kt" [.1 .2 .3]')
        self.assertEqual((glass.Kr, glass.Kt, glass.eta), ((1, 1, 1), (0.1, 0.2, 0.3), 1.5))
        self.assertEqual(self.material('Material "glass" "float index" 1.7').eta, 1.7)

    def test_named_and_shared(self):
        scene = self.scene('WorldBegin MakeNamedMaterial "a" "string type" "matte" "rgb Kd" [1 0 0]\n'
                           f'NamedMaterial "a" {TRIANGLE} {TRIANGLE} AttributeBegin Material "mirror" {TRIANGLE} '
                           f'AttributeEnd {TRIANGLE}')
        a, b, c, d = (shape.material for shape in scene.shapes)
        self.assertIs(a, b)
        self.assertIs(a, d)
        self.assertEqual((a.Kd, c.kind), ((1, 0, 0), "mirror"))

    def test_constant_texture(self):
        texture = 'Texture "t" "color" "constant" "rgb value" [.1 .2 .3] '
        self.assertEqual(self.material(texture + 'Material "matte" "texture Kd" "t"').Kd, (0.1, 0.2, 0.3))

    def test_uber_without_gloss_is_matte(self):
        uber = self.material('Material "uber" "rgb Ks" [0 0 0] "float roughness" .3')
        self.assertEqual((uber.kind, uber.Kd), ("matte", (0.25, 0.25, 0.25)))

    def test_roughness(self):
        metal = self.material('Material "metal" "rgb eta" [1 1 1] "rgb k" [2 2 2] "float uroughness" .25 '
                              '"float vroughness" .25 "bool remaproughness" "false"')
        self.assertEqual(metal.alpha, 0.25)
        self.assertAlmostEqual(alpha_of(1.0, True), 1.62142)
        self.assertEqual(alpha_of(0.0, False), 1e-3)

    def test_what_no_shape_uses_is_not_refused(self):
        scene = self.scene(f'WorldBegin MakeNamedMaterial "x" "string type" "hair" {TRIANGLE}')
        self.assertEqual(len(scene.shapes), 1)

    def test_refusals_name_the_line_that_is_not_matched(self):
        self.refused(f'WorldBegin\nMaterial "plastic"\n{TRIANGLE}', 2, "plastic")
        self.refused('WorldBegin MakeNamedMaterial "x" "string type" "glass"\n  "float uroughness" .1\n'
                     f'NamedMaterial "x"\n{TRIANGLE}', 2, "rough glass")
        self.refused(f'WorldBegin\nMaterial "matte" # round\n"float sigma" 20\n{TRIANGLE}', 3, "sigma")
        self.refused(f'WorldBegin\nMaterial "matte"\n\n"texture bumpmap" "b"\n{TRIANGLE}', 4, "bumpmap")
        self.refused(f'WorldBegin\nMaterial "matte" "spectrum Kd" "x.spd"\n{TRIANGLE}', 2, "x.spd")
        self.refused(f'WorldBegin\nMaterial "matte" "spectrum Kd" [ 400 .5 700 .6 ]\n{TRIANGLE}', 2, "spectrum Kd")
        self.refused(f'WorldBegin\nTexture "t" "spectrum" "dots"\nMaterial "matte" "texture Kd" "t"\n{TRIANGLE}', 2,
                     "dots")
        self.refused(f'WorldBegin\nMaterial "matte"\n"texture Kd" "none"\n{TRIANGLE}', 3, "none")
        self.refused(f'WorldBegin\nNamedMaterial "none"\n{TRIANGLE}', 2, "none")
        self.refused(f'WorldBegin\nMaterial "metal"\n{TRIANGLE}', 2, "rgb eta")
        self.refused(f'WorldBegin\nMaterial "uber"\n{TRIANGLE}', 2, "Ks")
        self.refused(f'WorldBegin\n{TRIANGLE}\n"texture alpha" "a"', 3, "alpha")


class Lights(InFolder):
    def test_area(self):
        scene = self.scene('WorldBegin AttributeBegin AreaLightSource "diffuse" "rgb L" [1 2 3] "rgb scale" [2 2 2] '
                           f'"integer nsamples" 4 {TRIANGLE} AttributeEnd {TRIANGLE}')
        lit, plain = scene.shapes
        self.assertEqual((lit.radiance, lit.two_sided, plain.radiance), ((2, 4, 6), False, None))
        scene = self.scene(f'WorldBegin AreaLightSource "area" "bool twosided" "true" {TRIANGLE}')
        self.assertEqual((scene.shapes[0].radiance, scene.shapes[0].two_sided), ((1, 1, 1), True))

    def test_others_are_placed_by_the_transformation(self):
        scene = self.scene('WorldBegin Translate 1 0 0 Rotate 90 0 0 1 LightSource "point" "rgb I" [4 5 6] '
                           '"point from" [1 0 0] LightSource "distant" "point from" [2 0 0] "point to" [0 0 0] '
                           'LightSource "infinite" "rgb L" [1 2 3] "rgb scale" [2 2 2]')
        point, distant, infinite = scene.lights
        self.near(point.position, (1, 1, 0))
        self.assertEqual(point.intensity, (4, 5, 6))
        self.near(distant.direction, (0, 1, 0))
        self.assertEqual((infinite.radiance, infinite.image), ((2, 4, 6), None))

    def test_refusals(self):
        self.refused('WorldBegin\nLightSource "spot"', 2, "spot")
        self.refused('WorldBegin\nLightSource "point"\n"blackbody I" [6500 1]', 3, "blackbody")
        self.refused('WorldBegin\nLightSource "infinite"\n"string mapname" "none.exr"', 3, "none.exr")


class Files(InFolder):
    def test_include_is_found_beside_its_file_then_beside_the_scene(self):
        self.file("sub/a.pbrt", 'Include "b.pbrt"\nInclude "c.pbrt"')
        self.file("sub/b.pbrt", TRIANGLE)
        self.file("c.pbrt", "Translate 1 1 1\n" + TRIANGLE)
        self.assertEqual(len(self.scene('WorldBegin\nInclude "sub/a.pbrt"').shapes), 2)

    def test_refusal_names_the_included_file(self):
        path = self.file("sub/a.pbrt", "\n\nShape \"curve\"")
        with self.assertRaises(Refused) as caught:
            self.scene('WorldBegin\nInclude "sub/a.pbrt"\nWorldEnd')
        self.assertTrue(str(caught.exception).startswith(path + ":3:7: "), caught.exception)

    def test_what_drc_refuses_and_what_it_warns_of(self):
        self.refused('WorldBegin\nShape "sphere', 2, "unterminated string")
        self.refused("WorldBegin\nTranslate 1 2", 3, "number 3 of the 3")
        self.refused("WorldBegin\n\nScale 0 1 1\n" + TRIANGLE, 3, "inverted")
        self.refused("WorldBegin\nFrobnicate 1", 2, "Frobnicate")
        self.refused('WorldBegin\nShape "trianglemesh" "integer indices" [0 1 7]\n"point P" [0 0 0]', 2, "indices")
        self.refused('Include "scene.pbrt"', 1, "includes itself")
        self.refused("WorldBegin\nAttributeEnd", 2, "AttributeEnd without AttributeBegin")
        self.refused('WorldBegin\nCoordSysTransform "here"', 2, "here")
        self.refused('Integrator "path" "integer maxdeph" 3', 1, "maxdeph")
        with self.assertRaisesRegex(Refused, "nowhere.pbrt"):
            read_scene(os.path.join(self.folder, "nowhere.pbrt"), self.folder)

    def test_what_is_nowhere_matched(self):
        self.refused('WorldBegin\nObjectBegin "o"\nShape "sphere"\nObjectEnd', 2, "instances")
        self.refused('\nMakeNamedMedium "m" "string type" "homogeneous"', 2, "medium")
        self.refused(f"WorldBegin\nActiveTransform EndTime Translate 1 0 0\n{TRIANGLE}", 3, "moves")
        self.refused('\nColorSpace "srgb"', 2, "pbrt-v4")
        self.refused('Film "rgb"\nWorldBegin', 1, "pbrt-v4")

    def test_which_drc(self):
        self.assertEqual(find_drc(sys.executable), sys.executable)
        with self.assertRaisesRegex(Refused, "--drc /no/drc: is no program"):
            find_drc("/no/drc")
        with self.assertRaisesRegex(Refused, "export ended with status 1"):
            read_scene(self.file("a.pbrt", "WorldBegin WorldEnd"), self.folder, shutil.which("false"))


KEYS = {"name", "about", "check", "install", "denoisers", "command"}
PLACEHOLDERS = {"folder", "scene", "output", "width", "height", "seed", "threads", "seconds", "spp", "denoiser",
                "timing", "drc"}


class AdapterFiles(unittest.TestCase):
    def test_each(self):
        paths = sorted(glob.glob(os.path.join(HERE, "*", "*.json")))
        self.assertGreaterEqual(len(paths), 5)
        names = []
        for path in paths:
            with self.subTest(path), open(path, encoding="utf-8") as f:
                adapter = json.load(f)
                self.assertEqual(set(adapter), KEYS)
                names.append(adapter["name"])
                self.assertRegex(adapter["name"], r"^[a-z0-9-]+$")
                for key in ("about", "install"):
                    self.assertTrue(adapter[key] and "\n" not in adapter[key])
                self.assertTrue(all(isinstance(word, str) for word in adapter["check"]))
                self.assertTrue(set(adapter["command"]) and set(adapter["command"]) <= {"seconds", "spp"})
                for budget_kind, argv in adapter["command"].items():
                    self.check_command(path, adapter, budget_kind, argv)
        self.assertEqual(len(set(names)), len(names))

    def check_command(self, path, adapter, budget_kind, argv):
        bare = [word.replace("{{", "").replace("}}", "") for word in argv]
        used = {name for word in bare for name in re.findall(r"{([^}]*)}", word)}
        self.assertLessEqual(used, PLACEHOLDERS)
        self.assertLessEqual({"scene", "output", "width", "height", "drc", budget_kind}, used)
        self.assertEqual("denoiser" in used, bool(adapter["denoisers"]))
        self.assertFalse({"seconds", "spp"} - {budget_kind} & used)  # one budget, not both
        for word in argv:
            if word.startswith("{folder}/"):
                self.assertTrue(os.path.isfile(os.path.join(os.path.dirname(path), word[len("{folder}/"):])), word)


# Takes pbrt's arguments and does what FAKE says: writes the scene as the picture, and says how long it took.
FAKE_PBRT = """#!/bin/sh
echo "$@" >> "$FAKE_FOLDER/calls"
upgrade=no
while [ $# -gt 0 ]; do
    case "$1" in
        --upgrade) upgrade=yes ;;
        --outfile) shift; out=$1 ;;
        --nthreads|--spp|--seed) shift ;;
        --*) echo "unknown $1" >&2; exit 1 ;;
        *) scene=$1 ;;
    esac
    shift
done
case "$FAKE" in
    error) echo "scene.pbrt:3:1: Error: Couldn't open mesh" >&2 ;;
    fails) echo "out of memory" >&2; exit 3 ;;
    nothing) exit 0 ;;
esac
if [ $upgrade = yes ]; then echo "# upgraded"; cat "$scene"; exit 0; fi
cp "$scene" "$out"
echo "Rendering: [+++++]  (12.5s)"
"""


class Pbrt(InFolder):
    def setUp(self):
        super().setUp()
        self.program = self.file("bin/pbrt", FAKE_PBRT)
        os.chmod(self.program, 0o755)
        self.output = os.path.join(self.folder, "out.exr")
        self.mesh = self.file("scene/models/a.ply", b"ply")
        self.file("scene/parts/inner.pbrt", 'Shape "plymesh" "string filename" "models/a.ply"\n')
        self.path = self.file("scene/scene.pbrt", 'Integrator "bdpt" "integer maxdepth" 3 Sampler "sobol"\n'
                              '"integer pixelsamples" [ 4 ]\nFilm "image" "string filename" [ "x.png" ] '
                              '"integer xresolution" [ 10 ] "float scale" [ 2 ] # a comment\n'
                              'Camera "perspective" "float fov" [ 30 ]\nWorldBegin\n'
                              'Include "parts/inner.pbrt"\nMaterial "matte" "rgb Kd" [ 1 0 0 ]\n'
                              'Shape "sphere" "float radius" 2\nWorldEnd\n')

    def render(self, version=3, what="", scene=None, *more):
        timing = os.path.join(self.folder, "timing.json")
        done = subprocess.run(
            [sys.executable, os.path.join(HERE, f"pbrt-v{version}", "render.py"), "--scene", scene or self.path,
             "--output", self.output, "--width", "64", "--height", "48", "--seed", "7", "--threads", "2", "--timing",
             timing, "--spp", "20", *more],
            cwd=os.path.dirname(self.path),
            env=dict(os.environ, FAKE=what, FAKE_FOLDER=self.folder, PYTHONDONTWRITEBYTECODE="1",
                     **{f"PBRT_V{version}": self.program}),
            stderr=subprocess.PIPE, text=True, check=False)
        return done.returncode, done.stderr

    def picture(self):
        with open(self.output, encoding="utf-8") as f:
            return f.read()

    def calls(self):
        with open(os.path.join(self.folder, "calls"), encoding="utf-8") as f:
            return f.read().splitlines()

    def test_settings_are_replaced_and_the_rest_is_kept(self):
        self.assertEqual(self.render(), (0, ""))
        text = self.picture()
        self.assertEqual(re.findall(r"^(?:Integrator|Sampler|Film).*", text, re.MULTILINE), [
            'Film "image" "string filename" [ "x.png" ] "float scale" [ 2 ] "integer xresolution" [ 64 ] '
            '"integer yresolution" [ 48 ]',
            'Sampler "halton" "integer pixelsamples" [ 20 ]',
            'Integrator "path" "integer maxdepth" [ 100 ]'])
        self.assertLess(text.index("Integrator"), text.index("WorldBegin"))
        self.assertIn('Camera "perspective" "float fov" [ 30 ]\n', text)
        self.assertIn('Shape "sphere" "float radius" 2\n', text)
        self.assertIn(f'Shape "plymesh" "string filename" "{self.mesh}"\n', text)  # from the included file
        self.assertNotIn("Include", text)
        with open(os.path.join(self.folder, "timing.json"), encoding="utf-8") as f:
            self.assertEqual(json.load(f), {"render_seconds": 12.5})
        self.assertRegex(self.calls()[0], r"^--nthreads 2 --outfile \S+ \S+scene\.pbrt$")

    def test_the_scenes_folder_is_left_as_it_is(self):
        before = sorted(os.listdir(os.path.dirname(self.path)))
        self.render()
        self.assertEqual(sorted(os.listdir(os.path.dirname(self.path))), before)

    def test_relative_paths_stay_right_in_another_folder(self):
        self.assertEqual(self.render(3, "", "scene.pbrt"), (0, ""))
        self.assertIn(f'"string filename" "{os.path.realpath(self.mesh)}"', self.picture())

    def test_bdpt(self):
        self.assertEqual(self.render(3, "", None, "--integrator", "bdpt", "--max-depth", "30")[0], 0)
        self.assertIn('Integrator "bdpt" "integer maxdepth" [ 30 ]', self.picture())

    def test_version_4_upgrades_what_is_older(self):
        self.assertEqual(self.render(4), (0, ""))
        self.assertTrue(self.picture().startswith("# upgraded\n"))
        self.assertRegex(self.calls()[0], r"^--upgrade \S+$")
        self.assertRegex(self.calls()[1], r"^--nthreads 2 --outfile \S+ --spp 20 --seed 7 \S+$")

    def test_version_4_takes_its_own_as_it_is_and_version_3_does_not(self):
        scene = self.file("scene/four.pbrt", 'Film "rgb" "string sensor" "cie1931"\nWorldBegin\nShape "sphere"\n')
        self.assertEqual(self.render(4, "", scene), (0, ""))
        self.assertEqual(len(self.calls()), 1)
        self.assertIn('Film "rgb"', self.picture())
        self.assertIn('"string sensor" "cie1931"', self.picture())
        status, said = self.render(3, "", scene)
        self.assertNotEqual(status, 0)
        self.assertEqual(said, f"{scene}: is a scene of pbrt-v4\n")

    def test_pbrts_errors_are_ours(self):
        for what, line in (("error", "pbrt: scene.pbrt:3:1: Error: Couldn't open mesh"),
                           ("fails", "pbrt ended with status 3: out of memory"),
                           ("nothing", "pbrt ended well but wrote no picture")):
            status, said = self.render(3, what)
            self.assertNotEqual(status, 0)
            self.assertEqual(said, line + "\n")

    def test_not_installed(self):
        os.remove(self.program)
        status, said = self.render()
        self.assertNotEqual(status, 0)
        self.assertIn("PBRT_V3", said)
        self.assertEqual(said.count("\n"), 1)

    def test_check_tells_the_versions_apart(self):
        for version, option in ((3, "--cat"), (4, "--upgrade")):
            self.file("bin/pbrt", f"#!/bin/sh\necho '  {option}  Print' >&2\n")
            for adapter in (3, 4):
                with open(os.path.join(HERE, f"pbrt-v{adapter}", "adapter.json"), encoding="utf-8") as f:
                    check = json.load(f)["check"]
                status = subprocess.run(check, env=dict(os.environ, **{f"PBRT_V{adapter}": self.program}),
                                        check=False).returncode
                self.assertEqual(status == 0, adapter == version)

    def test_refusals_have_their_line(self):
        scene = self.file("scene/broken.pbrt", 'Camera "perspective"\nInclude "none.pbrt"\nWorldBegin\n')
        status, said = self.render(3, "", scene)
        self.assertNotEqual(status, 0)
        self.assertTrue(said.startswith(f"{scene}:2:9: cannot find the file to include 'none.pbrt'"), said)
        self.assertEqual(said.count("\n"), 1)


class Budget(unittest.TestCase):
    def test_time_counts_from_the_start_of_the_process(self):
        program = ("import time; time.sleep(.3); import sys; sys.path.insert(0, sys.argv[1]); import budget; "
                   "print(budget.since_start(), budget.Deadline(10).left())")
        done = subprocess.run([sys.executable, "-B", "-c", program, HERE], stdout=subprocess.PIPE, check=True,
                              text=True)
        since, left = map(float, done.stdout.split())
        self.assertGreater(since, 0.28)
        self.assertAlmostEqual(since + left, 10, delta=0.2)

    def test_refusal_is_one_line(self):
        def main():
            raise Refused(None, "one\ntwo")
        with self.assertRaises(SystemExit) as caught:
            budget.run(main)
        self.assertEqual(caught.exception.code, "one two")


if __name__ == "__main__":
    if len(sys.argv) > 1 and os.path.isfile(sys.argv[1]):
        os.environ["DRC_PROGRAM"] = os.path.abspath(sys.argv.pop(1))
    unittest.main()
