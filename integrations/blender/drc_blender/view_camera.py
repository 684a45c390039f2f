"""What Blender's viewport sees, in the terms of `drc view`."""

from dataclasses import dataclass, replace

import numpy as np


@dataclass(frozen=True)
class View:
    """to_world: 4 x 4 rows, from Blender's camera space (along -z) to world space; window: as of camera_maths; near: the
    distance from which on things are seen, negative in the orthographic views of a viewport, which see behind the eye;
    radius, focus: of the thin lens, and the distance in focus.
    """

    to_world: tuple
    window: tuple
    orthographic: bool
    near: float = 0.0
    radius: float = 0.0
    focus: float = 1e6

    def matrix(self):
        return np.array(self.to_world)

    def eye_look_up(self, origin=(0, 0, 0)):
        """In the renderer's world space, whose origin may be elsewhere."""
        m = self.matrix()
        eye = m[:3, 3] - np.asarray(origin, dtype=float)
        return eye, eye - m[:3, 2], m[:3, 1]

    def before(self, sphere):
        """The same picture from an eye that all of the scene is in front of, for a renderer that does not see behind
        it. sphere: centre and radius of all that is seen."""
        if not self.orthographic or self.near >= 0:
            return self
        m, (centre, radius) = self.matrix(), sphere
        back = min(-self.near, np.dot(np.asarray(centre) - m[:3, 3], m[:3, 2]) + 1.01 * radius)
        if back <= 0:
            return self
        m[:3, 3] += back * m[:3, 2]
        return replace(
            self, to_world=tuple(map(tuple, m)), near=self.near + float(back), focus=self.focus + float(back)
        )

    def as_camera(self, origin=(0, 0, 0)):
        """In the terms of `drc view`'s request of this name."""
        eye, look, up = self.eye_look_up(origin)
        lens = {
            "orthographic": self.orthographic,
            "window": list(self.window),
            "radius": self.radius,
            "focalDistance": self.focus,
        }
        return {"eye": list(eye), "look": list(look), "up": list(up), "lens": lens}


def is_view(view_matrix, projection):
    """Whether these matrices show anything; see view_of."""
    matrices = np.array(view_matrix, dtype=float), np.array(projection, dtype=float)
    return all(np.isfinite(m).all() for m in matrices) and abs(np.linalg.det(matrices[0])) > 1e-30


def view_of(view_matrix, projection, depth_of_field=(0.0, 1e6)):
    """view_matrix: from world space to camera space; projection: OpenGL's window matrix. Both rows, as Blender has them.
    depth_of_field: radius of the lens, distance in focus."""
    to_world = np.linalg.inv(np.array(view_matrix, dtype=float))
    to_world[:3, :3] /= np.linalg.norm(to_world[:3, :3], axis=0)
    p = np.array(projection, dtype=float)
    orthographic = p[3, 3] != 0
    edges = []
    for axis in (0, 1):
        # On the plane at distance 1, or anywhere along the axis of an orthographic view.
        shift = -p[axis, 3] if orthographic else p[axis, 2]
        edges += [(-1 + shift) / p[axis, axis], (1 + shift) / p[axis, axis]]
    near = (1 + p[2, 3]) / p[2, 2] if orthographic else 0.0
    return View(tuple(map(tuple, to_world)), tuple(edges), bool(orthographic), float(near), *depth_of_field)


def frame_size(width, height, most=None):
    """Whole pixels within what the renderer accepts; most: the longer side."""
    scale = min(1.0, (most or 4096) / max(width, height))
    return tuple(min(4096, max(16, int(round(n * scale)))) for n in (width, height))
