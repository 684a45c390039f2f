"""Rendered shading in the viewport: the scene is exported for a `drc view`, whose frames are drawn.

A scene that has changed is exported again, a moment after its last change, and given to a new renderer; the old one's
picture stays until then. A renderer is only told of a view that moves, or has another lens or size. All of Blender is
touched in its own callbacks and timers.
"""

import time
import weakref

import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from .commands import view_command
from .export.scene import SceneExporter
from .export_place import exporter_settings, private_folder, viewport_folder
from .program import UserError
from .properties import preferences, program
from .view_camera import frame_size, is_view, view_of
from .view_client import ViewClient
from .view_region import depth_of_field_of, part_of

AFTER_A_CHANGE = 0.4  # seconds without a change before the scene is exported
MOVING = 0.25  # seconds after which a camera stands still
WHILE_MOVING = 640  # pixels of a frame's longer side
LOOK_EVERY = 0.05  # seconds
AT_FIRST = 64, 64  # size of the picture that a renderer begins with, before it is told of the view

_all = weakref.WeakSet()


def viewport_of(engine):
    """Kept with the engine, which Blender makes for each viewport that is shaded."""
    found = getattr(engine, "viewport", None)
    if found is None:
        found = engine.viewport = Viewport(engine)
        _all.add(found)
    return found


def close_all():
    for viewport in list(_all):
        viewport.close()


class Viewport:
    def __init__(self, engine):
        self._engine = weakref.ref(engine)
        self._client, self._exporter, self._renders, self._error = None, None, None, None
        self._folder = None  # goes with this object
        self._changed_at, self._moved_at, self._view = time.monotonic(), 0.0, None
        self._sphere, self._frame, self._texture = None, None, None
        # The renderer ends with the engine, which Blender frees when the shading changes or the window closes.
        weakref.finalize(engine, self.close)
        bpy.app.timers.register(self._look, first_interval=LOOK_EVERY)

    def close(self):
        client, self._client = self._client, None
        if client is not None:
            client.close()

    # Blender's callbacks

    def update(self, _context, _depsgraph):
        self._changed_at = time.monotonic()

    def draw(self, context, depsgraph):
        engine, now = self._engine(), time.monotonic()
        region, region_data = context.region, context.region_data
        if not region.width or not region.height or not is_view(region_data.view_matrix, region_data.window_matrix):
            return
        focus = depth_of_field_of(context, depsgraph)
        view = view_of(region_data.view_matrix, region_data.window_matrix, focus)
        if view != self._view:
            self._view, self._moved_at = view, now
            if self._client is not None and self._client.error:
                self._changed_at = now  # the renderer may have refused the view before
        due = self._changed_at is not None and (self._client is None or now - self._changed_at > AFTER_A_CHANGE)
        if due:
            self._start(depsgraph, view)
        part = part_of(context, depsgraph.scene)
        if self._client is not None:
            moving = now - self._moved_at < MOVING
            size = frame_size(region.width, region.height, WHILE_MOVING if moving else None)
            self._client.move(view.before(self._sphere), *size, moving, part)
            frame = self._client.frame()
            if frame is not None:
                self._frame, self._texture = frame, None
        self._tell(engine)
        self._draw_frame(region, part)

    def _start(self, depsgraph, view):
        """Exports, and replaces the renderer if it would show something else."""
        scene = depsgraph.scene
        self._changed_at, self._error = None, None
        try:
            if self._folder is None:
                self._folder = viewport_folder()
                self._exporter = SceneExporter(self._folder.name, exporter_settings(scene.drc))
            self._exporter.settings = exporter_settings(scene.drc)
            exported = self._exporter.export(depsgraph, size=AT_FIRST, view=view)
            self._sphere = exported.sphere
            command = view_command(program(), exported.path, *AT_FIRST, scene.drc, preferences().threads)
            renders = exported.content, command
            if renders == self._renders and self._client is not None and not self._client.error:
                return  # Blender has told of a change of nothing that is rendered, such as the selection
            client = ViewClient(command)
        except OSError as error:
            self._error = f"cannot write the scene to {self._exporter.folder if self._exporter else private_folder()}: {error.strerror or error}"
            return
        except (UserError, ValueError) as error:
            self._error = str(error)
            return
        self.close()
        self._client, self._renders = client, renders

    def _tell(self, engine):
        """In the viewport's upper left corner."""
        client = self._client
        line = self._error or (client.error or client.progress if client is not None else "")
        engine.update_stats("DRC" if line else "", line)

    def _draw_frame(self, region, part):
        """In linear values: the window's view transform comes after."""
        if self._frame is None:
            return
        if self._texture is None:
            height, width = self._frame.shape[:2]
            values = np.ones((height, width, 4), dtype=np.float32)
            values[..., :3] = self._frame[::-1, :, :3]
            buffer = gpu.types.Buffer("FLOAT", width * height * 4, values.reshape(-1))
            self._texture = gpu.types.GPUTexture((width, height), format="RGBA16F", data=buffer)
        x0, x1, y0, y1 = part or (0.0, 1.0, 0.0, 1.0)
        corners = [(x0, 1 - y1), (x1, 1 - y1), (x1, 1 - y0), (x0, 1 - y0)]
        shader = gpu.shader.from_builtin("IMAGE")
        shader.uniform_sampler("image", self._texture)
        places = [(x * region.width, y * region.height) for x, y in corners]
        batch_for_shader(shader, "TRI_FAN", {"pos": places, "texCoord": corners}).draw(shader)

    # A timer of Blender's

    def _look(self):
        """Asks for a redraw when there is something to draw; ends with the engine."""
        engine = self._engine()
        if engine is None:
            return None
        now = time.monotonic()
        client = self._client
        settles = MOVING < now - self._moved_at < MOVING + 3 * LOOK_EVERY
        due = self._changed_at is not None and now - self._changed_at > AFTER_A_CHANGE
        if due or settles or (client is not None and client.has_news()):
            try:
                engine.tag_redraw()
            except ReferenceError:  # freed by Blender before Python noticed
                return None
        return LOOK_EVERY
