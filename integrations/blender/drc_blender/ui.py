"""Panels and operators."""

import atexit
import os

import bpy
from bpy_extras.io_utils import ExportHelper

from .commands import view_command
from .engine import DrcRenderEngine
from .export_place import export_folder
from .program import Child, UserError
from .properties import preferences, program


class DrcPanel:
    bl_space_type, bl_region_type, bl_context = "PROPERTIES", "WINDOW", "render"
    COMPAT_ENGINES = {DrcRenderEngine.bl_idname}

    @classmethod
    def poll(cls, context):
        return context.engine in cls.COMPAT_ENGINES

    def draw(self, context):
        self.layout.use_property_split, self.layout.use_property_decorate = True, False
        self.show(self.layout, context.scene.drc)


class DRC_PT_sampling(DrcPanel, bpy.types.Panel):
    bl_label = "DRC"

    def show(self, layout, drc):
        layout.prop(drc, "stop")
        if drc.stop == "TIME":
            layout.prop(drc, "time")
        elif drc.stop == "SAMPLES":
            layout.prop(drc, "samples")
        else:
            layout.prop(drc, "noise")
            layout.prop(drc, "most_time")
        layout.prop(drc, "denoise")
        layout.prop(drc, "cells")
        layout.operator(DRC_OT_show_in_browser.bl_idname, icon="URL")


class DRC_PT_paths(DrcPanel, bpy.types.Panel):
    bl_label = "Paths and Film"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, drc):
        for name in ("max_bounces", "seed", "filter_kind", "filter_width"):
            layout.prop(drc, name)


class DRC_PT_motion_blur(DrcPanel, bpy.types.Panel):
    bl_label = "Motion Blur"
    bl_options = {"DEFAULT_CLOSED"}

    def draw_header(self, context):
        self.layout.prop(context.scene.render, "use_motion_blur", text="")

    def draw(self, context):
        render, layout = context.scene.render, self.layout
        layout.use_property_split, layout.active = True, render.use_motion_blur
        if hasattr(render, "motion_blur_position"):
            layout.prop(render, "motion_blur_position", text="Position")
        layout.prop(render, "motion_blur_shutter")


class DRC_PT_export(DrcPanel, bpy.types.Panel):
    bl_label = "Export"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, drc):
        for name in ("texture_side", "world_side", "keep_files"):
            layout.prop(drc, name)
        layout.operator(DRC_OT_export.bl_idname, icon="EXPORT")


def export_scene(operator, context, path):
    """Writes the scene as the renderer would get it: through a render that ends after the export, since only that has
    the settings for renders, such as levels of subdivision. Returns whether it was written."""
    scene = context.scene
    engine = scene.render.engine
    DrcRenderEngine.export_only = path
    before = os.stat(path).st_mtime_ns if os.path.exists(path) else None
    try:
        scene.render.engine = DrcRenderEngine.bl_idname
        bpy.ops.render.render(scene=scene.name)
    except RuntimeError as error:  # what the engine has reported as an error
        operator.report({"ERROR"}, str(error).strip().removeprefix("Error: "))
        return False
    finally:
        DrcRenderEngine.export_only = None
        scene.render.engine = engine
    return os.path.exists(path) and os.stat(path).st_mtime_ns != before


class DRC_OT_export(bpy.types.Operator, ExportHelper):
    """Write the scene as a pbrt-v4 file with DRC's extensions, with its meshes and images in folders beside it"""

    bl_idname, bl_label = "export_scene.drc", "Export DRC/pbrt"
    filename_ext = ".pbrt"
    filter_glob: bpy.props.StringProperty(default="*.pbrt", options={"HIDDEN"})

    def execute(self, context):
        path = os.path.abspath(bpy.path.abspath(self.filepath))
        if not export_scene(self, context, path):
            return {"CANCELLED"}
        self.report({"INFO"}, f"DRC: wrote {path}")
        return {"FINISHED"}


class DRC_OT_show_in_browser(bpy.types.Operator):
    """Render the scene live in the browser"""

    bl_idname, bl_label = "render.drc_show_in_browser", "Show in Browser"
    child = None

    def execute(self, context):
        scene = context.scene
        path = os.path.join(export_folder(scene, "browser"), "scene.pbrt")
        if not export_scene(self, context, path):
            return {"CANCELLED"}
        scale = scene.render.resolution_percentage / 100
        size = [max(16, int(n * scale)) for n in (scene.render.resolution_x, scene.render.resolution_y)]
        stop_browser()
        try:
            DRC_OT_show_in_browser.child = Child(
                view_command(program(), path, *size, scene.drc, preferences().threads, open_page=True)
            )
        except UserError as error:
            self.report({"ERROR"}, f"DRC: {error}")
            return {"CANCELLED"}
        return {"FINISHED"}


def stop_browser():
    child, DRC_OT_show_in_browser.child = DRC_OT_show_in_browser.child, None
    if child is not None:
        child.stop(grace=1)


def export_entry(self, _context):
    self.layout.operator(DRC_OT_export.bl_idname, text="DRC/pbrt (.pbrt)")


CLASSES = (DRC_OT_export, DRC_OT_show_in_browser, DRC_PT_sampling, DRC_PT_paths, DRC_PT_motion_blur, DRC_PT_export)


def register():
    atexit.register(stop_browser)
    for made in CLASSES:
        bpy.utils.register_class(made)
    bpy.types.TOPBAR_MT_file_export.append(export_entry)


def unregister():
    atexit.unregister(stop_browser)
    stop_browser()
    if not bpy.app.background:
        from .viewport import close_all

        close_all()
    bpy.types.TOPBAR_MT_file_export.remove(export_entry)
    for made in reversed(CLASSES):
        bpy.utils.unregister_class(made)
