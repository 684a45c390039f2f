"""Blender's spaces and pbrt's.

World space is Blender's own: z is up, units are Blender's. A Blender camera looks along its -z, a pbrt camera along its
+z, with x to the right and y up in both, so that pbrt's camera space is left-handed.
"""

import numpy as np


def rigid(matrix):
    """A camera's matrix without its scale, which Blender ignores. Raises ValueError if an axis of it is nothing."""
    m = np.array(matrix, dtype=float)
    scale = np.linalg.norm(m[:3, :3], axis=0)
    if not (np.isfinite(m).all() and scale.all()):
        raise ValueError("the camera has a scale of zero, or a place or scale that is no number")
    m[:3, :3] /= scale
    return m


def world_to_camera(matrix):
    """matrix: from Blender's camera space to world space."""
    return np.diag([1.0, 1.0, -1.0, 1.0]) @ np.linalg.inv(rigid(matrix))


def world_to_panorama(matrix):
    """The same for DRC's spherical camera, whose picture begins at its +x, goes on to its +z and has its -x in the
    middle; Blender's has the camera's direction in the middle, and goes from left to right."""
    to_panorama = np.array([[0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1]], dtype=float)
    return to_panorama @ np.linalg.inv(rigid(matrix))
