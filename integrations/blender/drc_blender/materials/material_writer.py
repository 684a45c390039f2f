"""Materials of a scene file, as they are needed: one for each Blender material and way to place its textures."""

from dataclasses import dataclass, field

import numpy as np

from ..export.cache import digest
from ..export.pbrt_text import quoted, statement
from ..export.report import Report
from .atlas import Atlas, points_of
from .closures import Closure, ClosureReader
from .expressions import ALONG, Expression, constant
from .node_links import Socket, active_output, tree_of
from .plan import MaterialPlan, add_relief, plan_of
from .ray_kinds import TOLD, heed_rays
from .strand_looks import StrandLook, looks_of
from .textures import Window, texture, value_at_nowhere
from .tree_key import tree_key


@dataclass
class Placed:
    """How a part of a mesh looks. lines: before its Shape; uv: the map that its PLY has, None without; atlas: the Atlas
    that its PLY has instead."""

    lines: list
    uv: str = None
    atlas: Atlas = None
    emissive: bool = False
    invisible: bool = False
    shape: dict = field(default_factory=dict)  # parameters of the Shape


class MaterialWriter:
    def __init__(self, out, textures, reader, names, atlas_side):
        """out: the list of lines that definitions are added to."""
        self.out, self.textures, self.reader, self.names, self.atlas_side = out, textures, reader, names, atlas_side
        self._plans, self._written = {}, {}

    # Plans

    def plan(self, material):
        """(plan, key of its tree) of a Blender material; None for the grey of objects without one."""
        name = material.name_full if material is not None else None
        if name not in self._plans:
            self._plans[name] = self._make_plan(material)
        return self._plans[name]

    def _make_plan(self, material):
        if material is None:
            return MaterialPlan([Closure("diffuse", {"rgb reflectance": constant(0.8, 0.8, 0.8)})], []), "none"
        reader = self.reader.at(material.name)
        tree = tree_of(material)
        if tree is None:
            colour = tuple(material.diffuse_color)[:3]
            return MaterialPlan([Closure("diffuse", {"rgb reflectance": constant(*colour)})], []), digest(colour)
        plan = self._plan_of(tree, reader)
        output = active_output(tree, "OUTPUT_MATERIAL")
        displacement = Socket(output.inputs["Displacement"]).source() if output is not None else None
        add_relief(plan, reader, displacement)
        if output is not None and output.inputs["Volume"].is_linked:
            reader.report.add("volumes of materials are not exported", *reader.place)
        return plan, tree_key(tree)

    @staticmethod
    def _plan_of(tree, reader):
        seen = reader.for_ray("camera")
        surface = ClosureReader(seen).surface(tree)
        if not seen.rays_matter:
            return plan_of(surface, reader)
        surfaces = {"camera": surface}
        for ray in TOLD.keys() - surfaces.keys():
            # What such rays meet besides is told of the camera's.
            surfaces[ray] = ClosureReader(reader.for_ray(ray, Report())).surface(tree)
        return heed_rays(surfaces, lambda surface: plan_of(surface, reader), reader)

    # Parts of meshes

    def placed(self, material, mesh, triangles, to_world, bounds):
        """How these triangles of a mesh look, under this material."""
        plan, key = self.plan(material)
        name = material.name_full if material is not None else "default"
        if plan.is_invisible:
            return Placed([], invisible=True)
        if not plan.is_textured:
            return self._cached((name,), plan, lambda: _Constant())
        uv = plan.map_name()
        if uv is not None and (uv in mesh.uvs or "" in mesh.uvs):
            coordinates = mesh.uvs.get(uv, mesh.uvs.get(""))
            window = Window.of(coordinates[triangles.reshape(-1)])
            made = self._cached((name, uv, window.low, window.high), plan, lambda: _Mapped(self.textures, window, key))
            made.uv = uv
            return made
        if uv is not None:  # a mesh without coordinates shows every texture's lower left corner
            return self._cached((name, None), plan, lambda: _Constant())
        atlas = Atlas(len(triangles), self.atlas_side)
        place = digest(mesh.key, triangles, np.asarray(to_world, dtype=np.float64).round(6), [tuple(b) for b in bounds])
        if plan.normal_map is not None:
            self.reader.report.add("a normal map beside textures that are not mapped by UVs is left out", name)
            plan.normal_map = None
        kept = []

        def points():  # of all textures of the part, made once
            if not kept:
                kept.append(points_of(mesh, triangles, atlas, to_world, bounds))
            return kept[0]

        made = self._cached((name, place), plan, lambda: _Baked(self.textures, atlas, points, digest(key, place)))
        made.atlas = atlas
        return made

    def changes_along(self, material):
        """Whether strands of hair look otherwise at their tips than at their roots."""
        return any((ALONG,) in e.needs for e in self.plan(material)[0].expressions())

    def on_hair(self, material, points):
        """How strands or pieces of strands look under this material: [(Placed, numbers of those that look so)]."""
        plan, _ = self.plan(material)
        name = material.name_full if material is not None else "default"
        if plan.is_invisible or not points.count:
            return []
        if not plan.is_textured:
            return [(self._cached((name,), plan, lambda: _Constant()), np.arange(points.count))]
        made = []
        for rows in looks_of(plan, points):
            look = StrandLook(points, rows)
            made.append((self._cached((name, look.key(plan)), plan, lambda: look), rows))
        return made

    def _cached(self, key, plan, values):
        if key not in self._written:
            self._written[key] = self._write(self.names.of(key[0]), plan, values())
        return self._written[key]

    # Text

    def _write(self, name, plan, values):
        values.writer = self
        values.name = name
        relief = self._relief(plan, values)
        named = []
        for i, closure in enumerate(plan.closures):
            params = {"string type": closure.kind}
            for declared, value in closure.parameters.items():
                params.update(
                    values.parameter(declared, value, f"{name}.{i}" if i else name)
                    if isinstance(value, Expression)
                    else {declared: value}
                )
            part = name if len(plan.closures) == 1 else f"{name}.part{i + 1}"
            # A mix has its own relief, if any: that of its parts does not count.
            self.out.append(statement("MakeNamedMaterial", part, params={**params, **relief}))
            named.append(part)
        whole = named[0] if named else None
        for i, share in enumerate(plan.shares):
            mixed = name if i == len(plan.shares) - 1 else f"{name}.mix{i + 1}"
            params = {
                "string type": "mix",
                "string materials": [whole, named[i + 1]],
                **values.parameter("float amount", share, f"{mixed}.amount"),
            }
            self.out.append(statement("MakeNamedMaterial", mixed, params=params))
            whole = mixed
        lines = [f"NamedMaterial {quoted(whole)}"] if whole else ['Material "diffuse" "rgb reflectance" [0 0 0]']
        lines += self._emission(plan, values)
        shape = {}
        if not plan.alpha.is_always(1):
            shape.update(values.parameter("float alpha", plan.alpha, f"{name}.alpha"))
        if plan.shadow_alpha is not None:
            shape.update(values.parameter("float shadowalpha", plan.shadow_alpha, f"{name}.shadowalpha"))
        if not plan.visible_to_camera:
            shape["bool visibletocamera"] = False
        if not plan.visible_to_diffuse:
            shape["bool visibletodiffuse"] = False
        return Placed(lines, emissive=len(lines) > 1, shape=shape)

    def _relief(self, plan, values):
        if plan.bump is not None and plan.bump.needs:
            return values.parameter("float displacement", plan.bump, f"{values.name}.bump")
        if plan.normal_map is not None and plan.normal_map.needs:
            file = values.normal_map(plan.normal_map)
            return {"string normalmap": file} if file else {}
        return {}

    def _emission(self, plan, values):
        if not plan.is_emissive:
            return []
        params = values.emission(plan.emission)
        return [statement("AreaLightSource", "diffuse", params={**params, "bool twosided": True})] if params else []


def _constant_parameter(declared, expression):
    value = value_at_nowhere(expression)
    return {declared: value if declared.startswith("rgb") else float(value[0])}


def _as_texture(declared, name):
    return {"texture " + declared.split()[1]: name}


class _Constant:
    """Every value as it is at no place in particular."""

    def parameter(self, declared, expression, _name):
        return _constant_parameter(declared, expression)

    def normal_map(self, _expression):
        return None

    def emission(self, expression):
        radiance = value_at_nowhere(expression)
        return {"rgb L": np.maximum(radiance, 0)} if np.any(radiance > 0) else {}


class _Mapped:
    """Textures under the mesh's own coordinates."""

    def __init__(self, textures, window, key):
        self.textures, self.window, self.key = textures, window, key

    def parameter(self, declared, expression, name):
        if expression.is_constant:
            return _constant_parameter(declared, expression)
        columns = 3 if declared.startswith("rgb") else 1
        name = f"{name}.{declared.split()[1]}"
        direct = self.textures.direct(expression) if columns == 3 else None
        if direct is None:
            file = self.textures.bake_window(expression, columns, self.window, digest(self.key, name))
            direct = file, self.window.parameters()
        self.writer.out.append(texture(name, columns, *direct))
        return _as_texture(declared, name)

    def normal_map(self, expression):
        # pbrt looks a normal map up at the mesh's coordinates themselves, repeated.
        direct = self.textures.direct(expression, data=True)
        if direct is not None and set(direct[1]) <= {"string wrap", "string encoding"}:
            return direct[0]
        return self.textures.bake_window(expression, 3, Window(), digest(self.key, "normal map"))

    def emission(self, expression):
        return _Constant().emission(expression)  # one that varies is baked


class _Baked:
    """Textures in an atlas of the part's own."""

    def __init__(self, textures, atlas, points, key):
        self.textures, self.atlas, self.points, self.key = textures, atlas, points, key

    def _file(self, expression, columns, name):
        return self.textures.bake_points(expression, columns, self.points, self.atlas.size, digest(self.key, name))

    def parameter(self, declared, expression, name):
        if expression.is_constant:
            return _constant_parameter(declared, expression)
        columns = 3 if declared.startswith("rgb") else 1
        name = f"{name}.{declared.split()[1]}"
        self.writer.out.append(texture(name, columns, self._file(expression, columns, name), {"string wrap": "clamp"}))
        return _as_texture(declared, name)

    def normal_map(self, _expression):
        return None

    def emission(self, expression):
        if expression.is_constant:
            return _Constant().emission(expression)
        return {"string filename": self._file(expression, 3, "emission")}
