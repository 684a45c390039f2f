"""Triangle meshes as binary little-endian PLY files, with one numpy array written as it is."""

import numpy as np


def ply_bytes(positions, triangles, normals=None, uvs=None):
    """positions: n x 3; triangles: m x 3 indices; normals: n x 3; uvs: n x 2."""
    columns = [("x", "y", "z")]
    arrays = [positions]
    if normals is not None:
        columns.append(("nx", "ny", "nz"))
        arrays.append(normals)
    if uvs is not None:
        columns.append(("u", "v"))
        arrays.append(uvs)
    vertices = np.hstack([np.asarray(a, dtype="<f4") for a in arrays])
    faces = np.empty(len(triangles), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, triangles
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}"]
    header += [f"property float {name}" for names in columns for name in names]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header", ""]
    return "\n".join(header).encode() + vertices.tobytes() + faces.tobytes()


def merged_corners(keys):
    """Corners with equal keys become one vertex.

    keys: n rows of 32-bit values. Returns (first, vertex): the corner that each vertex is taken from, and the vertex of
    each corner. Rows are compared by a hash of 64 bits, and then with what they are merged with.
    """
    rows = np.ascontiguousarray(keys).view(np.uint32)
    mixed = np.zeros(len(rows), dtype=np.uint64)
    with np.errstate(over="ignore"):
        for column in rows.T:
            mixed = (mixed ^ column) * np.uint64(0x9E3779B97F4A7C15)
            mixed ^= mixed >> np.uint64(29)
    _, first, vertex = np.unique(mixed, return_index=True, return_inverse=True)
    vertex = vertex.reshape(-1)
    if not np.array_equal(rows[first][vertex], rows):  # two rows with the same hash
        first = vertex = np.arange(len(rows))
    return first, vertex
