"""Meshes in PLY files."""
import array
import struct
import sys

from pbrt_geometry import Mesh
from pbrt_tokens import Refused

PLY_TYPES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H",
             "uint16": "H", "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f",
             "double": "d", "float64": "d"}
UV_NAMES = (("u", "v"), ("s", "t"), ("texture_u", "texture_v"), ("texture_s", "texture_t"))


def read_ply(path):
    """The mesh of a PLY file, ASCII or binary. Polygons become fans of triangles."""
    with open(path, "rb") as f:
        data = f.read()
    end = data.find(b"end_header")
    if not data.startswith(b"ply") or end < 0:
        raise Refused(None, f"{path}: is not a PLY file")
    body = data.index(b"\n", end) + 1
    kind, elements = None, []
    for line in data[:end].decode("ascii", "replace").splitlines():
        words = line.split()
        if words[:1] == ["format"]:
            kind = words[1]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            types = words[2:-1] if words[1] == "list" else words[1:-1]
            if not elements or any(t not in PLY_TYPES for t in types):
                raise Refused(None, f"{path}: its property '{line}' is not understood")
            elements[-1][2].append((words[-1], words[1] == "list", [PLY_TYPES[t] for t in types]))
    try:
        values = PlyText(data[body:]) if kind == "ascii" else PlyBinary(data, body, "<" if "little" in kind else ">")
        mesh = Mesh(array.array("d"), array.array("i"))
        for name, count, properties in elements:
            if name == "vertex":
                read_vertices(mesh, values.rows(count, properties), properties)
            elif name == "face":
                read_faces(mesh, values.rows(count, properties), properties)
            else:
                for _ in values.rows(count, properties):
                    pass
    except (struct.error, StopIteration, ValueError, TypeError) as error:
        raise Refused(None, f"{path}: the PLY file is cut short or broken ({error})") from error
    vertices = len(mesh.positions) // 3
    if any(not 0 <= i < vertices for i in mesh.indices):
        raise Refused(None, f"{path}: a face names a vertex that the PLY file does not have")
    return mesh


class PlyBinary:
    def __init__(self, data, at, order):
        self.data, self.at, self.order = data, at, order

    def rows(self, count, properties):
        if not any(is_list for _, is_list, _ in properties):
            row = struct.Struct(self.order + "".join(types[0] for _, _, types in properties))
            at, self.at = self.at, self.at + count * row.size
            yield from row.iter_unpack(memoryview(self.data)[at:self.at])
            if len(self.data) < self.at:
                raise ValueError("data end too early")
            return
        for _ in range(count):
            values = []
            for _, is_list, types in properties:
                size = 1
                if is_list:
                    size = self.read(types[0], 1)[0]
                got = self.read(types[-1], size)
                values.append(got if is_list else got[0])
            yield values

    def read(self, kind, count):
        row = f"{self.order}{count}{kind}"
        got = struct.unpack_from(row, self.data, self.at)
        self.at += struct.calcsize(row)
        return got


class PlyText:
    def __init__(self, data):
        self.words = iter(data.split())

    def rows(self, count, properties):
        for _ in range(count):
            values = []
            for _, is_list, types in properties:
                size = int(self.word()) if is_list else 1
                convert = float if types[-1] in "fd" else int
                got = [convert(self.word()) for _ in range(size)]
                values.append(got if is_list else got[0])
            yield values

    def word(self):
        word = next(self.words, None)
        if word is None:
            raise ValueError("data end too early")
        return word


def read_vertices(mesh, rows, properties):
    at = {name: i for i, (name, is_list, _) in enumerate(properties) if not is_list}
    x, y, z = (at.get(name) for name in "xyz")
    if None in (x, y, z):
        raise ValueError("its vertices have no x, y and z")
    normal = [at[name] for name in ("nx", "ny", "nz")] if all(name in at for name in ("nx", "ny", "nz")) else None
    uv = next(([at[a], at[b]] for a, b in UV_NAMES if a in at and b in at), None)
    mesh.normals = array.array("d") if normal else None
    mesh.uvs = array.array("d") if uv else None
    for row in rows:
        mesh.positions.extend((row[x], row[y], row[z]))
        if normal:
            mesh.normals.extend(row[i] for i in normal)
        if uv:
            mesh.uvs.extend(row[i] for i in uv)


def read_faces(mesh, rows, properties):
    at = next((i for i, (name, is_list, _) in enumerate(properties)
               if is_list and name in ("vertex_indices", "vertex_index")), None)
    if at is None:
        raise ValueError("its faces have no vertex_indices")
    for row in rows:
        corners = row[at]
        for i in range(2, len(corners)):
            mesh.indices.extend((corners[0], corners[i - 1], corners[i]))


def write_ply(mesh, path):
    """Binary, of this machine's byte order, in single precision."""
    names = ["x", "y", "z"] + (["nx", "ny", "nz"] if mesh.normals is not None else [])
    names += ["u", "v"] if mesh.uvs is not None else []
    count = len(mesh.positions) // 3
    header = [f"ply\nformat binary_{sys.byteorder}_endian 1.0\nelement vertex {count}\n"]
    header += [f"property float {name}\n" for name in names]
    header += [f"element face {len(mesh.indices) // 3}\nproperty list uchar int vertex_indices\nend_header\n"]
    with open(path, "wb") as f:
        f.write("".join(header).encode())
        row = struct.Struct(f"={len(names)}f")
        p, n, uv = mesh.positions, mesh.normals, mesh.uvs
        for i in range(count):
            values = list(p[3 * i:3 * i + 3])
            if n is not None:
                values.extend(n[3 * i:3 * i + 3])
            if uv is not None:
                values.extend(uv[2 * i:2 * i + 2])
            f.write(row.pack(*values))
        face = struct.Struct("=B3i")
        for t in range(0, len(mesh.indices), 3):
            f.write(face.pack(3, *mesh.indices[t:t + 3]))
