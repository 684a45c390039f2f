"""A material as DRC has it: one scattering material or a mix, an alpha, an emission, a relief; all as expressions."""

from dataclasses import dataclass, field

import numpy as np

from .closures import Closure, emitted
from .expressions import (
    ONE,
    SPACE,
    UV,
    ZERO,
    Expression,
    as_colour,
    as_number,
    combined,
    constant,
    product,
    rest,
    total,
)

RELIEF_NODES = ("BUMP", "NORMAL_MAP", "DISPLACEMENT")


@dataclass
class MaterialPlan:
    closures: list  # of Closures; empty: nothing scatters
    shares: list  # of each closure but the first: its share of it and those before, an expression
    alpha: Expression = field(default_factory=lambda: ONE)
    emission: Expression = field(default_factory=lambda: ZERO)
    bump: Expression = None  # a height in world units
    normal_map: Expression = None  # a colour
    shadow_alpha: Expression = None  # instead of alpha, to shadow rays; never more than alpha
    visible_to_camera: bool = True
    visible_to_diffuse: bool = True  # and blocking light

    def expressions(self):
        yield from self.shares
        others = (self.alpha, self.emission, self.bump, self.normal_map, self.shadow_alpha)
        yield from (e for e in others if e is not None)
        for closure in self.closures:
            yield from (v for v in closure.parameters.values() if isinstance(v, Expression))

    @property
    def is_emissive(self):
        return not (self.emission.is_constant and not np.any(self.emission.constant()))

    @property
    def is_invisible(self):
        return self.alpha.is_always(0) and not self.is_emissive

    def map_name(self):
        """The one UV map that all textures need; None if they need several, or other properties of the place."""
        needs = set().union(*(e.needs for e in self.expressions()))
        if self.is_emissive and self.emission.needs:
            return None  # the picture that a light emits cannot be placed
        names = {need[1] for need in needs if need[0] == UV}
        if (SPACE,) in needs or len(names) > 1:
            return None
        return names.pop() if names else ""

    @property
    def is_textured(self):
        return any(e.needs for e in self.expressions())


def plan_of(surface, reader):
    """From a sum of closures."""
    closures, clear = list(surface.scattering), ZERO
    for share, colour in surface.passing:
        if colour.is_constant and np.ptp(colour.constant()) > 1e-3:
            reader.report.add(
                "a coloured Transparent BSDF is a thin pane without reflections: shadows of point lamps and "
                "suns are full behind it",
                *reader.place
            )
            closures.append(
                Closure(
                    "principled",
                    {
                        "rgb basecolor": combined(lambda c: np.clip(c, 0, 1), colour),
                        "float transmission": ONE,
                        "float ior": ONE,
                        "float roughness": ZERO,
                        "float specularlevel": ZERO,
                        "bool thinwall": True,
                    },
                    share,
                )
            )
            continue
        if not colour.is_constant:
            reader.report.add("a textured Transparent BSDF passes grey light", *reader.place)
        grey = combined(lambda c: np.clip(c.mean(axis=1, keepdims=True), 0, 1), colour)
        # What a grey one does not let pass, it absorbs.
        clear = total([clear, product(share, grey)]) if clear is not ZERO else product(share, grey)
        if not grey.is_always(1):
            closures.append(
                Closure("diffuse", {"rgb reflectance": constant(0.0, 0.0, 0.0)}, product(share, rest(grey)))
            )
    weights = [c.weight for c in closures]
    sum_ = total(weights) if weights else ZERO
    alpha = rest(clear)
    if not closures and not alpha.is_always(0):
        closures.append(Closure("diffuse", {"rgb reflectance": constant(0.0, 0.0, 0.0)}, alpha))
        weights, sum_ = [alpha], alpha
    else:
        _scale_to_sum(closures, sum_, alpha, reader)
    shares = []
    for i in range(1, len(closures)):
        shares.append(
            combined(lambda w, s: np.where(s > 0, w / np.where(s > 0, s, 1), 0), weights[i], total(weights[: i + 1]))
        )
    plan = MaterialPlan(closures, shares, alpha)
    plan.emission = _divided(emitted(surface), alpha) if surface.emission else ZERO
    return plan


def _scale_to_sum(closures, sum_, alpha, reader):
    """Closures whose shares do not add up to what is opaque have brighter or darker colours, as far as there are any."""
    factor = combined(lambda s, a: np.where(a > 0, s / np.where(a > 0, a, 1), 1), sum_, alpha)
    if not closures or not factor.is_constant or abs(float(factor.constant()[0]) - 1) < 1e-4:
        return
    value = float(factor.constant()[0])
    for closure in closures:
        for name in ("rgb basecolor", "rgb reflectance", "rgb transmittance"):
            if name not in closure.parameters:
                continue
            scaled = product(closure.parameters[name], constant(value))
            if scaled.is_constant and np.any(scaled.constant() > 1):
                reader.report.add(
                    "the shaders that are added reflect more than they receive; their colours are limited to 1",
                    *reader.place
                )
            closure.parameters[name] = combined(lambda c: np.clip(c, 0, 1), scaled)


def _divided(emission, alpha):
    """Emission that counts even where the surface lets light pass."""
    if alpha.is_always(1) or alpha.is_always(0):
        return emission
    return combined(lambda e, a: np.where(a > 0, e / np.where(a > 0, a, 1), 0), emission, alpha)


def add_relief(plan, reader, displacement):
    """displacement: the source of the material's Displacement, or None. The first relief that is found counts."""
    reliefs = [c.relief for c in plan.closures if c.relief is not None and c.relief.node.type in RELIEF_NODES]
    if displacement is not None and displacement.socket.is_output:
        reliefs.append(displacement)
    distinct = {(r.node.as_pointer(), r.groups) for r in reliefs}
    if len(distinct) > 1:
        reader.report.add("a surface has one relief; the first of its bumps and normal maps counts", *reader.place)
    for relief in reliefs[:1]:
        kind = relief.node.type
        if kind == "BUMP":
            _add_bump(plan, reader, relief)
        elif kind == "NORMAL_MAP":
            _add_normal_map(plan, reader, relief)
        else:
            height, middle, scale = (reader.value(relief.input(n)) for n in ("Height", "Midlevel", "Scale"))
            plan.bump = combined(lambda h, m, s: (h - m) * s, height, middle, scale)
            reader.report.add("displacement moves no surfaces; it is a bump", *reader.place)


def _add_bump(plan, reader, at):
    height, strength, distance = (reader.value(at.input(n)) for n in ("Height", "Strength", "Distance"))
    sign = -1.0 if at.node.invert else 1.0
    plan.bump = combined(lambda h, s, d: sign * h * s * d, height, strength, distance)
    if not strength.is_always(1):
        reader.report.add("a bump of strength below 1 is a flatter bump", *reader.place, at.node.name)
    below = at.input("Normal")
    if below is not None and below.source().socket.is_output:
        reader.report.add("a bump on top of a normal map stands alone", *reader.place, at.node.name)


def _add_normal_map(plan, reader, at):
    if at.node.space != "TANGENT":
        reader.unsupported(at, "normal maps of other spaces than the tangents' have no equal; they are left out")
        return
    colour, strength = reader.value(at.input("Color")), reader.value(at.input("Strength"))

    def encoded(c, s):
        n = 2 * c - 1
        n = np.stack([n[:, 0] * s[:, 0], n[:, 1] * s[:, 0], 1 + (n[:, 2] - 1) * s[:, 0]], axis=1)
        n = n / np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-20)
        return 0.5 * n + 0.5

    plan.normal_map = (
        combined(encoded, as_colour(colour), as_number(strength)) if not strength.is_always(1) else as_colour(colour)
    )
    if strength.is_always(1):
        plan.normal_map.image = getattr(colour, "image", None)
