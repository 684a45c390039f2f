"""A scene in world space and in terms that renderers share, as pbrt_subset reads it."""
import array

import pbrt_geometry as geometry
from drc_export import refuse
from ply_file import read_ply


class ImageTexture:
    """A picture on a surface: st = uv * scale + offset, with (0, 0) at the picture's lower left corner."""

    def __init__(self, path, srgb, wrap, uv_scale, uv_offset, pos):
        self.path, self.srgb, self.wrap = path, srgb, wrap  # wrap: "repeat", "black" or "clamp"
        self.uv_scale, self.uv_offset, self.pos = uv_scale, uv_offset, pos


class Material:
    """kind "matte": Kd (an RGB or an ImageTexture). "mirror": Kr (the same). "glass", smooth: Kr, Kt (RGB), eta.
    "metal": eta, k (RGB), alpha of its Trowbridge-Reitz distribution."""

    def __init__(self, kind, values, pos):
        self.kind, self.values, self.pos = kind, values, pos

    def __getattr__(self, name):
        try:
            return self.values[name]
        except KeyError:
            raise AttributeError(name) from None

    def textured(self):
        return any(isinstance(v, ImageTexture) for v in self.values.values())


class Shape:
    """kind "mesh" (ply: what `drc export` says of its file), "sphere" (radius) or "disk" (radius, height); `matrix`
    takes the latter two to the world. `radiance` is None where it is no light."""

    def __init__(self, kind, matrix, reverse, material, radiance, two_sided, pos, **values):
        self.kind, self.matrix, self.reverse, self.material, self.pos = kind, matrix, reverse, material, pos
        self.radiance, self.two_sided = radiance, two_sided
        self.ply, self.radius, self.height = values.get("ply"), values.get("radius"), values.get("height", 0.0)

    def is_complete(self):
        """Whether it is a mesh whose file has all that the material needs."""
        return self.kind == "mesh" and (self.ply["uvs"] or not self.material.textured())

    def mesh(self):
        """In world space, wound as pbrt's normals are."""
        self.check_sides()
        if self.kind == "mesh":
            mesh = read_ply(self.ply["file"])
        else:
            mesh = self.round_mesh()
        return mesh.with_uvs() if self.material.textured() else mesh

    def round_mesh(self):
        is_sphere = self.kind == "sphere"
        mesh = geometry.sphere_mesh(self.radius) if is_sphere else geometry.disk_mesh(self.radius, self.height)
        mirrored = geometry.determinant(self.matrix) < 0
        mesh = mesh.transformed(self.matrix).oriented(self.reverse != mirrored and not is_sphere)
        if is_sphere and self.reverse:
            inwards = array.array("d", (-x for x in mesh.normals))
            mesh = geometry.Mesh(mesh.positions, mesh.indices, inwards, mesh.uvs).oriented(False)
        return mesh

    def one_sided(self):
        return (self.radiance is not None and not self.two_sided) or self.material.kind == "glass"

    def check_sides(self):
        # pbrt-v3 itself is of two minds here: a light's samples leave on one side, rays see it on the other.
        mirrored = geometry.determinant(self.matrix) < 0
        unclear = mirrored if self.kind != "mesh" else self.ply["normals"] and (mirrored or self.reverse)
        if self.one_sided() and unclear:
            refuse(self.pos, "which side is the outer one of a light or glass with normals that is mirrored or "
                             "reversed is not matched")


class Light:
    """kind "infinite": radiance (RGB) and, if not None, image (path) with the lookup directions' matrix; "point":
    intensity, position; "distant": radiance, direction towards the light."""

    def __init__(self, kind, pos, **values):
        self.kind, self.pos = kind, pos
        self.__dict__.update(values)


class Camera:
    """Axes of unit length in the world: x to the right, y up, z forward, right-handed as (x, y, -z). Where pbrt's
    picture is the mirror image of what such a camera sees, `mirrored` says so: it must be flipped left to right."""

    def __init__(self, to_world, fov, pos):
        self.fov, self.pos = fov, pos  # fov: of the shorter side, in degrees
        if geometry.uniform_scale(to_world) is None:
            refuse(pos, "a camera that stretches the scene unevenly is not matched")
        self.position = geometry.column(to_world, 3)
        self.x, self.y, self.z = (geometry.normalize(geometry.column(to_world, j)) for j in range(3))
        self.mirrored = geometry.determinant(to_world) > 0
        if self.mirrored:
            self.x = tuple(-v for v in self.x)


class PixelFilter:
    def __init__(self, kind, radius, values, pos):
        self.kind, self.radius, self.values, self.pos = kind, radius, values, pos


class Scene:
    def __init__(self):
        self.camera, self.filter = None, PixelFilter("box", 0.5, {}, None)
        self.shapes, self.lights = [], []
