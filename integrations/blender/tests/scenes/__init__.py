"""The scenes that are compared with Cycles: FEATURES, by their names."""

from stage import FEATURES

from . import (
    cameras,
    geometry,
    hair,
    lamps,
    light_paths,
    materials,
    rooms,
    textures,
    visibility,
    worlds,
)  # each adds its scenes

__all__ = [
    "FEATURES",
    "cameras",
    "geometry",
    "hair",
    "lamps",
    "light_paths",
    "materials",
    "rooms",
    "textures",
    "visibility",
    "worlds",
]
