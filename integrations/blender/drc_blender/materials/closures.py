"""Shader nodes as a weighted sum of closures: what scatters, what emits, what lets light pass."""

from dataclasses import dataclass, field

import numpy as np

from .expressions import ONE, ZERO, Expression, as_colour, as_number, combined, constant, product, rest, total
from .node_links import Socket, active_output


@dataclass
class Closure:
    """A DRC material, its parameters (declared name: expression), and the share of the surface that it has."""

    kind: str
    parameters: dict
    weight: Expression = field(default_factory=lambda: ONE)
    relief: object = None  # what its Normal input is linked to
    place: tuple = ()


@dataclass
class Surface:
    scattering: list = field(default_factory=list)  # Closures
    emission: list = field(default_factory=list)  # expressions of radiance
    passing: list = field(default_factory=list)  # (share, colour) of what passes straight through


PRINCIPLED = {  # parameter: sockets, of which the first that a version has counts
    "rgb basecolor": ("Base Color",),
    "float metallic": ("Metallic",),
    "float roughness": ("Roughness",),
    "float diffuseroughness": ("Diffuse Roughness",),
    "float ior": ("IOR",),
    "float specularlevel": ("Specular IOR Level",),
    "rgb speculartint": ("Specular Tint",),
    "float anisotropic": ("Anisotropic",),
    "float anisotropicrotation": ("Anisotropic Rotation",),
    "float transmission": ("Transmission Weight",),
    "float coat": ("Coat Weight",),
    "float coatroughness": ("Coat Roughness",),
    "float coatior": ("Coat IOR",),
    "rgb coattint": ("Coat Tint",),
    "float sheen": ("Sheen Weight",),
    "float sheenroughness": ("Sheen Roughness",),
    "rgb sheentint": ("Sheen Tint",),
    "float subsurface": ("Subsurface Weight",),
}
PRINCIPLED_ABSENT = (("Thin Film Thickness", 0.0), ("Transmission Dispersion Scale", 0.0))
SCHLICK_AT_82 = (6 / 7) ** 5  # 1 - cos to the fifth, at the angle at which F82 tints


def constant_reflectance_tint(colour):
    """The tint near the horizon with which Schlick's curve, as bent by F82, keeps the colour that it has head-on."""
    return combined(lambda c: np.where(c > 0, c / np.maximum(c + (1 - c) * SCHLICK_AT_82, 1e-6), 0), colour)


EUMELANIN, PHEOMELANIN = (0.506, 0.841, 1.653), (0.343, 0.733, 1.924)  # absorption, by its amount


def absorption_of_melanin(melanin, redness, tint, roughness):
    """Of Blender's Principled Hair; roughness: the radial one. A tint absorbs as hair of this colour would (Chiang et
    al. 2016, equation 9)."""
    amount = -np.log(np.maximum(1 - melanin, 1e-4))
    pigments = amount * (1 - redness) * np.array(EUMELANIN) + amount * redness * np.array(PHEOMELANIN)
    terms = (5.969, -0.215, 2.532, -10.73, 5.574, 0.245)
    across = sum(term * roughness**power for power, term in enumerate(terms))
    return pigments + (np.log(np.clip(tint, 1e-5, 1)) / across) ** 2


class ClosureReader:
    """Reads the surface of a material or world tree; the reader's report gets what has no equal."""

    def __init__(self, reader):
        self.reader = reader
        self.kinds = {
            "BSDF_PRINCIPLED": self._principled,
            "BSDF_DIFFUSE": self._diffuse,
            "BSDF_GLOSSY": self._glossy,
            "BSDF_ANISOTROPIC": self._glossy,
            "BSDF_METALLIC": self._metallic,
            "BSDF_GLASS": self._glass,
            "BSDF_REFRACTION": self._refraction,
            "BSDF_TRANSPARENT": self._transparent,
            "BSDF_TRANSLUCENT": self._translucent,
            "EMISSION": self._emission,
            "BACKGROUND": self._emission,
            "BSDF_SHEEN": self._sheen,
            "BSDF_HAIR": self._hair,
            "BSDF_HAIR_PRINCIPLED": self._principled_hair,
            "SUBSURFACE_SCATTERING": self._subsurface,
            "HOLDOUT": self._holdout,
        }

    def surface(self, tree):
        return self.surface_of(active_output(tree, "OUTPUT_MATERIAL"))

    def background(self, tree):
        return self.surface_of(active_output(tree, "OUTPUT_WORLD"))

    def surface_of(self, output):
        """output: an output node, or None, which has no surface."""
        made = Surface()
        if output is not None:
            self._add(Socket(output.inputs["Surface"]), ONE, made)
        return made

    def _add(self, socket, weight, made):
        at = socket.source()
        if not at.socket.is_output:
            return  # nothing is linked: black
        if weight.is_always(0):
            return
        node = at.node
        if node.type == "MIX_SHADER":
            # Both shader inputs are called Shader: by position.
            factor, first, second = at.inputs()[:3]
            if self._pair(factor.source(), first.source(), second.source(), weight, made):
                return
            share = combined(lambda f: np.clip(f, 0, 1), as_number(self.reader.value(factor)))
            self._add(first, product(weight, rest(share)), made)
            self._add(second, product(weight, share), made)
        elif node.type == "ADD_SHADER":
            for part in at.inputs()[:2]:
                self._add(part, weight, made)
        elif node.type in self.kinds:
            self.kinds[node.type](at, weight, made)
        elif at.socket.type == "SHADER":
            self.reader.unsupported(at, f"the node {node.bl_label} has no equal; it is grey and diffuse")
            made.scattering.append(Closure("diffuse", {"rgb reflectance": constant(0.5, 0.5, 0.5)}, weight))
        else:  # a colour where a shader is expected is an emission
            made.emission.append(product(weight, as_colour(self.reader.value(socket))))

    def _value(self, at, name):
        return self.reader.value(at.input(name))

    def _closure(self, at, kind, parameters, weight, normal="Normal"):
        relief = at.input(normal)
        if relief is not None and not relief.source().socket.is_output:
            relief = None
        return Closure(kind, parameters, weight, relief.source() if relief is not None else None)

    # Pairs that are one material

    def _pair(self, factor, first, second, weight, made):
        """Adds two shaders that are mixed by how much a surface reflects, if they are a material that is known."""
        ior = self._reflecting_ior(factor)
        kinds = [s.node.type if s.socket.is_output else "" for s in (first, second)]
        if ior is None or kinds[1] not in ("BSDF_GLOSSY", "BSDF_ANISOTROPIC"):
            return False
        if kinds[0] == "BSDF_DIFFUSE":
            parameters = {
                "rgb basecolor": self._value(first, "Color"),
                "float roughness": self._value(second, "Roughness"),
                "rgb speculartint": self._value(second, "Color"),
                "float ior": ior,
            }
        elif kinds[0] == "BSDF_REFRACTION":
            parameters = self._glass_parameters(first, self._value(second, "Color"))
        else:
            return False
        made.scattering.append(self._closure(first, "principled", parameters, weight))
        return True

    def _reflecting_ior(self, factor):
        """Of a surface that reflects as much as this node says; None if it says something else."""
        if not factor.socket.is_output:
            return None
        if factor.node.type == "FRESNEL":
            return self._value(factor, "IOR")
        if factor.node.type == "LAYER_WEIGHT" and factor.socket.name == "Fresnel":
            return combined(lambda b: 1 / np.maximum(1 - np.clip(b, 0, 1), 1e-5), self._value(factor, "Blend"))
        return None

    # Single nodes

    def _principled(self, at, weight, made):
        parameters = {}
        for declared, names in PRINCIPLED.items():
            socket = next((s for s in map(at.input, names) if s is not None), None)
            if socket is not None:
                parameters[declared] = self.reader.value(socket)
        for name, neutral in PRINCIPLED_ABSENT:
            socket = at.input(name)
            if socket is not None and not self.reader.value(socket).is_always(neutral):
                self.reader.unsupported(at, f"{name} has no equal; it is left out")
        thin = at.input("Thin Wall")
        if thin is not None and self.reader.value(thin).is_always(1):
            parameters["bool thinwall"] = True
        subsurface = parameters.get("float subsurface")
        if subsurface is not None and not subsurface.is_always(0):
            self.reader.unsupported(at, "light does not spread below surfaces; it is diffuse there and then")
        alpha = combined(lambda a: np.clip(a, 0, 1), self._value(at, "Alpha"))
        if not alpha.is_always(1):
            made.passing.append((product(weight, rest(alpha)), constant(1.0, 1.0, 1.0)))
            weight = product(weight, alpha)
        strength = self._value(at, "Emission Strength")
        emission = product(strength, self._value(at, "Emission Color"))
        if not (emission.is_constant and not np.any(emission.constant())):
            made.emission.append(product(weight, as_colour(emission)))
        made.scattering.append(self._closure(at, "principled", parameters, weight))

    def _diffuse(self, at, weight, made):
        parameters = {"rgb reflectance": self._value(at, "Color")}
        roughness = self._value(at, "Roughness")
        if not roughness.is_always(0):
            parameters["float diffuseroughness"] = roughness
        made.scattering.append(self._closure(at, "diffuse", parameters, weight))

    def _glossy(self, at, weight, made):
        colour = self._value(at, "Color")
        parameters = {
            "rgb basecolor": colour,
            "float metallic": ONE,
            "float roughness": self._value(at, "Roughness"),
            "rgb speculartint": constant_reflectance_tint(colour),
        }
        self._anisotropy(at, parameters)
        if getattr(at.node, "distribution", "GGX") in ("BECKMANN", "ASHIKHMIN_SHIRLEY"):
            self.reader.unsupported(at, f"the distribution {at.node.distribution} has no equal; it is GGX")
        made.scattering.append(self._closure(at, "principled", parameters, weight))

    def _anisotropy(self, at, parameters):
        for declared, name in (("float anisotropic", "Anisotropy"), ("float anisotropicrotation", "Rotation")):
            if at.input(name) is not None:
                parameters[declared] = self._value(at, name)

    def _metallic(self, at, weight, made):
        parameters = {
            "rgb basecolor": self._value(at, "Base Color"),
            "float metallic": ONE,
            "float roughness": self._value(at, "Roughness"),
            "rgb speculartint": self._value(at, "Edge Tint"),
        }
        if at.node.fresnel_type != "F82":

            def head_on(n, k):
                return ((n - 1) ** 2 + k * k) / ((n + 1) ** 2 + k * k)

            def at_82(n, k):  # unpolarised, at a cosine of 1/7
                c, t = 1 / 7, n * n + k * k
                s = (t * c * c - 2 * n * c + 1) / (t * c * c + 2 * n * c + 1)
                p = (t - 2 * n * c + c * c) / (t + 2 * n * c + c * c)
                return (s + p) / 2

            n, k = (as_colour(self._value(at, name)) for name in ("IOR", "Extinction"))
            base, edge = combined(head_on, n, k), combined(at_82, n, k)
            parameters["rgb basecolor"] = base
            parameters["rgb speculartint"] = combined(
                lambda b, e: np.clip(e / (b + (1 - b) * SCHLICK_AT_82), 0, 1), base, edge
            )
        self._anisotropy(at, parameters)
        made.scattering.append(self._closure(at, "principled", parameters, weight))

    def _glass(self, at, weight, made):
        made.scattering.append(
            self._closure(at, "principled", self._glass_parameters(at, self._value(at, "Color")), weight)
        )

    def _glass_parameters(self, at, reflected):
        """reflected: the colour of what is reflected."""
        return {
            # The principled glass tints by the root of its colour at each surface, Glass by the colour itself.
            "rgb basecolor": combined(lambda c: np.clip(c, 0, 1) ** 2, self._value(at, "Color")),
            "rgb reflectiontint": reflected,
            "float transmission": ONE,
            "float roughness": self._value(at, "Roughness"),
            "float ior": self._value(at, "IOR"),
        }

    def _refraction(self, at, weight, made):
        self.reader.unsupported(at, "a surface that refracts without reflecting has no equal; it is glass")
        self._glass(at, weight, made)

    def _transparent(self, at, weight, made):
        made.passing.append((weight, as_colour(self._value(at, "Color"))))

    def _translucent(self, at, weight, made):
        made.scattering.append(
            self._closure(
                at,
                "diffusetransmission",
                {"rgb reflectance": constant(0.0, 0.0, 0.0), "rgb transmittance": self._value(at, "Color")},
                weight,
            )
        )

    def _emission(self, at, weight, made):
        made.emission.append(product(weight, product(self._value(at, "Strength"), as_colour(self._value(at, "Color")))))

    def _sheen(self, at, weight, made):
        made.scattering.append(
            self._closure(
                at,
                "principled",
                {
                    "rgb basecolor": constant(0.0, 0.0, 0.0),
                    "float specularlevel": ZERO,
                    "float sheen": ONE,
                    "rgb sheentint": self._value(at, "Color"),
                    "float sheenroughness": self._value(at, "Roughness"),
                },
                weight,
            )
        )

    def _hair(self, at, weight, made):
        self.reader.unsupported(at, "the Hair BSDF is that of Principled Hair of the same colour")
        parameters = {"rgb reflectance": self._value(at, "Color")}
        made.scattering.append(Closure("hair", parameters, weight))

    def _principled_hair(self, at, weight, made):
        if getattr(at.node, "model", "CHIANG") != "CHIANG":
            self.reader.unsupported(at, "hair of the model Huang has no equal; it is that of Chiang")
        parameters = {
            "float eta": self._value(at, "IOR"),
            "float beta_m": self._value(at, "Roughness"),
            "float beta_n": self._value(at, "Radial Roughness"),
            "float alpha": combined(np.degrees, self._value(at, "Offset")),
        }
        if at.node.parametrization == "ABSORPTION":
            parameters["rgb sigma_a"] = self._value(at, "Absorption Coefficient")
        elif at.node.parametrization == "COLOR":
            parameters["rgb reflectance"] = self._value(at, "Color")
        else:
            parameters["rgb sigma_a"] = combined(
                absorption_of_melanin,
                *(self._value(at, n) for n in ("Melanin", "Melanin Redness", "Tint", "Radial Roughness")),
            )
        made.scattering.append(Closure("hair", parameters, weight))

    def _subsurface(self, at, weight, made):
        self.reader.unsupported(at, "light does not spread below surfaces; it is diffuse there and then")
        made.scattering.append(self._closure(at, "diffuse", {"rgb reflectance": self._value(at, "Color")}, weight))

    def _holdout(self, at, weight, made):
        self.reader.unsupported(at, "holdouts have no equal; the surface is black")
        made.scattering.append(Closure("diffuse", {"rgb reflectance": constant(0.0, 0.0, 0.0)}, weight))


def emitted(surface):
    return total([as_colour(e) for e in surface.emission])
