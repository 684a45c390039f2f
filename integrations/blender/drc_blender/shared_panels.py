"""Blender's own panels that are shown for DRC too: those of whatever renders, and of Eevee's those that say nothing of
Eevee alone."""

import bpy

from .engine import DrcRenderEngine

ANY = "BLENDER_RENDER"  # panels for this engine, which Blender has no more, are for those of add-ons
OF_EEVEE = {
    "DATA_PT_camera_dof",
    "DATA_PT_camera_dof_aperture",
    "EEVEE_MATERIAL_PT_context_material",
    "EEVEE_MATERIAL_PT_displacement",
    "EEVEE_MATERIAL_PT_surface",
    "EEVEE_WORLD_PT_surface",
}
# Of what DRC does not do, or has its own panel for, by the beginnings of their names.
FOREIGN = (
    "DATA_PT_light",
    "DATA_PT_preview",
    "DATA_PT_spot",
    "EEVEE_MATERIAL_PT_viewport_settings",
    "MATERIAL_PT_freestyle",
    "RENDER_PT_freestyle",
    "RENDER_PT_gpencil",
    "RENDER_PT_grease_pencil",
    "RENDER_PT_output_views",
    "RENDER_PT_simplify_greasepencil",
    "RENDER_PT_stereoscopy",
    "TEXTURE_PT_preview",
    "VIEWLAYER_PT_freestyle",
    "WORLD_PT_preview",
)


def shared_panels():
    for panel in bpy.types.Panel.__subclasses__():
        engines = getattr(panel, "COMPAT_ENGINES", ())
        if panel.__name__ in OF_EEVEE or (ANY in engines and not panel.__name__.startswith(FOREIGN)):
            yield panel


def register():
    for panel in shared_panels():
        panel.COMPAT_ENGINES.add(DrcRenderEngine.bl_idname)


def unregister():
    for panel in shared_panels():
        panel.COMPAT_ENGINES.discard(DrcRenderEngine.bl_idname)
