"""Registers all parts of the add-on with Blender."""

from . import engine, light_panel, properties, shared_panels, ui

PARTS = (properties, engine, ui, light_panel, shared_panels)


def register():
    for part in PARTS:
        part.register()


def unregister():
    for part in reversed(PARTS):
        part.unregister()
