"""Reads the part of pbrt-v3's scene format that other renderers can match, for the adapters of this folder.

read_scene(path) gives a Scene in world space and in terms that renderers share. Everything else raises Refused, which
names the file and the line and says what is not matched; nothing is left out or replaced without a word. What one
renderer cannot match its adapter refuses, by refuse(). Materials and textures count where a shape uses them.

Not read, since whoever runs the comparison decides: Integrator, Sampler, Accelerator, the film's size and file name.
"""
import math
import os

import pbrt_geometry as geometry
from pbrt_ply import read_ply
from pbrt_scene import Camera, ImageTexture, Light, Material, PixelFilter, Scene, Shape
from pbrt_tokens import Params, Source, directives, find_file, refuse

BLACK = (0.0, 0.0, 0.0)
SRGB_FILES = (".png", ".tga")  # of which pbrt-v3 takes the values for sRGB
IMAGE_FILES = SRGB_FILES + (".exr", ".pfm")


class State:
    def __init__(self):
        self.matrix = geometry.IDENTITY
        self.reverse = False
        self.material = ("matte", None)
        self.light = None

    def copy(self):
        other = State()
        other.__dict__.update(self.__dict__)
        return other


def read_scene(path):
    return Reader(path).scene


class Reader:
    def __init__(self, path):
        self.scene = Scene()
        self.main = Source(path)
        self.state, self.stack = State(), []
        self.materials, self.textures, self.systems = {}, {}, {}
        self.known = {}  # by directive: shapes share what they share in the file
        self.in_world = False
        self.read(self.main)
        if self.scene.camera is None:
            self.scene.camera = Camera(geometry.IDENTITY, 90.0, None)

    def read(self, source, depth=0):
        for d in directives(source):
            handler = HANDLERS.get(d.name)
            if handler is None:
                refuse(d.pos, f"the directive {d.name} is not matched")
            try:
                if handler is Reader.include:
                    handler(self, d, depth)
                else:
                    handler(self, d)
            except ValueError as error:
                refuse(d.pos, str(error))

    def include(self, d, depth):
        (name,) = d.strings(1)
        path = find_file(name, d.token.source, self.main)
        if path is None:
            refuse(d.pos, f'the included file "{name}" is not found')
        if depth > 20:
            refuse(d.pos, "files include each other without end")
        self.read(Source(path), depth + 1)

    # Transformations

    def concatenate(self, m):
        self.state.matrix = geometry.multiply(self.state.matrix, m)

    def transform(self, d):
        self.state.matrix = geometry.from_file_order(d.numbers(16))

    def coordinate_system(self, d):
        self.systems[d.strings(1)[0]] = self.state.matrix

    def use_coordinate_system(self, d):
        (name,) = d.strings(1)
        if name not in self.systems:
            refuse(d.pos, f'the coordinate system "{name}" is not known')
        self.state.matrix = self.systems[name]

    def begin(self, d):
        self.stack.append((d.name, self.state.copy()))

    def end(self, d):
        if not self.stack or self.stack[-1][0] != d.name.replace("End", "Begin"):
            refuse(d.pos, f"{d.name} ends nothing")
        kept = self.stack.pop()[1]
        if d.name == "TransformEnd":
            self.state.matrix = kept.matrix
        else:
            self.state = kept

    def world_begin(self, _):
        self.state.matrix = geometry.IDENTITY
        self.systems["world"] = geometry.IDENTITY

    # Settings

    def camera(self, d):
        (kind,) = d.strings(1)
        if kind != "perspective":
            refuse(d.pos, f'the camera "{kind}" is not matched')
        p = Params("the camera", d)
        fov = p.float("fov", 90.0)
        if p.float("lensradius", 0.0) != 0:
            refuse(p.place("lensradius"), "a camera with a lens is not matched")
        p.ignore("focaldistance", "shutteropen", "shutterclose")
        p.done()
        to_world = geometry.inverse(self.state.matrix)
        self.scene.camera = Camera(to_world, fov, d.pos)
        self.systems["camera"] = to_world

    def film(self, d):
        (kind,) = d.strings(1)
        if kind != "image":
            refuse(d.pos, f'the film "{kind}" is not matched')
        p = Params("the film", d)
        p.ignore("xresolution", "yresolution", "filename", "diagonal")
        if p.float("scale", 1.0) != 1:
            refuse(p.place("scale"), "the film's scale is not matched")
        if p.float("maxsampleluminance", math.inf) < 1e30:
            refuse(p.place("maxsampleluminance"), "the film's maxsampleluminance is not matched")
        if list(p.take("cropwindow", ("float",), [0, 1, 0, 1], 4)) != [0, 1, 0, 1]:
            refuse(p.place("cropwindow"), "the film's cropwindow is not matched")
        p.done()

    def pixel_filter(self, d):
        (kind,) = d.strings(1)
        if kind not in FILTERS:
            refuse(d.pos, f'the pixel filter "{kind}" is not known')
        radius, defaults = FILTERS[kind]
        p = Params(f'the pixel filter "{kind}"', d)
        x, y = p.float("xwidth", radius), p.float("ywidth", radius)
        if x != y:
            refuse(d.pos, "a pixel filter that is not as wide as high is not matched")
        values = {name: p.float(name, default) for name, default in defaults.items()}
        p.done()
        self.scene.filter = PixelFilter(kind, x, values, d.pos)

    # Materials and textures

    def texture(self, d):
        name, kind, _ = d.strings(3)
        self.textures[name, "float" if kind == "float" else "spectrum"] = d

    def make_named_material(self, d):
        (name,) = d.strings(1)
        (kind,) = Params("a material", d).take("type", ("string",), [""], 1)
        self.materials[name] = (kind, d)

    def named_material(self, d):
        (name,) = d.strings(1)
        if name not in self.materials:
            refuse(d.pos, f'the material "{name}" is not known')
        self.state.material = self.materials[name]

    def set_material(self, d):
        self.state.material = (d.strings(1)[0], d)

    def material(self):
        kind, d = self.state.material
        if d is None:
            return Material("matte", {"Kd": (0.5, 0.5, 0.5)}, None)
        if d not in self.known:
            if kind not in MATERIALS:
                refuse(d.pos, f'the material "{kind}" is not matched')
            p = Params(f'the material "{kind}"', d)
            p.ignore("type")
            self.known[d] = Material(*MATERIALS[kind](self, p), d.pos)
            p.done()
        return self.known[d]

    def color(self, p, name, default):
        """A constant RGB or an ImageTexture."""
        param = p.left.get(name)
        if param is None or param.kind != "texture":
            return tuple(max(0.0, v) for v in p.rgb(name, default))
        (texture,) = p.take(name, ("texture",), count=1)
        d = self.textures.get((texture, "spectrum"))
        if d is None:
            refuse(param.pos, f'the texture "{texture}" is not known')
        return self.image_texture(d)

    def constant(self, p, name, default):
        value = self.color(p, name, default)
        if isinstance(value, ImageTexture):
            refuse(p.place(name), f'a texture as "{name}" of {p.owner} is not matched')
        return value

    def image_texture(self, d):
        if d in self.known:
            return self.known[d]
        _, _, kind = d.strings(3)
        p = Params(f'the texture "{kind}"', d)
        if kind == "constant":
            found = p.rgb("value", (1.0, 1.0, 1.0))
        elif kind == "imagemap":
            path = self.image(p, "filename")
            if p.string("mapping", "uv") != "uv":
                refuse(p.place("mapping"), "a texture's mapping other than uv is not matched")
            if p.float("scale", 1.0) != 1:
                refuse(p.place("scale"), "a texture's scale is not matched")
            wrap = p.string("wrap", "repeat")
            if wrap not in ("repeat", "black", "clamp"):
                refuse(p.place("wrap"), f'the wrap mode "{wrap}" is not known')
            p.ignore("trilinear", "maxanisotropy")
            found = ImageTexture(path, p.bool("gamma", path.lower().endswith(SRGB_FILES)), wrap,
                                 (p.float("uscale", 1.0), p.float("vscale", 1.0)),
                                 (p.float("udelta", 0.0), p.float("vdelta", 0.0)), d.pos)
        else:
            refuse(d.pos, f'the texture "{kind}" is not matched')
        p.done()
        self.known[d] = found
        return found

    def image(self, p, name):
        value = p.string(name, "")
        path = find_file(value, p.directive.token.source, self.main)
        if path is None:
            refuse(p.place(name), f'the image "{value}" is not found')
        if not path.lower().endswith(IMAGE_FILES):
            refuse(p.place(name), f'an image of the kind "{os.path.splitext(path)[1]}" is not matched')
        return path

    def matte(self, p):
        kd = self.color(p, "Kd", (0.5, 0.5, 0.5))
        if p.float("sigma", 0.0) != 0:
            refuse(p.place("sigma"), "a matte material with a sigma other than 0 (Oren-Nayar) is not matched")
        return "matte", {"Kd": kd}

    def mirror(self, p):
        return "mirror", {"Kr": self.color(p, "Kr", (0.9, 0.9, 0.9))}

    def glass(self, p):
        white = (1.0, 1.0, 1.0)
        kr, kt = self.constant(p, "Kr", white), self.constant(p, "Kt", white)
        eta = p.float("eta", p.float("index", 1.5))
        for name in ("uroughness", "vroughness"):
            if p.float(name, 0.0) != 0:
                refuse(p.place(name), "rough glass is not matched")
        p.ignore("remaproughness")
        return "glass", {"Kr": kr, "Kt": kt, "eta": eta}

    def metal(self, p):
        for name in ("eta", "k"):
            if name not in p.left:
                refuse(p.directive.pos, f'the material "metal" is not matched without "rgb {name}"')
        eta, k = self.constant(p, "eta", None), self.constant(p, "k", None)
        roughness = p.float("roughness", 0.01)
        u, v = p.float("uroughness", roughness), p.float("vroughness", roughness)
        if u != v:
            refuse(p.place("vroughness"), "metal with two roughnesses is not matched")
        return "metal", {"eta": eta, "k": k, "alpha": alpha_of(u, p.bool("remaproughness", True))}

    def uber(self, p):
        kd = self.color(p, "Kd", (0.25, 0.25, 0.25))
        for name, default, matched in (("Ks", 0.25, 0), ("Kr", 0.0, 0), ("Kt", 0.0, 0), ("opacity", 1.0, 1)):
            if self.constant(p, name, (default,) * 3) != (matched,) * 3:
                refuse(p.place(name), f'the material "uber" is only matched with {name} {matched}')
        p.ignore("roughness", "uroughness", "vroughness", "remaproughness", "eta", "index")
        return "matte", {"Kd": kd}

    # Shapes and lights

    def area_light(self, d):
        (kind,) = d.strings(1)
        if kind not in ("diffuse", "area"):
            refuse(d.pos, f'the area light "{kind}" is not matched')
        p = Params("the area light", d)
        radiance = times(p.rgb("L", (1.0, 1.0, 1.0)), p.rgb("scale", (1.0, 1.0, 1.0)))
        two_sided = p.bool("twosided", False)
        p.ignore("samples", "nsamples")
        p.done()
        self.state.light = (radiance, two_sided)

    def light_source(self, d):
        (kind,) = d.strings(1)
        p = Params(f'the light "{kind}"', d)
        size = p.rgb("scale", (1.0, 1.0, 1.0))
        m = self.state.matrix
        if kind == "infinite":
            values = {"radiance": times(p.rgb("L", (1.0, 1.0, 1.0)), size), "matrix": m, "image": None}
            if "mapname" in p.left:
                values["image"] = self.image(p, "mapname")
                if geometry.uniform_scale(m) is None:
                    refuse(d.pos, "an infinite light that is stretched unevenly is not matched")
            p.ignore("samples", "nsamples")
        elif kind == "point":
            values = {"intensity": times(p.rgb("I", (1.0, 1.0, 1.0)), size),
                      "position": geometry.transform_point(m, p.point("from", (0.0, 0.0, 0.0)))}
        elif kind == "distant":
            towards = geometry.subtract(p.point("from", (0.0, 0.0, 0.0)), p.point("to", (0.0, 0.0, 1.0)))
            values = {"radiance": times(p.rgb("L", (1.0, 1.0, 1.0)), size),
                      "direction": geometry.normalize(geometry.transform_vector(m, towards))}
        else:
            refuse(d.pos, f'the light "{kind}" is not matched')
        p.done()
        self.scene.lights.append(Light(kind, d.pos, **values))

    def shape(self, d):
        (kind,) = d.strings(1)
        if kind not in SHAPES:
            refuse(d.pos, f'the shape "{kind}" is not matched')
        material = self.material()
        p = Params(f'the shape "{kind}"', d)
        values = SHAPES[kind](self, p)
        p.done()
        geometry.inverse(self.state.matrix)  # a flat one is refused here, where its line is known
        radiance, two_sided = self.state.light or (None, False)
        if radiance == BLACK:
            radiance = None
        self.scene.shapes.append(Shape(values.pop("kind"), self.state.matrix, self.state.reverse, material, radiance,
                                       two_sided, d.pos, **values))

    def reverse_orientation(self, _):
        self.state.reverse = not self.state.reverse

    def triangle_mesh(self, p):
        points = p.take("P", ("point", "point3"), [])
        indices = [int(i) for i in p.take("indices", ("integer",), [])]
        normals = p.take("N", ("normal", "normal3"))
        uvs = p.take("uv", ("float", "point2")) or p.take("st", ("float", "point2"))
        count = len(points) // 3
        if not points or len(points) % 3 or not indices or len(indices) % 3:
            refuse(p.directive.pos, "a triangle mesh needs points and indices, three numbers each")
        if any(not 0 <= i < count for i in indices):
            refuse(p.place("indices"), "an index names a point that the triangle mesh does not have")
        if (normals and len(normals) != 3 * count) or (uvs and len(uvs) != 2 * count):
            refuse(p.directive.pos, "a triangle mesh needs as many N and uv as P")

        def load():
            return geometry.Mesh(points, indices, normals or None, uvs or None)
        return {"kind": "mesh", "load": load}

    def ply_mesh(self, p):
        name = p.string("filename", "")
        path = find_file(name, p.directive.token.source, self.main)
        if path is None:
            refuse(p.place("filename"), f'the mesh "{name}" is not found')
        if not path.lower().endswith(".ply"):
            refuse(p.place("filename"), f'the mesh "{name}" is not a plain PLY file')
        return {"kind": "mesh", "load": lambda: read_ply(path)}

    def sphere(self, p):
        radius = p.float("radius", 1.0)
        for name, whole in (("zmin", p.float("zmin", -radius) <= -radius), ("zmax", p.float("zmax", radius) >= radius),
                            ("phimax", p.float("phimax", 360.0) >= 360)):
            if not whole:
                refuse(p.place(name), "a part of a sphere is not matched")
        return {"kind": "sphere", "radius": radius}

    def disk(self, p):
        radius, height = p.float("radius", 1.0), p.float("height", 0.0)
        if p.float("innerradius", 0.0) > 0 or p.float("phimax", 360.0) < 360:
            refuse(p.directive.pos, "a part of a disk is not matched")
        return {"kind": "disk", "radius": radius, "height": height}


def times(a, b):
    return tuple(max(0.0, x * y) for x, y in zip(a, b))


def alpha_of(roughness, remapped):
    """Of the Trowbridge-Reitz distribution (PBR 3e, section 8.4)."""
    if not remapped:
        return max(1e-3, roughness)
    x = math.log(max(1e-3, roughness))
    return max(1e-3, 1.62142 + x * (0.819955 + x * (0.1734 + x * (0.0171201 + x * 0.000640711))))


# Kind: the usual radius, and other parameters with their usual values.
FILTERS = {"box": (0.5, {}), "triangle": (2.0, {}), "gaussian": (2.0, {"alpha": 2.0}),
           "mitchell": (2.0, {"B": 1 / 3, "C": 1 / 3}), "sinc": (4.0, {"tau": 3.0})}
MATERIALS = {"matte": Reader.matte, "mirror": Reader.mirror, "glass": Reader.glass, "metal": Reader.metal,
             "uber": Reader.uber}
SHAPES = {"trianglemesh": Reader.triangle_mesh, "plymesh": Reader.ply_mesh, "sphere": Reader.sphere,
          "disk": Reader.disk}


def ignored(_reader, _directive):
    """Of no consequence to what the picture converges to, or decided by whoever runs the comparison."""


HANDLERS = {
    "Accelerator": ignored, "Integrator": ignored, "Sampler": ignored,
    "AreaLightSource": Reader.area_light, "LightSource": Reader.light_source, "Shape": Reader.shape,
    "AttributeBegin": Reader.begin, "AttributeEnd": Reader.end,
    "TransformBegin": Reader.begin, "TransformEnd": Reader.end,
    "Camera": Reader.camera, "Film": Reader.film, "PixelFilter": Reader.pixel_filter,
    "CoordinateSystem": Reader.coordinate_system, "CoordSysTransform": Reader.use_coordinate_system,
    "Identity": lambda r, d: setattr(r.state, "matrix", geometry.IDENTITY),
    "Translate": lambda r, d: r.concatenate(geometry.translate(*d.numbers(3))),
    "Scale": lambda r, d: r.concatenate(geometry.scale(*d.numbers(3))),
    "Rotate": lambda r, d: r.concatenate(geometry.rotate(*d.numbers(4))),
    "LookAt": lambda r, d: r.concatenate(look_at_of(d.numbers(9))),
    "Transform": Reader.transform,
    "ConcatTransform": lambda r, d: r.concatenate(geometry.from_file_order(d.numbers(16))),
    "Include": Reader.include, "ReverseOrientation": Reader.reverse_orientation,
    "Texture": Reader.texture, "Material": Reader.set_material, "MakeNamedMaterial": Reader.make_named_material,
    "NamedMaterial": Reader.named_material, "WorldBegin": Reader.world_begin, "WorldEnd": ignored,
}


def look_at_of(values):
    return geometry.look_at(tuple(values[0:3]), tuple(values[3:6]), tuple(values[6:9]))
