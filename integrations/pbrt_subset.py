"""Reads the part of pbrt-v3's scenes that other renderers can match, for the adapters of this folder.

read_scene(path, folder, drc) gives a Scene in world space and in terms that renderers share. Everything else raises
Refused, which names the file and the line and says what is not matched; nothing is left out or replaced without a word.
What one renderer cannot match its adapter refuses, by refuse(). Materials and textures count where a shape uses them.

Not read, since whoever runs the comparison decides: Integrator, Sampler, Accelerator, the film's size and file name.
"""
import math
import os

import pbrt_geometry as geometry
from drc_export import Params, find_drc, read_document, refuse
from pbrt_scene import Camera, ImageTexture, Light, Material, PixelFilter, Scene, Shape

BLACK = (0.0, 0.0, 0.0)
SRGB_FILES = (".png", ".tga")  # of which pbrt-v3 takes the values for sRGB
IMAGE_FILES = SRGB_FILES + (".exr", ".pfm")


def read_scene(path, folder, drc=None):
    """folder: for the scene's meshes, to be kept while the Scene is used. drc: find_drc() says which is meant."""
    document, warnings = read_document(find_drc(drc), path, folder)
    scene = Reader(document).scene
    # Whatever drc warns of it does not read as it is written, and others might.
    if warnings:
        place, what = warnings[0].split("warning: ", 1)
        refuse(place.removesuffix(": "), what)
    return scene


class Reader:
    def __init__(self, document):
        self.document, self.scene = document, Scene()
        self.materials, self.textures = {}, {}  # by index: shapes share what they share in the file
        self.whole()
        self.camera(document["camera"])
        self.film(document["film"])
        self.pixel_filter(document["filter"])
        for light in document["lights"]:
            self.light(light)
        for shape in document["shapes"]:
            self.shape(shape)

    def whole(self):
        """What is not matched wherever it stands."""
        for medium in self.document["media"]:
            refuse(medium["at"], "a participating medium is not matched")
        for thing in self.document["objects"] + self.document["instances"]:
            refuse(thing["at"], "an object with instances is not matched")
        if self.document["dialect"] != "pbrt-v3":
            refuse(self.document["dialect_at"], f"a scene of {self.document['dialect']} is not matched")

    def matrix(self, directive):
        if "to_world_end" in directive:
            refuse(directive["at"], f'the "{directive["type"]}" moves, which is not matched')
        return tuple(tuple(row) for row in directive["to_world"])

    # Settings

    def camera(self, d):
        if d["type"] != "perspective":
            refuse(d["at"], f'the camera "{d["type"]}" is not matched')
        p = Params("the camera", d)
        fov = p.float("fov", 90.0)
        if p.float("lensradius", 0.0) != 0:
            refuse(p.place("lensradius"), "a camera with a lens is not matched")
        p.ignore("focaldistance", "shutteropen", "shutterclose")
        p.done()
        self.scene.camera = Camera(self.matrix(d), fov, d["at"])

    def film(self, d):
        if d["type"] != "image":
            refuse(d["at"], f'the film "{d["type"]}" is not matched')
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
        if d["type"] not in FILTERS:
            refuse(d["at"], f'the pixel filter "{d["type"]}" is not known')
        radius, defaults = FILTERS[d["type"]]
        p = Params(f'the pixel filter "{d["type"]}"', d)
        x, y = p.float("xwidth", radius), p.float("ywidth", radius)
        if x != y:
            refuse(d["at"], "a pixel filter that is not as wide as high is not matched")
        values = {name: p.float(name, default) for name, default in defaults.items()}
        p.done()
        self.scene.filter = PixelFilter(d["type"], x, values, d["at"])

    # Materials and textures

    def material(self, index):
        if index not in self.materials:
            d = self.document["materials"][index]
            kind = d["type"]
            if kind not in MATERIALS:
                refuse(d["at"], f'the material "{kind}" is not matched')
            p = Params(f'the material "{kind}"', d)
            p.ignore("type")
            self.materials[index] = Material(*MATERIALS[kind](self, p), d["at"])
            p.done()
        return self.materials[index]

    def color(self, p, name, default):
        """A constant RGB or an ImageTexture."""
        param = p.left.get(name)
        if param is None or param["type"] != "texture":
            return tuple(max(0.0, v) for v in p.rgb(name, default))
        (texture,) = p.take(name, ("texture",), count=1)
        if "spectrum_texture" not in param:
            refuse(param["at"], f'the texture "{texture}" is not known')
        return self.texture(param["spectrum_texture"])

    def constant(self, p, name, default):
        value = self.color(p, name, default)
        if isinstance(value, ImageTexture):
            refuse(p.place(name), f'a texture as "{name}" of {p.owner} is not matched')
        return value

    def texture(self, index):
        if index in self.textures:
            return self.textures[index]
        d = self.document["textures"][index]
        kind = d["type"]
        p = Params(f'the texture "{kind}"', d)
        if kind == "constant":
            found = p.rgb("value", (1.0, 1.0, 1.0))
        elif kind == "imagemap":
            found = self.image_texture(p)
        else:
            refuse(d["at"], f'the texture "{kind}" is not matched')
        p.done()
        self.textures[index] = found
        return found

    def image_texture(self, p):
        path = self.image(p, "filename")
        if p.string("mapping", "uv") != "uv":
            refuse(p.place("mapping"), "a texture's mapping other than uv is not matched")
        if p.float("scale", 1.0) != 1:
            refuse(p.place("scale"), "a texture's scale is not matched")
        wrap = p.string("wrap", "repeat")
        if wrap not in ("repeat", "black", "clamp"):
            refuse(p.place("wrap"), f'the wrap mode "{wrap}" is not known')
        p.ignore("trilinear", "maxanisotropy")
        return ImageTexture(path, p.bool("gamma", path.lower().endswith(SRGB_FILES)), wrap,
                            (p.float("uscale", 1.0), p.float("vscale", 1.0)),
                            (p.float("udelta", 0.0), p.float("vdelta", 0.0)), p.directive["at"])

    def image(self, p, name):
        path = p.string(name, "")
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
                refuse(p.directive["at"], f'the material "metal" is not matched without "rgb {name}"')
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

    def area_light(self, index):
        """Its radiance, None if it has none, and whether it shines on both sides."""
        if index is None:
            return None, False
        d = self.document["area_lights"][index]
        if d["type"] not in ("diffuse", "area"):
            refuse(d["at"], f'the area light "{d["type"]}" is not matched')
        p = Params("the area light", d)
        radiance = times(p.rgb("L", (1.0, 1.0, 1.0)), p.rgb("scale", (1.0, 1.0, 1.0)))
        two_sided = p.bool("twosided", False)
        p.ignore("samples", "nsamples")
        p.done()
        return None if radiance == BLACK else radiance, two_sided

    def light(self, d):
        kind = d["type"]
        p = Params(f'the light "{kind}"', d)
        size = p.rgb("scale", (1.0, 1.0, 1.0))
        m = self.matrix(d)
        if kind == "infinite":
            values = {"radiance": times(p.rgb("L", (1.0, 1.0, 1.0)), size), "matrix": m, "image": None}
            if "mapname" in p.left:
                values["image"] = self.image(p, "mapname")
                if geometry.uniform_scale(m) is None:
                    refuse(d["at"], "an infinite light that is stretched unevenly is not matched")
            p.ignore("samples", "nsamples")
        elif kind == "point":
            values = {"intensity": times(p.rgb("I", (1.0, 1.0, 1.0)), size),
                      "position": geometry.transform_point(m, p.point("from", (0.0, 0.0, 0.0)))}
        elif kind == "distant":
            towards = geometry.subtract(p.point("from", (0.0, 0.0, 0.0)), p.point("to", (0.0, 0.0, 1.0)))
            values = {"radiance": times(p.rgb("L", (1.0, 1.0, 1.0)), size),
                      "direction": geometry.normalize(geometry.transform_vector(m, towards))}
        else:
            refuse(d["at"], f'the light "{kind}" is not matched')
        p.done()
        self.scene.lights.append(Light(kind, d["at"], **values))

    def shape(self, d):
        kind = d["type"]
        if kind not in SHAPES:
            refuse(d["at"], f'the shape "{kind}" is not matched')
        material = self.material(d["material"])
        p = Params(f'the shape "{kind}"', d)
        values = SHAPES[kind](self, p)
        p.done()
        radiance, two_sided = self.area_light(d["area_light"])
        if values["kind"] == "mesh" and values["ply"]["triangles"] == 0:
            return
        self.scene.shapes.append(Shape(values.pop("kind"), self.matrix(d), d["reverse_orientation"], material,
                                       radiance, two_sided, d["at"], **values))

    def mesh(self, p):
        p.ignore("P", "indices", "N", "uv", "st", "filename")
        return {"kind": "mesh", "ply": p.directive["mesh"]}

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
            refuse(p.directive["at"], "a part of a disk is not matched")
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
SHAPES = {"trianglemesh": Reader.mesh, "plymesh": Reader.mesh, "sphere": Reader.sphere, "disk": Reader.disk}
