"""Materials that are not the same for all rays: nodes may ask by which kind of ray a surface is met (Light Path).

A renderer without such nodes has three ways to say what is asked for most: a shadow of its own, surfaces that are not
there for diffuse rays and shadows, as a window's pane, and surfaces that the camera does not see.
"""

import numpy as np

from .expressions import ONE, combined, product, rest, total
from .points import Points

# What Light Path tells of a ray: 1 at these outputs, 0 at all others.
TOLD = {
    "camera": {"Is Camera Ray"},
    "shadow": {"Is Shadow Ray"},
    "diffuse": {"Is Diffuse Ray", "Is Reflection Ray", "Ray Depth", "Diffuse Depth"},
    "glossy": {"Is Glossy Ray", "Is Singular Ray", "Is Reflection Ray", "Ray Depth", "Glossy Depth"},
    "transmission": {"Is Glossy Ray", "Is Singular Ray", "Is Transmission Ray", "Ray Depth", "Transmission Depth"},
}
# Those that are the same for all rays of a kind.
KNOWN = {name for names in TOLD.values() for name in names if name.startswith("Is ")} | {"Is Volume Scatter Ray"}
PROBES = 64


def probes():
    """Points all over textures and objects, at which expressions are compared."""
    random = np.random.default_rng(1)
    uv, place, way = (random.random((PROBES, n), dtype=np.float32) for n in (2, 3, 3))
    way = way / np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-6)
    return Points(PROBES, {"": uv}, generated=place, object=place, position=place, normal=way)


def values(expression, points):
    found = expression(points)
    return np.broadcast_to(found, (PROBES, found.shape[1]))


def passing(surface):
    """The light that passes straight through, as a share: an expression."""
    return total([product(share, colour) for share, colour in surface.passing])


def alike(a, b, points):
    """Whether two surfaces are the same at all probes."""

    def scattered(surface):
        made = {}
        for closure in surface.scattering:
            weight = values(closure.weight, points)
            if not np.any(weight):
                continue
            relief = closure.relief.node.as_pointer() if closure.relief is not None else 0
            told = [closure.kind, relief]
            for name, value in sorted(closure.parameters.items()):
                told += [name, value if isinstance(value, bool) else values(value, points).round(4).tobytes()]
            key = tuple(told)
            made[key] = made.get(key, 0) + weight
        return made

    def same(x, y):
        return np.allclose(values(x, points), values(y, points), atol=1e-4)

    first, second = scattered(a), scattered(b)
    return (
        first.keys() == second.keys()
        and all(np.allclose(first[key], second[key], atol=1e-4) for key in first)
        and same(total(a.emission), total(b.emission))
        and same(passing(a), passing(b))
    )


def heed_rays(surfaces, plan_of, reader):
    """The plan of a material. surfaces: what each kind of ray of TOLD meets; plan_of: makes the plan of one of them."""
    points = probes()

    def clear(ray):
        return values(passing(surfaces[ray]), points)

    base, visible_to_camera = "camera", True
    if np.all(clear("camera") >= 1) and not surfaces["camera"].emission and not np.all(clear("diffuse") >= 1):
        base, visible_to_camera = "diffuse", False
    plan = plan_of(surfaces[base])
    plan.visible_to_camera = visible_to_camera
    open_ = np.all(clear("shadow") >= 1) and np.all(clear("diffuse") >= 1) and not surfaces["diffuse"].emission
    if open_ and not np.all(clear(base) >= 1) and not any(is_frosted(c) for c in plan.closures):
        plan.visible_to_diffuse = False
    else:
        _cast_shadow(plan, surfaces["shadow"], clear("shadow") - clear(base), reader)
        if not alike(surfaces["diffuse"], surfaces[base], points):
            reader.report.add("diffuse rays meet the surface that the camera sees", *reader.place)
    for ray, where in (("glossy", "mirrors show"), ("transmission", "glass shows")):
        if not alike(surfaces[ray], surfaces[base], points):
            reader.report.add(f"{where} the surface that the camera sees", *reader.place)
    return plan


def is_frosted(closure):
    """Whether it is rough glass, behind which rays are diffuse ones."""
    glass, rough = (closure.parameters.get("float " + n) for n in ("transmission", "roughness"))
    return glass is not None and not glass.is_always(0) and not (rough is not None and rough.is_always(0))


def _cast_shadow(plan, shadow, lighter, reader):
    """lighter: by how much more the shadow lets pass than the surface, at the probes."""
    if np.all(np.abs(lighter) < 1e-4):
        return
    if np.any(lighter < -1e-4):
        reader.report.add("a shadow is as light as the surface is clear, at least", *reader.place)
    if np.any(np.ptp(values(passing(shadow), probes()), axis=1) > 1e-3):
        reader.report.add("a shadow that is coloured by the nodes is grey", *reader.place)
    share = combined(lambda c: np.clip(c.mean(axis=1, keepdims=True), 0, 1), passing(shadow))
    plan.shadow_alpha = rest(share) if shadow.passing else ONE
