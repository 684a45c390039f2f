"""Meshes, textures and files for the scripts that make scenes: Python's standard library only.

Shapes are added to `meshes`, one mesh a material. Metres, z up.
"""
import math
import struct
import zlib


# ---- vectors -------------------------------------------------------------------------------------------------------
def add(a, b): return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
def sub(a, b): return (a[0] - b[0], a[1] - b[1], a[2] - b[2])
def mul(a, s): return (a[0] * s, a[1] * s, a[2] * s)
def cross(a, b): return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(a[0] ** 2 + a[1] ** 2 + a[2] ** 2)
    return mul(a, 1 / length) if length > 1e-12 else (0.0, 0.0, 1.0)


# ---- meshes: one a material ----------------------------------------------------------------------------------------
class Mesh:
    def __init__(self):
        self.vertices = []  # x y z nx ny nz u v
        self.faces = []


meshes = {}


class Frame:
    """Where a thing stands: turned about z, then moved."""

    def __init__(self, at=(0, 0, 0), turn=0.0):
        self.at, self.c, self.s = at, math.cos(math.radians(turn)), math.sin(math.radians(turn))

    def vector(self, v):
        return (self.c * v[0] - self.s * v[1], self.s * v[0] + self.c * v[1], v[2])

    def point(self, p):
        return add(self.at, self.vector(p))


ROOM = Frame()


def emit(material, vertices, faces, frame):
    mesh = meshes.setdefault(material, Mesh())
    first = len(mesh.vertices)
    for p, n, uv in vertices:
        mesh.vertices.append(frame.point(p) + frame.vector(n) + tuple(uv))
    mesh.faces += [(a + first, b + first, c + first) for a, b, c in faces]


def quad(material, a, b, c, d, frame=ROOM, unit_uv=False):
    """Anticlockwise as seen from its front."""
    n = unit(cross(sub(b, a), sub(c, a)))
    w = 1 if unit_uv else math.dist(a, b)
    h = 1 if unit_uv else math.dist(a, d)
    emit(material, [(a, n, (0, 0)), (b, n, (w, 0)), (c, n, (w, h)), (d, n, (0, h))], [(0, 1, 2), (0, 2, 3)], frame)


def box(material, lo, hi, frame=ROOM):
    (x0, y0, z0), (x1, y1, z1) = lo, hi
    quad(material, (x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1), frame)
    quad(material, (x0, y1, z0), (x1, y1, z0), (x1, y0, z0), (x0, y0, z0), frame)
    quad(material, (x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1), frame)
    quad(material, (x1, y1, z0), (x0, y1, z0), (x0, y1, z1), (x1, y1, z1), frame)
    quad(material, (x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1), frame)
    quad(material, (x0, y1, z0), (x0, y0, z0), (x0, y0, z1), (x0, y1, z1), frame)


def rounded_box(material, lo, hi, radius, frame=ROOM, steps=3):
    """A box whose edges are quarter cylinders: a sphere, pulled apart along the axes."""
    center = mul(add(lo, hi), 0.5)
    half = mul(sub(hi, lo), 0.5)
    r = min(radius, *half)
    inner = tuple(h - r for h in half)

    def vertex(theta, phi, quadrant, upper):
        n = (math.cos(theta) * math.cos(phi), math.cos(theta) * math.sin(phi), math.sin(theta))
        sign = (1 if quadrant in (0, 3) else -1, 1 if quadrant in (0, 1) else -1, 1 if upper else -1)
        p = tuple(center[i] + sign[i] * inner[i] + r * n[i] for i in range(3))
        # Planar texture, from the side the normal points to most.
        axis = max(range(3), key=lambda i: abs(n[i]))
        uv = (p[1], p[2]) if axis == 0 else (p[0], p[2]) if axis == 1 else (p[0], p[1])
        return p, n, uv

    columns = [(q, (q + i / steps) * math.pi / 2) for q in range(4) for i in range(steps + 1)]
    rows = [(False, -math.pi / 2 + i / steps * math.pi / 2) for i in range(steps + 1)]
    rows += [(True, i / steps * math.pi / 2) for i in range(steps + 1)]
    vertices = [vertex(theta, phi, q, up) for up, theta in rows for q, phi in columns]
    count = len(columns)
    faces = []
    for i in range(len(rows) - 1):
        for j in range(count):
            a, b = i * count + j, i * count + (j + 1) % count
            c, d = b + count, a + count
            for f in ((a, b, c), (a, c, d)):
                p = [vertices[k][0] for k in f]
                area = cross(sub(p[1], p[0]), sub(p[2], p[0]))
                if sum(x * x for x in area) > 1e-18:
                    faces.append(f)
    top, s = (len(rows) - 1) * count, steps + 1
    faces += [(top, top + s, top + 2 * s), (top, top + 2 * s, top + 3 * s), (2 * s, s, 0), (3 * s, 2 * s, 0)]
    emit(material, vertices, faces, frame)


def grid(material, surface, rows, columns, frame=ROOM):
    """A smooth surface p(u, v); its front is where u x v points."""
    eps = 1e-4
    vertices = []
    for i in range(rows + 1):
        for j in range(columns + 1):
            u, v = j / columns, i / rows
            un, vn = min(max(u, 2 * eps), 1 - 2 * eps), min(max(v, 2 * eps), 1 - 2 * eps)
            du = sub(surface(un + eps, vn), surface(un - eps, vn))
            dv = sub(surface(un, vn + eps), surface(un, vn - eps))
            vertices.append((surface(u, v), unit(cross(unit(du), unit(dv))), (u, v)))
    faces = []
    for i in range(rows):
        for j in range(columns):
            a, b = i * (columns + 1) + j, i * (columns + 1) + j + 1
            c, d = b + columns + 1, a + columns + 1
            for f in ((a, b, c), (a, c, d)):
                p = [vertices[k][0] for k in f]
                area = cross(sub(p[1], p[0]), sub(p[2], p[0]))
                if sum(x * x for x in area) > 1e-18:
                    faces.append(f)
    emit(material, vertices, faces, frame)


def pillow(material, width, height, thickness, frame, lean=0.0, rows=14):
    """Stands on its edge at the origin, front towards -y, leaning back by `lean` radians. Corners stick out a little."""
    def half(side):
        def surface(u, v):
            s, t = math.sin((u - 0.5) * math.pi), math.sin((v - 0.5) * math.pi)
            swell = math.sqrt(max(0, (1 - s ** 4) * (1 - t ** 4)))
            x = s * width / 2 * (1 - 0.06 * (1 - t * t))
            z = height / 2 + t * height / 2 * (1 - 0.06 * (1 - s * s))
            y = side * thickness / 2 * swell
            return (x, y * math.cos(lean) + z * math.sin(lean), z * math.cos(lean) - y * math.sin(lean))
        return surface if side < 0 else lambda u, v: surface(1 - u, v)
    grid(material, half(-1), rows, rows, frame)
    grid(material, half(1), rows, rows, frame)


def lathe(material, profile, frame, segments=40, smooth=True):
    """Revolves (radius, height) points about z. Up along the outside, down along the inside."""
    count = len(profile)
    normals = []
    for i in range(count - 1):
        dr, dz = profile[i + 1][0] - profile[i][0], profile[i + 1][1] - profile[i][1]
        length = math.hypot(dr, dz) or 1
        normals.append((dz / length, -dr / length))
    for i in range(count - 1):
        ends = []
        for k, other in ((i, i - 1), (i + 1, i + 1)):
            n = normals[i]
            if smooth and 0 <= other < count - 1 and normals[other][0] * n[0] + normals[other][1] * n[1] > 0.6:
                n = (n[0] + normals[other][0], n[1] + normals[other][1])
            ends.append((profile[k], n))
        vertices, faces = [], []
        for (r, z), (nr, nz) in ends:
            for j in range(segments + 1):
                phi = 2 * math.pi * (j % segments) / segments
                c, s = math.cos(phi), math.sin(phi)
                vertices.append(((r * c, r * s, z), unit((nr * c, nr * s, nz)), (j / segments, z)))
        for j in range(segments):
            a, b, c, d = j, j + 1, j + segments + 2, j + segments + 1
            if ends[0][0][0] > 0:
                faces.append((a, b, d))
            if ends[1][0][0] > 0:
                faces.append((b, c, d))
        emit(material, vertices, faces, frame)


def rod(material, a, b, radius, frame=ROOM, segments=14):
    axis = unit(sub(b, a))
    side = unit(cross(axis, (0, 0, 1) if abs(axis[2]) < 0.9 else (1, 0, 0)))
    up = cross(axis, side)

    def surface(u, v):
        c, s = radius * math.cos(2 * math.pi * u), radius * math.sin(2 * math.pi * u)
        return add(add(a, mul(sub(b, a), v)), add(mul(side, c), mul(up, s)))
    grid(material, surface, 1, segments, frame)


# ---- textures ------------------------------------------------------------------------------------------------------
def write_png(path, size, shade):
    """shade(u, v) gives sRGB values from 0 to 1; v = 0 is the top row."""
    rows = bytearray()
    for y in range(size):
        rows.append(0)
        for x in range(size):
            rows += bytes(min(255, max(0, round(255 * c))) for c in shade((x + 0.5) / size, (y + 0.5) / size))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    with open(path, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)) +
                chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


def value_noise(lattice):
    """noise(x, y, period): smooth, from 0 to 1, by the 4096 numbers of `lattice`."""
    def noise(x, y, period):
        def at(i, j):
            return lattice[((i % period) * 61 + (j % period) * 17 + period) % 4096]
        i, j = math.floor(x), math.floor(y)
        s, t = x - i, y - j
        s, t = s * s * (3 - 2 * s), t * t * (3 - 2 * t)
        return (at(i, j) * (1 - s) + at(i + 1, j) * s) * (1 - t) + (at(i, j + 1) * (1 - s) + at(i + 1, j + 1) * s) * t
    return noise


# ---- files ---------------------------------------------------------------------------------------------------------
def rgb(name, r, g, b): return f'"rgb {name}" [ {r} {g} {b} ]'


def matte(r, g, b): return '"string type" [ "matte" ] ' + rgb("Kd", r, g, b)


def glossy(kd, roughness, ks=0.05):
    return (f'"string type" [ "substrate" ] {kd} {rgb("Ks", ks, ks, ks)} "float uroughness" [ {roughness} ] '
            f'"float vroughness" [ {roughness} ] "bool remaproughness" [ "false" ]')


def write_ply(path, mesh, with_uv=True):
    """Without texture coordinates a mesh is a quarter smaller; one that has no texture needs none."""
    names = ("x", "y", "z", "nx", "ny", "nz", "u", "v")[:8 if with_uv else 6]
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(mesh.vertices)}\n" +
              "".join(f"property float {n}\n" for n in names) +
              f"element face {len(mesh.faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    with open(path, "wb") as f:
        f.write(header.encode())
        for v in mesh.vertices:
            f.write(struct.pack(f"<{len(names)}f", *v[:len(names)]))
        for face in mesh.faces:
            f.write(struct.pack("<B3i", 3, *face))
