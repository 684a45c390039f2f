"""Registers all parts of the add-on with Blender."""

from . import engine, properties, ui

PARTS = (properties, engine, ui)


def register():
    for part in PARTS:
        part.register()


def unregister():
    for part in reversed(PARTS):
        part.unregister()
