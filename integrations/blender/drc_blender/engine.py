"""The render engine: F12 exports the scene, starts the renderer, shows its picture as it refines, and keeps its passes.

The renderer is a child process: whatever happens to it, Blender goes on, and its message is Blender's report.
"""

import os
import threading
import time

import bpy

from .commands import render_command, scene_file_name
from .export.camera_maths import pixel_bounds
from .export.scene import SceneExporter
from .export_place import export_folder, exporter_settings
from .frame_renderer import FrameRenderer
from .program import UserError
from .properties import preferences, program
from .render_passes import BUILT_IN, PASSES, pass_values
from .view_client import resting

LOOK_EVERY = 0.05  # seconds
DRAIN = 15.0  # seconds that the last picture may take to come
CANCEL = 0.2  # seconds that a cancelled renderer has to end by itself; nobody wants what it would write
LEAVE = 0.5  # seconds in which Blender has left a render after our part of it


class DrcRenderEngine(bpy.types.RenderEngine):
    bl_idname = "DRC"
    bl_label = "DRC"
    bl_use_preview = False
    bl_use_postprocess = True
    bl_use_shading_nodes_custom = False
    bl_use_eevee_viewport = True

    export_only = None  # a file: the next render writes the scene there, and renders nothing
    idle = threading.Event()  # no render is running
    idle.set()
    ending = False  # whether the add-on is about to be disabled

    # Passes

    def update_render_passes(self, scene, renderlayer):
        for name, channels, kind, _ in PASSES:
            self.register_pass(scene, renderlayer, name, len(channels), channels, kind)

    # F12

    def render(self, depsgraph):
        DrcRenderEngine.idle.clear()
        try:
            exported = self._export(depsgraph)
            if DrcRenderEngine.export_only is None:
                self._render(depsgraph.scene, exported)
        except UserError as error:
            self.tell("ERROR", str(error))
        except OSError as error:
            self.tell("ERROR", f"cannot write the scene to {self._folder(depsgraph.scene)}: {error.strerror or error}")
        except ValueError as error:
            self.tell("ERROR", str(error))
        finally:
            DrcRenderEngine.idle.set()

    def tell(self, kind, message):
        """kind: ERROR or WARNING. One line in Blender's reports."""
        self.report({kind}, f"DRC: {' '.join(message.split())}")

    def is_cancelled(self):
        return DrcRenderEngine.ending or self.test_break()

    @staticmethod
    def _folder(scene):
        chosen = DrcRenderEngine.export_only
        return os.path.dirname(chosen) if chosen is not None else export_folder(scene, "render")

    def _export(self, depsgraph):
        self.update_stats("", "DRC: exporting")
        scene = depsgraph.scene
        name = os.path.basename(DrcRenderEngine.export_only or scene_file_name(scene.frame_current))
        began = time.monotonic()
        exporter = SceneExporter(self._folder(scene), exporter_settings(scene.drc))
        exported = exporter.export(depsgraph, set_frame=self.frame_set, camera=self.camera_override, name=name)
        exported.seconds["export"] = time.monotonic() - began
        for line in exported.report.lines():
            self.tell("WARNING", line)
        return exported

    def _render(self, scene, exported):
        def command(scene_file, output, viewer):
            return render_command(program(), scene_file, output, scene.drc, viewer, preferences().threads)

        renderer = FrameRenderer.of_animation(command)
        done = False
        try:
            resting.set()
            bounds = self._bounds(scene)
            began = time.monotonic()
            renderer.begin(exported.path, more=self.is_animation)
            while not renderer.is_there():
                if self.is_cancelled():
                    renderer.close(CANCEL)
                    return
                self._show(renderer.receiver, scene, bounds, began)
                time.sleep(LOOK_EVERY)
            for line in renderer.finish(DRAIN):
                self.tell("WARNING", line)
            self._show(renderer.receiver, scene, bounds, began, last=True)
            if not scene.drc.keep_files:
                os.remove(exported.path)  # frames would pile up
            done = True
        finally:
            if done and self.is_animation:
                renderer.keep()
            else:
                renderer.close()
            resting.clear()

    def _bounds(self, scene):
        """(x0, x1, y0, y1) of what is rendered, from the top left of the film."""
        width, height = self.resolution_x, self.resolution_y
        render = scene.render
        if not render.use_border:
            return 0, width, 0, height
        return pixel_bounds(
            (render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y), width, height
        )

    def _show(self, receiver, scene, bounds, began, last=False):
        passed = time.monotonic() - began
        drc = scene.drc
        if drc.stop == "TIME":
            self.update_progress(min(1.0, passed / drc.time))
        picture = receiver.last() if last else receiver.changed()
        if picture is None:
            if last:
                raise UserError("the renderer has sent no picture" + (f" ({receiver.error})" if receiver.error else ""))
            return
        samples = picture.layer("samples.X")
        count = float(samples[0][bounds[2] : bounds[3], bounds[0] : bounds[1]].mean()) if samples is not None else 0
        if drc.stop == "SAMPLES":
            self.update_progress(min(1.0, count / drc.samples))
        self.update_stats("", f"DRC: {count:.1f} samples a pixel, {passed:.1f} s")
        # While it refines, one pass is enough: Blender waits for what is copied here.
        shown = [p for p in (PASSES if last else PASSES[:1]) if picture.layer(*p[3]) is not None]
        for name, channels, _, _ in shown:
            if name not in BUILT_IN:
                self.add_pass(name, len(channels), channels)
        names = {name for name, *_ in shown}
        result = self.begin_result(0, 0, bounds[1] - bounds[0], bounds[3] - bounds[2])
        try:
            for layer in result.layers:
                for render_pass in layer.passes:
                    if render_pass.name in names:
                        render_pass.rect.foreach_set(pass_values(picture, render_pass.name, bounds))
            self.update_result(result)
        finally:
            self.end_result(result)

    # Viewport

    # Without a window there is no GPU, which the viewport draws with.

    def view_update(self, context, depsgraph):
        from .viewport import viewport_of

        viewport_of(self).update(context, depsgraph)

    def view_draw(self, context, depsgraph):
        from .viewport import viewport_of

        viewport_of(self).draw(context, depsgraph)


# An animation is over.
ENDS = (bpy.app.handlers.render_complete, bpy.app.handlers.render_cancel, bpy.app.handlers.load_pre)


@bpy.app.handlers.persistent
def end_animation(*_):
    FrameRenderer.end_animation()


def register():
    DrcRenderEngine.ending = False
    bpy.utils.register_class(DrcRenderEngine)
    for handlers in ENDS:
        handlers.append(end_animation)


def unregister():
    # Blender crashes if the engine of a running render goes.
    if not DrcRenderEngine.idle.is_set():
        DrcRenderEngine.ending = True
        DrcRenderEngine.idle.wait(10)
        time.sleep(LEAVE)
    for handlers in ENDS:
        if end_animation in handlers:
            handlers.remove(end_animation)
    FrameRenderer.end_animation()
    bpy.utils.unregister_class(DrcRenderEngine)
