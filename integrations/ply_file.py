"""Meshes in PLY files: those that `drc export` writes are read, and the adapters' own written in the same form."""
import array
import struct
import sys

from pbrt_geometry import Mesh

FACE = struct.Struct("<B3i")
VERTEX = ["x", "y", "z"]
NORMAL = ["nx", "ny", "nz"]
UV = ["u", "v"]


def header(names, vertices, faces):
    lines = ["ply", "format binary_little_endian 1.0", f"element vertex {vertices}"]
    lines += [f"property float {name}" for name in names]
    lines += [f"element face {faces}", "property list uchar int vertex_indices", "end_header"]
    return "".join(line + "\n" for line in lines).encode()


def little_endian(values):
    if sys.byteorder == "big":
        values.byteswap()
    return values


def read_ply(path):
    """The mesh of a file that has the header that write_ply would write."""
    with open(path, "rb") as f:
        data = f.read()
    body = data.index(b"end_header\n") + len(b"end_header\n")
    words = data[:body].decode("ascii").split()
    names = [words[i + 2] for i, word in enumerate(words) if word == "property" and words[i + 1] == "float"]
    counts = [int(words[i + 2]) for i, word in enumerate(words) if word == "element"]
    if data[:body] != header(names, *counts):
        raise ValueError(f"{path}: is not a PLY file of the form that drc export writes")
    end = body + 4 * counts[0] * len(names)
    values = little_endian(array.array("f", data[body:end]))

    def columns(wanted):
        if wanted[0] not in names:
            return None
        at, found = names.index(wanted[0]), array.array("f", bytes(4 * counts[0] * len(wanted)))
        for k in range(len(wanted)):
            found[k::len(wanted)] = values[at + k::len(names)]
        return found

    indices = array.array("i")
    for _, a, b, c in FACE.iter_unpack(data[end:end + counts[1] * FACE.size]):
        indices.extend((a, b, c))
    return Mesh(columns(VERTEX), indices, columns(NORMAL), columns(UV))


def write_ply(mesh, path):
    parts = [(VERTEX, mesh.positions), (NORMAL, mesh.normals), (UV, mesh.uvs)]
    parts = [(names, values) for names, values in parts if values is not None]
    names = [name for part, _ in parts for name in part]
    count = len(mesh.positions) // 3
    rows, at = array.array("f", bytes(4 * count * len(names))), 0
    for part, values in parts:
        for k in range(len(part)):
            rows[at + k::len(names)] = array.array("f", values[k::len(part)])
        at += len(part)
    with open(path, "wb") as f:
        f.write(header(names, count, len(mesh.indices) // 3))
        little_endian(rows).tofile(f)
        for t in range(0, len(mesh.indices), 3):
            f.write(FACE.pack(3, *mesh.indices[t:t + 3]))
