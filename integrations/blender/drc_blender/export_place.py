"""Where scenes are exported to, and with which settings."""

import os
import tempfile

import bpy

from .export.scene import Settings

_private = None  # the folder of this process, where Blender has none


def exporter_settings(drc):
    return Settings(
        max_depth=drc.max_bounces,
        filter_kind=drc.filter_kind,
        filter_width=drc.filter_width,
        texture_side=drc.texture_side,
        atlas_side=2 * drc.texture_side,
        world_side=drc.world_side,
    )


def private_folder():
    """A folder of this process alone, which goes with it."""
    global _private
    if bpy.app.tempdir:
        return bpy.app.tempdir
    if _private is None:
        _private = tempfile.TemporaryDirectory(prefix="drc-")
    return _private.name


def export_folder(scene, use):
    """For what is exported once and then rendered. use: "render" or "browser", which may run at once."""
    chosen = bpy.path.abspath(scene.drc.keep_files) if scene.drc.keep_files else ""
    return os.path.join(chosen or private_folder(), f"drc-{use}")


def viewport_folder():
    """A new folder for one viewport: each writes its scene again and again, and removes the meshes that have gone."""
    return tempfile.TemporaryDirectory(prefix="drc-view-", dir=private_folder())
