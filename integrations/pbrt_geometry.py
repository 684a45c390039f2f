"""Transformations and meshes of scenes. Standard library only; matrices are tuples of four rows."""
import array
import math

IDENTITY = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0))


def multiply(a, b):
    return tuple(tuple(sum(row[k] * b[k][j] for k in range(4)) for j in range(4)) for row in a)


def scale(x, y, z):
    return ((x, 0.0, 0.0, 0.0), (0.0, y, 0.0, 0.0), (0.0, 0.0, z, 0.0), (0.0, 0.0, 0.0, 1.0))


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def length(a):
    return math.sqrt(dot(a, a))


def normalize(a):
    size = length(a)
    if not size > 0:
        raise ValueError("a direction has no length")
    return tuple(x / size for x in a)


def column(m, j):
    return (m[0][j], m[1][j], m[2][j])


def determinant(m):
    return dot(column(m, 0), cross(column(m, 1), column(m, 2)))


def is_affine(m):
    return m[3] == (0.0, 0.0, 0.0, 1.0)


def inverse(m):
    """Of an affine matrix. ValueError if it is flat."""
    a, b, c = column(m, 0), column(m, 1), column(m, 2)
    d = determinant(m)
    if d == 0 or not is_affine(m):
        raise ValueError("the transformation cannot be inverted")
    rows = [tuple(x / d for x in r) for r in (cross(b, c), cross(c, a), cross(a, b))]
    t = column(m, 3)
    return tuple(r + (-dot(r, t),) for r in rows) + ((0.0, 0.0, 0.0, 1.0),)


def transform_point(m, p):
    return tuple(r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3] for r in m[:3])


def transform_vector(m, v):
    return tuple(r[0] * v[0] + r[1] * v[1] + r[2] * v[2] for r in m[:3])


def uniform_scale(m, tolerance=1e-4):
    """By how much a transformation without shear stretches everything; None if it is another kind."""
    axes = [column(m, j) for j in range(3)]
    sizes = [length(a) for a in axes]
    if not is_affine(m) or not min(sizes) > 0 or max(sizes) > (1 + tolerance) * min(sizes):
        return None
    if any(abs(dot(axes[i], axes[j])) > tolerance * sizes[i] * sizes[j] for i, j in ((0, 1), (0, 2), (1, 2))):
        return None
    return sum(sizes) / 3


class Mesh:
    """Triangles in flat arrays: positions, and, where the file has them, normals and texture coordinates."""

    def __init__(self, positions, indices, normals=None, uvs=None):
        self.positions, self.indices, self.normals, self.uvs = positions, indices, normals, uvs

    def transformed(self, m):
        if m == IDENTITY:
            return Mesh(self.positions, self.indices, self.normals, self.uvs)
        back = inverse(m)
        p, n = self.positions, self.normals
        points = array.array("d")
        for i in range(0, len(p), 3):
            points.extend(transform_point(m, p[i:i + 3]))
        normals = None
        if n is not None:
            normals = array.array("d")
            rows = [column(back, j) for j in range(3)]  # the inverse's transpose
            for i in range(0, len(n), 3):
                v = tuple(dot(r, n[i:i + 3]) for r in rows)
                size = length(v) or 1.0
                normals.extend(x / size for x in v)
        return Mesh(points, self.indices, normals, self.uvs)

    def oriented(self, flip):
        """The same surface, wound so that (p1 - p0) x (p2 - p0) is on the side of pbrt's normal: that of the vertices'
        normals, or, if there are none, that of the winding, turned round where `flip` says so."""
        p, n, indices = self.positions, self.normals, self.indices
        if n is None and not flip:
            return self
        turned = array.array("i")
        for t in range(0, len(indices), 3):
            a, b, c = indices[t:t + 3]
            turn = flip
            if n is not None:
                pa = p[3 * a:3 * a + 3]
                g = cross(subtract(p[3 * b:3 * b + 3], pa), subtract(p[3 * c:3 * c + 3], pa))
                turn = sum(g[k] * (n[3 * a + k] + n[3 * b + k] + n[3 * c + k]) for k in range(3)) < 0
            turned.extend((a, c, b) if turn else (a, b, c))
        return Mesh(p, turned, n, self.uvs)

    def with_uvs(self):
        """As pbrt completes a mesh that has none: (0,0), (1,0) and (1,1) at the corners of every triangle."""
        if self.uvs is not None:
            return self
        def corners(values):
            return array.array("d", (values[3 * i + k] for i in self.indices for k in range(3)))
        count = len(self.indices)
        return Mesh(corners(self.positions), array.array("i", range(count)),
                    None if self.normals is None else corners(self.normals),
                    array.array("d", [0, 0, 1, 0, 1, 1] * (count // 3)))

    def normals_follow_faces(self, cosine=0.9999):
        """Whether the vertices' normals are those of the faces, so that shading is flat."""
        p, n, indices = self.positions, self.normals, self.indices
        if n is None:
            return True
        for t in range(0, len(indices), 3):
            a, b, c = (slice(3 * i, 3 * i + 3) for i in indices[t:t + 3])
            g = cross(subtract(p[b], p[a]), subtract(p[c], p[a]))
            size = length(g)
            if size > 0 and any(abs(dot(g, n[v])) < cosine * size * length(n[v]) for v in (a, b, c)):
                return False
        return True


def sphere_mesh(radius, around=128, down=64):
    """A sphere of pbrt as a mesh with the sphere's own normals and texture coordinates, of the sphere's own area."""
    points, normals, uvs = array.array("d"), array.array("d"), array.array("d")
    for j in range(down + 1):
        theta = math.pi * (1 - j / down)
        for i in range(around + 1):
            phi = 2 * math.pi * (i % around) / around
            n = (math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta))
            normals.extend(n)
            points.extend(radius * x for x in n)
            uvs.extend((i / around, j / down))
    indices = array.array("i")
    for j in range(down):
        for i in range(around):
            a = j * (around + 1) + i
            b = a + around + 1
            if j > 0:
                indices.extend((a, a + 1, b + 1))
            if j < down - 1:
                indices.extend((a, b + 1, b))
    mesh = Mesh(points, indices, normals, uvs)
    # Chords cut corners: a little larger, the mesh has the sphere's area.
    grow = math.sqrt(4 * math.pi * radius * radius / area(mesh))
    mesh.positions = array.array("d", (grow * x for x in points))
    return mesh


def disk_mesh(radius, height, around=256):
    """A disk of pbrt as a mesh of the disk's own area. The centre is in every triangle anew: u is any there."""
    grow = math.sqrt(2 * math.pi / (around * math.sin(2 * math.pi / around)))
    points, uvs = array.array("d"), array.array("d")
    for i in range(around):
        points.extend((0, 0, height))
        for phi in (2 * math.pi * i / around, 2 * math.pi * ((i + 1) % around) / around):
            points.extend((grow * radius * math.cos(phi), grow * radius * math.sin(phi), height))
        uvs.extend(((i + 0.5) / around, 1, i / around, 0, (i + 1) / around, 0))
    return Mesh(points, array.array("i", range(3 * around)), None, uvs)


def area(mesh):
    p, total = mesh.positions, 0.0
    for t in range(0, len(mesh.indices), 3):
        a, b, c = (p[3 * i:3 * i + 3] for i in mesh.indices[t:t + 3])
        total += length(cross(subtract(b, a), subtract(c, a))) / 2
    return total
