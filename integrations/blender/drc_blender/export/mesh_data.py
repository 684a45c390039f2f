"""The arrays of an evaluated mesh, and the PLY files of its parts, one for each material."""

from dataclasses import dataclass, field

import numpy as np

from .cache import digest
from .ply import merged_corners, ply_bytes


def _read(collection, name, count, width, dtype=np.float32):
    values = np.empty(count * width, dtype=dtype)
    if count:
        collection.foreach_get(name, values)
    return values.reshape(count, width) if width > 1 else values


@dataclass
class MeshData:
    """Corners are Blender's loops: a vertex as a face has it."""

    positions: np.ndarray  # vertices x 3
    corner_vertex: np.ndarray  # corners
    triangles: np.ndarray  # triangles x 3 corners
    material: np.ndarray  # of each triangle
    normals: np.ndarray = None  # per vertex or per corner; None: flat
    normals_of_corners: bool = False
    uvs: dict = field(default_factory=dict)  # corners x 2, by name; "" is the map that is rendered
    colours: dict = field(default_factory=dict)  # corners x 3, by name
    key: str = ""

    @staticmethod
    def of(mesh):
        mesh.calc_loop_triangles()
        vertices, corners, triangles = len(mesh.vertices), len(mesh.loops), len(mesh.loop_triangles)
        made = MeshData(
            positions=_read(mesh.attributes["position"].data, "vector", vertices, 3),
            corner_vertex=_read(mesh.loops, "vertex_index", corners, 1, np.int32),
            triangles=_read(mesh.loop_triangles, "loops", triangles, 3, np.int32),
            material=_read(mesh.loop_triangles, "material_index", triangles, 1, np.int32),
        )
        if mesh.normals_domain == "POINT":
            made.normals = _read(mesh.vertex_normals, "vector", vertices, 3)
        elif mesh.normals_domain == "CORNER":
            made.normals, made.normals_of_corners = _read(mesh.corner_normals, "vector", corners, 3), True
        for layer in mesh.uv_layers:
            made.uvs[layer.name] = _read(layer.uv, "vector", corners, 2)
            if layer.active_render:
                made.uvs[""] = made.uvs[layer.name]
        for attribute in mesh.color_attributes:
            made._read_colours(attribute)
        made.key = digest(
            made.positions,
            made.corner_vertex,
            made.triangles,
            made.material,
            "flat" if made.normals is None else made.normals,
            sorted(made.uvs),
            *made.uvs.values(),
            sorted(made.colours),
            *made.colours.values()
        )
        return made

    def _read_colours(self, attribute):
        values = np.empty(len(attribute.data) * 4, dtype=np.float32)
        attribute.data.foreach_get("color", values)
        values = values.reshape(-1, 4)[:, :3]
        self.colours[attribute.name] = values[self.corner_vertex] if attribute.domain == "POINT" else values

    def part(self, index, count):
        """The triangles of a material slot; those of slots beyond the last of `count` have the last one."""
        return self.triangles[np.minimum(self.material, max(count - 1, 0)) == index]

    def face_normals(self, triangles):
        a, b, c = (self.positions[self.corner_vertex[triangles[:, i]]] for i in range(3))
        n = np.cross(b - a, c - a)
        return n / np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-30)

    def corner_normals(self, triangles):
        """Of each of the triangles' corners, one after the other: n x 3 x 3."""
        if self.normals is None:
            return np.repeat(self.face_normals(triangles)[:, None], 3, axis=1)
        return self.normals[triangles if self.normals_of_corners else self.corner_vertex[triangles]]

    def ply(self, triangles, uv_name):
        """Vertices that agree in all that is written are one."""
        corners, vertex = triangles.reshape(-1), self.corner_vertex[triangles.reshape(-1)]
        uv = self.uvs.get(uv_name, self.uvs.get("")) if uv_name is not None else None
        keys = [vertex.astype(np.int32)[:, None].view(np.uint32)]
        if uv is not None:
            uv = uv[corners]
            keys.append(np.ascontiguousarray(uv).view(np.uint32))
        normals = None
        if self.normals is not None:
            normals = self.normals[corners if self.normals_of_corners else vertex]
            if self.normals_of_corners:
                keys.append(np.ascontiguousarray(normals).view(np.uint32))
        first, index = merged_corners(np.hstack(keys))
        return ply_bytes(
            self.positions[vertex[first]],
            index.reshape(-1, 3),
            None if normals is None else normals[first],
            None if uv is None else uv[first],
        )

    def atlas_ply(self, triangles, uvs):
        """With texture coordinates of its own: n x 3 x 2."""
        normals = None if self.normals is None else self.corner_normals(triangles).reshape(-1, 3)
        return ply_bytes(
            self.positions[self.corner_vertex[triangles.reshape(-1)]],
            np.arange(3 * len(triangles), dtype=np.int32).reshape(-1, 3),
            normals,
            uvs.reshape(-1, 2),
        )
