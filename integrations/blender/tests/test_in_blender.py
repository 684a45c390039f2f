#!/usr/bin/env python3
"""The add-on in Blender: F12 in the background, its passes, what the user reads when something goes wrong, exports.

    integrations/blender/tests/test_in_blender.py --drc build/release/drc

Run it with a Python that has Blender's module bpy (4.5 or later); without it the test is skipped: it ends with status 77.
"""

import os
import re
import resource
import signal
import stat
import sys
import tempfile
import time
import types
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
try:
    import bpy
except ImportError:
    print("skipped: this Python has no bpy")
    sys.exit(77)
import numpy as np

import drc_blender
from compare_with_cycles import quietly, read
from drc_blender import engine
from drc_blender.engine import DrcRenderEngine
from drc_blender.export.camera_maths import screen_window
from drc_blender.export.cameras import lens_of
from drc_blender.export.scene import SceneExporter
from drc_blender.frame_renderer import FrameRenderer
from drc_blender.properties import Defaults
from drc_blender.render_passes import pass_values
from scenes import light_paths
from stage import HEIGHT, WIDTH, Stage, stripes

DRC = None


class InBlender(unittest.TestCase):
    def setUp(self):
        self.stage = Stage()
        self.scene = self.stage.scene
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.scene.render.engine = "DRC"
        drc = self.scene.drc
        drc.stop, drc.samples, drc.keep_files = "SAMPLES", 8, self.folder.name
        Defaults.program = DRC
        self.kept = []

    def render(self):
        """The errors and warnings that the user reads; the picture is in the render result."""
        said, raised = [], None
        tell = DrcRenderEngine.tell

        def heard(engine, kind, message):
            said.append((kind, message))
            tell(engine, kind, message)

        DrcRenderEngine.tell = heard
        try:
            quietly(lambda: bpy.ops.render.render())
        except RuntimeError as error:
            raised = str(error)
        finally:
            DrcRenderEngine.tell = tell
        for kind, message in said:
            if kind == "ERROR":  # has reached the user
                self.assertIn(f"DRC: {message}", raised or "")
        return said if raised is None or said else [("ERROR", raised)]

    def error(self):
        found = [text for kind, text in self.render() if kind == "ERROR"]
        self.assertEqual(len(found), 1, found)
        self.assertNotIn("\n", found[0])
        return found[0]

    def program(self, code):
        path = os.path.join(self.folder.name, "drc-stand-in")
        with open(path, "w") as f:
            f.write(f"#!{sys.executable}\n{code}\n")
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
        Defaults.program = path

    def picture(self):
        """The combined pass that Blender has kept."""
        path = os.path.join(self.folder.name, "kept.exr")
        settings = self.scene.render.image_settings
        settings.file_format, settings.color_depth = "OPEN_EXR", "32"
        bpy.data.images["Render Result"].save_render(path, scene=self.scene)
        return read(path)


class Renders(InBlender):
    def test_the_picture_is_the_renderers_bit_for_bit(self):
        kept = os.path.join(self.folder.name, "beside.exr")
        # Without the layers that Blender's reader of plain pictures does not take.
        self.program(
            f"import shutil, subprocess, sys\n"
            f"status = subprocess.call([{DRC!r}, *(a for a in sys.argv[1:] if a != '--aovs')])\n"
            f"shutil.copy(sys.argv[sys.argv.index('-o') + 1], {kept!r})\nsys.exit(status)"
        )
        said = self.render()
        self.assertFalse([s for s in said if s[0] == "ERROR"], said)
        picture = self.picture()
        self.assertEqual(picture.shape, (HEIGHT, WIDTH, 3))
        self.assertGreater(picture.mean(), 0.05)
        np.testing.assert_array_equal(picture, read(kept))

    def test_passes_reach_multilayer_files(self):
        path = os.path.join(self.folder.name, "layers.exr")
        settings = self.scene.render.image_settings
        if hasattr(settings, "media_type"):
            settings.media_type = "MULTI_LAYER_IMAGE"
        settings.file_format = "OPEN_EXR_MULTILAYER"
        self.scene.render.filepath = path
        quietly(lambda: bpy.ops.render.render(write_still=True))
        with open(path, "rb") as f:
            head = f.read(1 << 14)
        for name in ("Combined.R", "Depth.Z", "Normal.X", "Denoising Albedo.R", "Variance.R", "Sample Count.X"):
            self.assertIn(b"." + name.encode() + b"\0", head)
        for name in ("Direct.R", "Indirect.B"):
            self.assertIn(b"." + name.encode() + b"\0", head)

    def passes(self):
        """Of a render: the last values of each pass, by name."""
        kept = {}

        def keep(picture, name, bounds):
            kept[name] = found = pass_values(picture, name, bounds)
            return found

        engine.pass_values = keep
        try:
            self.render()
        finally:
            engine.pass_values = pass_values
        return kept

    def test_a_transparent_film_has_an_alpha(self):
        self.assertTrue((self.passes()["Combined"].reshape(-1, 4)[:, 3] == 1).all())
        self.scene.render.film_transparent = True
        Stage.aim(self.stage.camera, (0, 0, 2))  # it sees the horizon
        combined = self.passes()["Combined"].reshape(HEIGHT, WIDTH, 4)
        self.assertTrue((combined[0, :, 3] == 1).all(), "the floor is below")
        self.assertTrue((combined[-1] == 0).all(), "and the sky above")
        edges = combined[(combined[..., 3] > 0) & (combined[..., 3] < 1)]
        self.assertGreater(len(edges), 10)

    def test_direct_and_indirect_are_combined(self):
        self.scene.drc.denoise = False
        kept = self.passes()
        combined = kept["Combined"].reshape(-1, 4)[:, :3]
        direct, indirect = (kept[name].reshape(-1, 3) for name in ("Direct", "Indirect"))
        self.assertGreater(direct.mean(), 0.01)
        self.assertGreater(indirect.mean(), 0.01)
        np.testing.assert_allclose(direct + indirect, combined, rtol=1e-4, atol=1e-5)

    def frames(self, last):
        """The pictures of an animation from frame 1 on, and how many renderers it has started."""
        log = os.path.join(self.folder.name, "starts.txt")
        self.program(f"import os, sys\nopen({log!r}, 'a').write('x')\nos.execv({DRC!r}, [{DRC!r}, *sys.argv[1:]])")
        self.scene.frame_start, self.scene.frame_end = 1, last
        self.scene.render.filepath = os.path.join(self.folder.name, "frame-")
        settings = self.scene.render.image_settings
        settings.file_format, settings.color_depth = "OPEN_EXR", "32"
        quietly(lambda: bpy.ops.render.render(animation=True))
        pictures = [read(os.path.join(self.folder.name, f"frame-{i:04}.exr")) for i in range(1, last + 1)]
        with open(log) as f:
            return pictures, len(f.read())

    def test_an_animation_has_one_renderer(self):
        self.scene.drc.cells = False
        self.scene.drc.denoise = False
        camera, ball = self.stage.camera, self.stage.ball
        for frame, x in ((1, 3.2), (3, 3.6)):
            camera.location.x = x
            camera.keyframe_insert("location", frame=frame)
        # In the third frame the world is another one.
        for frame, x in ((1, -0.7), (2, -0.7), (3, -0.2)):
            ball.location.x = x
            ball.keyframe_insert("location", frame=frame)
        pictures, starts = self.frames(3)
        self.assertEqual(starts, 1)
        self.assertIsNone(FrameRenderer._kept)
        for frame, found in enumerate(pictures, 1):
            self.scene.frame_set(frame)
            self.render()
            alone = self.picture()
            np.testing.assert_array_equal(found, alone)
        self.assertGreater(np.abs(pictures[0] - pictures[1]).max(), 0.1)

    def test_an_animation_ends_with_what_is_wrong(self):
        self.program("import sys\nprint('drc: error: no more', file=sys.stderr)\nsys.exit(1)")
        self.scene.frame_start, self.scene.frame_end = 1, 2
        self.scene.render.filepath = os.path.join(self.folder.name, "frame-")
        with self.assertRaisesRegex(RuntimeError, "DRC: no more"):
            quietly(lambda: bpy.ops.render.render(animation=True))
        self.assertIsNone(FrameRenderer._kept)

    def test_region(self):
        render = self.scene.render
        render.use_border = True
        render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y = 0.25, 0.6, 0.3, 0.8
        for crop in (False, True):
            render.use_crop_to_border = crop
            said = self.render()
            self.assertFalse([s for s in said if s[0] == "ERROR"], said)
            picture = self.picture()
            if crop:
                self.assertEqual(
                    picture.shape[:2], (int(0.8 * HEIGHT) - int(0.3 * HEIGHT), int(0.6 * WIDTH) - int(0.25 * WIDTH))
                )
            self.assertGreater(picture.mean(), 0.01)

    def test_a_render_stops_by_time(self):
        self.scene.drc.stop, self.scene.drc.time = "TIME", 2
        began = time.monotonic()
        said = self.render()
        self.assertFalse([s for s in said if s[0] == "ERROR"], said)
        self.assertLess(time.monotonic() - began, 20)

    def test_cancel(self):
        self.program("import signal, sys, time\nsignal.signal(signal.SIGINT, lambda *_: sys.exit(0))\ntime.sleep(100)")
        began = time.monotonic()
        asked, DrcRenderEngine.is_cancelled = (
            DrcRenderEngine.is_cancelled,
            lambda engine: time.monotonic() - began > 0.5,
        )
        try:
            said = self.render()
        finally:
            DrcRenderEngine.is_cancelled = asked
        self.assertLess(time.monotonic() - began, 10)
        self.assertFalse([s for s in said if s[0] == "ERROR"], said)


class Failures(InBlender):
    """After each, Blender renders again."""

    def tearDown(self):
        Defaults.program = DRC
        said = self.render()
        self.assertTrue(not [s for s in said if s[0] == "ERROR"] or self.scene.camera is None or self.broken, said)

    broken = False  # whether the scene itself is

    def test_missing_program(self):
        Defaults.program = "/nowhere/drc"
        self.assertEqual(
            self.error(), "there is no program /nowhere/drc: choose that of DRC in the add-on's preferences"
        )

    def test_no_camera(self):
        self.scene.camera = None
        said = self.render()
        self.assertTrue(any("camera" in text.lower() for _, text in said), said)

    def test_broken_scene(self):
        self.broken = True
        self.stage.box.data.vertices[0].co.x = float("inf")
        self.assertRegex(self.error(), "^box: the mesh has a vertex at no number")

    def test_a_number_that_is_none_is_named(self):
        self.broken = True
        self.stage.shader(self.stage.ball.data.materials[0], "BsdfDiffuse", Color=(0.5, float("nan"), 0.5, 1))
        self.assertEqual(self.error(), "ball: reflectance is nan, which a scene file cannot have")

    def test_killed(self):
        self.program("import os, time\ntime.sleep(0.3)\nos.kill(os.getpid(), 9)")
        self.assertEqual(self.error(), "the renderer was ended from outside (SIGKILL)")

    def test_crash(self):
        self.program("import os\nos.kill(os.getpid(), 11)")
        self.assertEqual(self.error(), "the renderer crashed (SIGSEGV)")

    def test_no_picture(self):
        self.program("pass")
        self.assertEqual(self.error(), "the renderer has sent no picture")

    def test_a_disk_without_room(self):
        """For files beyond a size; a full disk takes the same way (and was tried by hand)."""
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (100, hard))
        try:
            said = self.error()
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        self.assertRegex(said, "cannot write the scene to /.*/drc-render: File too large")


class Exports(InBlender):
    def exported(self, exporter):
        return exporter.export(bpy.context.evaluated_depsgraph_get())

    def text(self, exporter):
        with open(self.exported(exporter).path, encoding="utf-8") as f:
            return f.read()

    def test_windows_are_blenders(self):
        camera = self.stage.camera.data
        render = self.scene.render
        for kind in ("PERSP", "ORTHO"):
            for fit in ("AUTO", "HORIZONTAL", "VERTICAL"):
                for width, height, aspect in ((640, 360, 1), (360, 640, 1), (400, 400, 1.5)):
                    camera.type, camera.sensor_fit, camera.shift_x, camera.shift_y, camera.sensor_height = (
                        kind,
                        fit,
                        0.1,
                        -0.2,
                        20,
                    )
                    render.resolution_x, render.resolution_y, render.pixel_aspect_y = width, height, aspect
                    corners = np.array([tuple(c) for c in camera.view_frame(scene=self.scene)])
                    scale = 1 if kind == "ORTHO" else -corners[0, 2]
                    theirs = [f(corners[:, axis]) / scale for axis in (0, 1) for f in (np.min, np.max)]
                    np.testing.assert_allclose(
                        screen_window(lens_of(camera), width, height, aspect),
                        theirs,
                        rtol=1e-5,
                        err_msg=f"{kind} {fit} {width}",
                    )

    def test_only_what_has_changed_is_written(self):
        exporter = SceneExporter(os.path.join(self.folder.name, "again"))
        self.assertEqual(self.exported(exporter).meshes_written, 3)
        self.assertEqual(self.exported(exporter).meshes_written, 0)
        self.stage.ball.location.x += 1
        self.assertEqual(self.exported(exporter).meshes_written, 0)
        self.stage.box.data.vertices[0].co.x += 0.1
        self.stage.box.data.update()
        self.assertEqual(self.exported(exporter).meshes_written, 1)
        self.assertEqual(len(os.listdir(os.path.join(exporter.folder, "meshes"))), 3)

    def test_painted_images_are_exported_again(self):
        material = self.stage.floor.data.materials[0]
        image = Stage.image("paint", 32, 32, stripes)
        Stage.shader(
            self.stage,
            material,
            "BsdfDiffuse",
            Color=Stage.node(self.stage, material, "TexImage", {"image": image}).outputs[0],
        )
        exporter = SceneExporter(os.path.join(self.folder.name, "painted"))
        first = self.text(exporter)
        image.pixels.foreach_set([0.25] * (32 * 32 * 4))
        image.update()
        self.assertNotEqual(first, self.text(exporter))

    def test_what_is_scaled_to_nothing(self):
        """Flat objects are shown, and others and their lamps are left out, as by Blender."""
        self.stage.ball.scale = 0, 0, 0
        self.stage.box.scale.x = 0
        spot = bpy.data.objects.new("spot", bpy.data.lights.new("spot", "SPOT"))
        spot.scale = 0, 0, 0
        self.scene.collection.objects.link(spot)
        exported = self.exported(SceneExporter(os.path.join(self.folder.name, "nothing")))
        self.assertEqual(exported.instances, 2)
        self.assertEqual(
            exported.report.lines(), ["spot: a lamp that is scaled to nothing has no direction; it is left out"]
        )
        self.assertEqual([s for s in self.render() if s[0] == "ERROR"], [])

    def test_settings_of_the_view_layer(self):
        exporter = SceneExporter(os.path.join(self.folder.name, "layer"))
        layer = bpy.context.view_layer

        def hidden_meshes():
            return [line for line in self.text(exporter).splitlines() if "plymesh" in line and "visibletocamera" in line]

        self.assertEqual(hidden_meshes(), [])
        collection = bpy.data.collections.new("indirect")
        self.scene.collection.children.link(collection)
        collection.objects.link(self.stage.ball)
        self.scene.collection.objects.unlink(self.stage.ball)
        layer.layer_collection.children["indirect"].indirect_only = True
        self.assertEqual(len(hidden_meshes()), 1)
        layer.layer_collection.children["indirect"].indirect_only = False
        layer.layer_collection.children["indirect"].holdout = True
        report = self.exported(exporter).report.lines()
        self.assertIn("ball: holdouts have no equal; the object is shown", report)
        layer.layer_collection.children["indirect"].holdout = False
        layer.material_override = bpy.data.materials.new("clay")
        clay = self.text(exporter)
        self.assertEqual(clay.count("MakeNamedMaterial"), 1)
        self.assertIn('"clay', clay)

    def test_what_has_no_equal_is_named(self):
        material = self.stage.ball.data.materials[0]
        # Blender 4.2 has no Gabor noise yet.
        kind, name, output = ("TexGabor", "Gabor Texture", "Value")
        if not hasattr(bpy.types, "ShaderNodeTexGabor"):
            kind, name, output = ("Bevel", "Bevel", "Normal")
        node = Stage.node(self.stage, material, kind)
        Stage.shader(self.stage, material, "BsdfDiffuse", Color=node.outputs[output])
        self.stage.ball.visible_glossy = False
        report = self.exported(SceneExporter(os.path.join(self.folder.name, "report"))).report.lines()
        self.assertIn(f"ball > {name}: the node {name} has no equal; the socket's own value is used", report)
        self.assertIn("ball: objects are seen by all rays; this one is hidden from glossy rays", report)

    def rays(self, *names, glass="BsdfGlass", scale=1.0, **inputs):
        """(parameters of the ball's Shape, report) where it is clear to the rays that Light Path calls by these names."""
        material = self.stage.ball.data.materials[0]
        factor = light_paths.told(self.stage, material, *names)
        if scale != 1:
            factor = self.stage.node(material, "Math", {"operation": "MULTIPLY"}, i0=factor, i1=scale).outputs[0]
        light_paths.mixed(
            self.stage,
            material,
            factor,
            self.stage.node(material, glass, **inputs),
            self.stage.node(material, "BsdfTransparent", Color=(1, 1, 1)),
        )
        exported = self.exported(SceneExporter(os.path.join(self.folder.name, "rays")))
        with open(exported.path, encoding="utf-8") as file:
            lines = file.read().splitlines()
        at = next(i for i, line in enumerate(lines) if line == 'NamedMaterial "ball"')
        parameters = dict(re.findall(r'"(\w+ \w+)" \[([^]]*)\]', lines[at + 1]))
        return parameters, [line for line in exported.report.lines() if "ball" in line]

    def test_shadows_of_light_paths(self):
        parameters, report = self.rays("Is Shadow Ray", Roughness=0.0)
        self.assertEqual(parameters["float shadowalpha"], "0")
        self.assertNotIn("bool visibletodiffuse", parameters)
        self.assertEqual(report, [])

    def test_shadows_that_light_paths_make_lighter(self):
        parameters, report = self.rays("Is Shadow Ray", glass="BsdfDiffuse", scale=0.25)
        self.assertEqual(parameters["float shadowalpha"], "0.75")
        self.assertEqual(report, [])

    def test_windows_of_light_paths(self):
        parameters, report = self.rays("Is Shadow Ray", "Is Diffuse Ray", Roughness=0.0)
        self.assertEqual(parameters["bool visibletodiffuse"], "false")
        self.assertNotIn("float shadowalpha", parameters)
        self.assertEqual(report, [])

    def test_frosted_windows_of_light_paths(self):
        parameters, report = self.rays("Is Shadow Ray", "Is Diffuse Ray", Roughness=0.4)
        self.assertEqual(parameters["float shadowalpha"], "0")
        self.assertNotIn("bool visibletodiffuse", parameters)
        self.assertEqual(report, ["ball: diffuse rays meet the surface that the camera sees"])

    def test_light_paths_that_hide_from_the_camera(self):
        parameters, report = self.rays("Is Camera Ray", glass="BsdfDiffuse")
        self.assertEqual(parameters["bool visibletocamera"], "false")
        self.assertEqual(len(parameters), 2)
        self.assertEqual(report, [])

    def test_light_paths_without_an_equal_are_named(self):
        _, report = self.rays("Is Glossy Ray", "Ray Depth", Roughness=0.0)
        self.assertIn("ball: mirrors show the surface that the camera sees", report)
        self.assertTrue(any("'Ray Depth' of Light Path has no equal" in line for line in report), report)

    def test_two_worlds(self):
        light_paths.backdrop(self.stage, (0.25, 0.5, 1.0), (1.0, 0.75, 0.5))
        exported = self.exported(SceneExporter(os.path.join(self.folder.name, "worlds")))
        with open(exported.path, encoding="utf-8") as file:
            lights = [line for line in file.read().splitlines() if line.startswith('LightSource "infinite"')]
        self.assertEqual(
            lights,
            [
                'LightSource "infinite" "rgb L" [1 0.75 0.5] "bool visibletocamera" [false]',
                'LightSource "infinite" "rgb L" [0.25 0.5 1] "bool illuminates" [false]',
            ],
        )
        self.assertEqual(exported.report.lines(), [])

    def test_objects_that_diffuse_rays_and_shadows_pass(self):
        self.stage.ball.visible_diffuse = self.stage.ball.visible_shadow = False
        exported = self.exported(SceneExporter(os.path.join(self.folder.name, "pane")))
        with open(exported.path, encoding="utf-8") as file:
            self.assertEqual(file.read().count('"bool visibletodiffuse" [false]'), 1)
        self.assertEqual(exported.report.lines(), [])

    def test_operator(self):
        path = os.path.join(self.folder.name, "by hand.pbrt")
        self.scene.render.engine = "CYCLES"
        quietly(lambda: bpy.ops.export_scene.drc(filepath=path))
        with open(path) as f:
            self.assertIn('Shape "plymesh"', f.read())
        self.assertEqual(self.scene.render.engine, "CYCLES")

    def test_a_large_room_is_exported_quickly(self):
        side = 354
        grid = np.stack(np.meshgrid(np.linspace(-4, 4, side), np.linspace(-4, 4, side)), axis=-1).reshape(-1, 2)
        heights = 0.1 * np.sin(grid[:, :1] * 5) * np.sin(grid[:, 1:] * 7)
        index = np.arange(side * side).reshape(side, side)
        faces = np.stack([index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]], axis=-1).reshape(-1, 4)
        room = self.stage.mesh(
            "room", np.hstack([grid, heights]).tolist(), faces.tolist(), None, uvs=grid[faces.reshape(-1)].tolist()
        )
        room.data.shade_smooth()
        bpy.context.view_layer.update()
        exporter = SceneExporter(os.path.join(self.folder.name, "room"))
        seconds = []
        for _ in range(2):
            began = time.monotonic()
            made = self.exported(exporter)
            seconds.append(time.monotonic() - began)
        print(f"\n{made.triangles} triangles: first export {seconds[0]:.2f} s, second {seconds[1]:.2f} s", flush=True)
        self.assertGreater(made.triangles, 249_000)
        self.assertLess(seconds[1], 1)


class StandInEngine:
    """What the viewport needs of an engine and of its window, which there is none of in the background."""

    def __init__(self):
        self.stats, self.redraws = "", 0

    def update_stats(self, _stats, info):
        self.stats = info

    def tag_redraw(self):
        self.redraws += 1


class Viewports(InBlender):
    """All but the drawing, which test_in_window.py sees."""

    def setUp(self):
        super().setUp()
        from drc_blender import viewport

        self.engine = StandInEngine()
        self.viewport = viewport.viewport_of(self.engine)
        self.addCleanup(self.viewport.close)
        self.viewport._draw_frame = lambda *_: None
        self.region = types.SimpleNamespace(width=96, height=64)
        self.place, self.perspective = self.stage.camera.matrix_world.copy(), "PERSP"

    def draw(self):
        depsgraph = bpy.context.evaluated_depsgraph_get()
        projection = self.stage.camera.calc_matrix_camera(depsgraph, x=self.region.width, y=self.region.height)
        data = types.SimpleNamespace(
            view_matrix=self.place.inverted(), window_matrix=projection, view_perspective=self.perspective
        )
        space = types.SimpleNamespace(use_render_border=False, use_local_camera=False)
        self.viewport.draw(types.SimpleNamespace(region=self.region, region_data=data, space_data=space), depsgraph)
        return self.viewport._frame

    def until(self, condition, seconds=60):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, self.engine.stats)
            self.viewport._look()
            time.sleep(0.01)

    def shown(self):
        """The frame after some seconds of the present view."""
        began, size = time.monotonic(), (self.region.height, self.region.width)
        self.until(
            lambda: self.draw() is not None
            and self.viewport._frame.shape[:2] == size
            and time.monotonic() > began + 3
        )
        return self.viewport._frame.astype(np.float32)

    def rendered(self):
        render = self.scene.render
        render.resolution_x, render.resolution_y = self.region.width, self.region.height
        self.scene.drc.samples, self.scene.drc.filter_kind, self.scene.drc.filter_width = 64, "BOX", 1.0
        self.render()
        return self.picture()

    def check_alike(self, shown, rendered):
        np.testing.assert_allclose(shown.mean(axis=(0, 1)), rendered.mean(axis=(0, 1)), rtol=0.03)
        # Turned or mirrored it would not be the same.
        self.assertGreater(np.corrcoef(shown.ravel(), rendered.ravel())[0, 1], 0.98)

    def test_it_shows_what_the_camera_sees(self):
        shown = self.shown()
        self.assertGreater(self.engine.redraws, 0)
        self.check_alike(shown, self.rendered())

    def test_lenses_and_sizes_keep_the_renderer(self):
        camera = self.stage.camera.data
        self.until(lambda: self.draw() is not None)
        client = self.viewport._client
        camera.lens, camera.shift_x = 70, 0.1
        self.region.width, self.region.height = 80, 60
        longer = self.shown()
        camera.type, camera.ortho_scale = "ORTHO", 4
        parallel = self.shown()
        # Blender tells of the camera's changes as of any other; the scene is the same.
        self.viewport.update(None, None)
        self.until(lambda: self.draw() is not None and self.viewport._changed_at is None)
        self.assertIs(self.viewport._client, client)
        self.check_alike(parallel, self.rendered())
        camera.type = "PERSP"
        self.check_alike(longer, self.rendered())

    def test_through_the_camera_it_has_depth_of_field(self):
        dof = self.stage.camera.data.dof
        dof.use_dof, dof.focus_distance, dof.aperture_fstop = True, 2.0, 0.05
        sharp = self.shown()
        client, self.perspective = self.viewport._client, "CAMERA"
        blurred, rendered = self.shown(), self.rendered()
        self.check_alike(blurred, rendered)
        self.assertLess(np.corrcoef(sharp.ravel(), rendered.ravel())[0, 1], 0.9)
        self.assertIs(self.viewport._client, client)

    def test_the_camera_moves_and_the_scene_changes(self):
        self.until(lambda: self.draw() is not None)
        before, client = self.viewport._frame.astype(np.float32).mean(), self.viewport._client
        self.place.translation.z += 6
        self.place.translation.y -= 4
        self.until(
            lambda: self.draw() is not None and abs(self.viewport._frame.astype(np.float32).mean() / before - 1) > 0.02
        )
        self.assertIs(self.viewport._client, client)  # told, not started again
        self.scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 5
        self.viewport.update(None, None)
        self.until(lambda: self.draw() is not None and self.viewport._frame.astype(np.float32).mean() > 2 * before)
        self.assertIsNot(self.viewport._client, client)
        self.until(lambda: not client.child.running())

    def test_a_change_of_nothing_that_is_rendered_keeps_the_renderer(self):
        self.until(lambda: self.draw() is not None)
        client = self.viewport._client
        self.viewport.update(None, None)
        self.until(lambda: self.draw() is not None and self.viewport._changed_at is None)
        self.assertIs(self.viewport._client, client)

    def test_a_failure_is_told(self):
        Defaults.program = "/nowhere/drc"
        self.draw()
        self.assertIn("there is no program /nowhere/drc", self.engine.stats)


if __name__ == "__main__":
    at = sys.argv.index("--drc")
    DRC = os.path.abspath(sys.argv[at + 1])
    del sys.argv[at : at + 2]
    drc_blender.register()
    result = unittest.main(exit=False).result
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0 if result.wasSuccessful() else 1)  # bpy 4.5 does not end by itself
