"""The whole scene: one file of text, with meshes and images beside it."""

import contextlib
import os
from dataclasses import dataclass, field, replace

import numpy as np

from ..materials.image_lookup import Images
from ..materials.material_writer import MaterialWriter
from ..materials.reader import Reader
from ..materials.textures import TextureWriter
from .cache import FileCache, digest
from .cameras import camera_lines, film_lines, transforms, view_lines
from .lights import lamp_lines
from .objects import invertible, key_of, matrices_at, stretch_of, visible
from .pbrt_text import Names, quoted, statement, transform
from .report import Report
from .shown import ObjectReader, ShownHair
from .strand_text import piece_lines, pieces_of, strand_lines
from .world import world_lines

@dataclass
class Settings:
    """How to export. max_depth: bounces of paths; texture_side: texels along a tile of a baked texture."""

    max_depth: int = 12
    filter_kind: str = "GAUSSIAN"  # or BOX
    filter_width: float = 1.5  # pixels
    texture_side: int = 1024
    atlas_side: int = 2048
    world_side: int = 1024
    motion_blur: bool = None  # None: as the scene has it


@dataclass
class Exported:
    """content: a digest of all that is exported but the camera; sphere: centre and radius of all that is
    seen."""

    path: str
    report: Report
    content: str = ""
    sphere: tuple = None
    triangles: int = 0
    strands: int = 0
    meshes_written: int = 0
    instances: int = 0
    seconds: dict = field(default_factory=dict)


@contextlib.contextmanager
def naming(object_name):
    """What cannot be exported is found by the object's name."""
    try:
        yield
    except ValueError as error:
        raise ValueError(f"{object_name}: {error}") from error


class SceneExporter:
    """Exports into one folder, again and again; what has not changed is not written again."""

    def __init__(self, folder, settings=None):
        self.folder, self.settings = folder, settings or Settings()
        os.makedirs(folder, exist_ok=True)

    def export(self, depsgraph, size=None, set_frame=None, camera=None, name="scene.pbrt", view=None):
        """size: of the picture, None for the scene's; set_frame(frame, subframe): moves the depsgraph in time, None
        without motion; camera: an object, None for the scene's; view: the viewport's View, which is rendered in place
        of a camera, without a region. Returns Exported. Raises OSError, or ValueError with
        one line for the user."""
        scene = depsgraph.scene_eval if hasattr(depsgraph, "scene_eval") else depsgraph.scene
        camera = camera or scene.camera
        if camera is None and view is None:
            raise ValueError("the scene has no camera: add one, and make it the active camera")
        self.report = Report()
        self.layer = depsgraph.view_layer
        self.meshes = FileCache(self.folder, "meshes")
        self.files = FileCache(self.folder, "textures")
        images = Images()
        self.reader = Reader(self.report, images)
        scale = scene.render.resolution_percentage / 100
        width, height = size or (
            max(1, int(scene.render.resolution_x * scale)),
            max(1, int(scene.render.resolution_y * scale)),
        )
        aspect = scene.render.pixel_aspect_y / scene.render.pixel_aspect_x
        self._check(scene)

        moving = self._matrices_in_motion(scene, depsgraph, camera, set_frame)
        self.exported = Exported(os.path.join(self.folder, name), self.report)
        definitions, shapes, lamps, bounds = [], [], [], []
        self.names = Names()
        textures = TextureWriter(self.files, images, self.settings.texture_side)
        self.materials = MaterialWriter(definitions, textures, self.reader, self.names, self.settings.atlas_side)
        self._place(depsgraph, moving, definitions, shapes, lamps, bounds)
        title = ["# Written by DRC's add-on for Blender. World space is Blender's: z is up.", ""]
        sphere = self.exported.sphere = sphere_around(bounds)
        if view is not None:
            place, lens = view_lines(view.before(sphere))
        else:
            place, lens = camera_lines(
                camera, moving.get("camera") or [np.array(camera.matrix_world)], width, height, aspect, self.report
            )
        head = film_lines(
            None if view is not None else scene, width, height, self.settings.filter_kind, self.settings.filter_width
        )
        head += [
            statement("Sampler", "zsobol", params={"integer pixelsamples": 128}),
            statement("Integrator", "path", params={"integer maxdepth": self.settings.max_depth}),
            "",
            "WorldBegin",
            "",
        ]
        world = getattr(self.layer, "world_override", None) or scene.world
        world = world_lines(world, self.reader, self.files, self.settings.world_side)
        text = "\n".join(head + world + lamps + definitions + shapes) + "\n"
        write_text(self.exported.path, "\n".join(title + place + lens) + "\n" + text)
        self.exported.content = digest(text)
        self.meshes.remove_unused()
        self.files.remove_unused()
        self.exported.meshes_written = self.meshes.written
        return self.exported

    def _check(self, scene):
        unit = scene.unit_settings
        if unit.system != "NONE" and abs(unit.scale_length - 1) > 1e-6:
            self.report.add("the unit scale changes no lengths: one Blender unit is one unit of the scene file")

    # Motion

    def _matrices_in_motion(self, scene, depsgraph, camera, set_frame):
        """Matrices at the shutter's opening and closing: by key, and those of the camera by "camera"."""
        blur = scene.render.use_motion_blur if self.settings.motion_blur is None else self.settings.motion_blur
        if not blur or set_frame is None or scene.render.motion_blur_shutter <= 0:
            return {}
        shutter, frame = scene.render.motion_blur_shutter, scene.frame_current + scene.frame_subframe
        position = getattr(scene.render, "motion_blur_position", None) or getattr(
            scene.cycles, "motion_blur_position", "CENTER"
        )
        first = {"START": 0.0, "CENTER": -0.5, "END": -1.0}[position] * shutter
        found = {}
        name = camera.name
        for time in (frame + first, frame + first + shutter):
            whole = int(np.floor(time))
            set_frame(whole, time - whole)
            for key, matrix in matrices_at(depsgraph).items():
                found.setdefault(key, []).append(matrix)
            found.setdefault("camera", []).append(
                np.array(
                    depsgraph.scene_eval.objects[name].matrix_world
                    if name in depsgraph.scene_eval.objects
                    else camera.matrix_world
                )
            )
        whole = int(np.floor(frame))
        set_frame(whole, frame - whole)
        return {key: matrices for key, matrices in found.items() if len(matrices) == 2}

    # Objects

    def _place(self, depsgraph, moving, definitions, shapes, lamps, bounds):
        counts, read, groups, placings = {}, {}, {}, []
        objects = ObjectReader(self.layer, self.report, depsgraph.mode == "RENDER")
        for instance in depsgraph.object_instances:
            object_ = instance.object
            if object_.type == "LIGHT":
                if not visible(instance):
                    continue
                with naming(object_.name):
                    matrix = np.array(instance.matrix_world)
                    lamps += lamp_lines(object_.original, matrix, self.reader, self.files, self.report)
                continue
            parts = objects.parts(instance)
            if not parts:
                continue
            with naming(object_.name):
                matrix = invertible(np.array(instance.matrix_world))
                matrices = [invertible(m) for m in moving.get(key_of(instance), [])]
            if matrix is None:
                continue
            if not matrices or any(m is None for m in matrices):
                matrices = [matrix]
            object_key = (
                object_.original.name_full if not instance.is_instance else object_.name_full,
                object_.data.name_full if object_.data is not None else "",
                instance.is_instance,
            )
            for part, read_part in parts:
                mesh_key = (*object_key, part)
                if mesh_key not in read:
                    read[mesh_key] = read_part()
                if read[mesh_key] is None:
                    continue
                stretch = stretch_of(matrix) if isinstance(read[mesh_key], ShownHair) else None
                if stretch is None:
                    place, places = matrix, matrices
                else:
                    # The strands are stretched themselves, so that those that are stretched alike can be instances.
                    place, *places = (m @ np.linalg.inv(stretch) for m in (matrix, *matrices))
                    hair, mesh_key = read[mesh_key], (*mesh_key, stretch.round(6).tobytes())
                    if mesh_key not in read:
                        read[mesh_key] = replace(hair, hair=hair.hair.stretched(stretch))
                counts[mesh_key] = counts.get(mesh_key, 0) + 1
                placings.append((mesh_key, object_.name, place, places))
        for mesh_key, name, matrix, matrices in placings:
            mesh = read[mesh_key]
            self.exported.instances += 1
            bounds.append(corners_of(mesh.positions, matrix))
            moves = len(matrices) > 1 and not np.allclose(matrices[0], matrices[-1], rtol=0, atol=1e-7)
            if mesh_key not in groups:
                with naming(name):
                    write = self._strands if isinstance(mesh, ShownHair) else self._triangles
                    groups[mesh_key] = write(name, mesh, matrix)
            fixed, emitting = groups[mesh_key]
            if emitting and moves:
                self.report.add("lamps and emissive surfaces that move stand still", name)
            if emitting:
                shapes += ["AttributeBegin", transform(matrix), *emitting, "AttributeEnd"]
            if fixed and counts[mesh_key] > 1:
                if isinstance(fixed, list):
                    object_name = "object " + self.names.of(name)
                    definitions += [f"ObjectBegin {quoted(object_name)}", *fixed, "ObjectEnd"]
                    groups[mesh_key] = fixed, emitting = object_name, emitting
                shapes += ["AttributeBegin", *transforms(matrices), f"ObjectInstance {quoted(fixed)}", "AttributeEnd"]
            elif fixed:
                shapes += ["AttributeBegin", *transforms(matrices), *fixed, "AttributeEnd"]

    def _strands(self, name, shown, _matrix):
        """As of _triangles, of hair."""
        lines, hair = [], shown.hair
        pieces = pieces_of(hair) if self.materials.changes_along(shown.material) else None
        points = hair.roots if pieces is None else hair.roots_of_pieces(pieces)
        if self.materials.plan(shown.material)[0].is_emissive:
            self.report.add("hair emits no light", name)
        for placed, rows in self.materials.on_hair(shown.material, points):
            shape = shape_parameters(placed, shown)

            def text(rows=rows, shape=shape):
                curves = strand_lines(hair, rows, shape) if pieces is None else piece_lines(pieces, rows, shape)
                return ("\n".join(curves) + "\n").encode()

            key = digest(hair.key, rows, "strands" if pieces is None else "pieces", repr(sorted(shape.items())))
            lines += [placed.lines[0], f"Include {quoted(self.meshes.file(key, 'pbrt', text))}"]
        self.exported.strands += hair.strands
        return lines, []

    def _triangles(self, name, mesh, matrix):
        """(lines of what may be instanced, lines of what emits) of the parts of a mesh."""
        fixed, emitting = [], []
        for index, material in enumerate(mesh.materials):
            triangles = mesh.data.part(index, len(mesh.materials))
            if not len(triangles):
                continue
            placed = self.materials.placed(material, mesh.data, triangles, matrix, mesh.bounds)
            if placed.invisible:
                continue
            if placed.atlas is not None:
                key = digest(mesh.data.key, index, len(mesh.materials), "atlas", placed.atlas.size)
                file = self.meshes.file(key, "ply", lambda: mesh.data.atlas_ply(triangles, placed.atlas.uvs()))
            else:
                key = digest(mesh.data.key, index, len(mesh.materials), placed.uv)
                file = self.meshes.file(key, "ply", lambda: mesh.data.ply(triangles, placed.uv))
            self.exported.triangles += len(triangles)
            shape = statement(
                "Shape", "plymesh", params={"string filename": file, **shape_parameters(placed, mesh)}
            )
            lines = [*placed.lines, shape]
            if placed.emissive:
                emitting += ["AttributeBegin", *lines, "AttributeEnd"]
            else:
                fixed += lines
        return fixed, emitting


def shape_parameters(placed, shown):
    """What the object says of shadows counts, whatever its materials do."""
    named = {declared.split()[1] for declared in shown.visibility}
    own = {declared: v for declared, v in placed.shape.items() if declared.split()[1] not in named}
    return {**shown.visibility, **own}


def corners_of(positions, matrix):
    low, high = positions.min(axis=0), positions.max(axis=0)
    corners = np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
    return corners @ matrix[:3, :3].T + matrix[:3, 3]


def sphere_around(bounds):
    if not bounds:
        return np.zeros(3), 1.0
    corners = np.concatenate(bounds)
    low, high = corners.min(axis=0), corners.max(axis=0)
    return (low + high) / 2, float(np.linalg.norm(high - low) / 2)


def write_text(path, text):
    """Whole or not at all."""
    partial = f"{path}.{os.getpid()}.partial"
    try:
        with open(partial, "w", encoding="utf-8") as f:
            f.write(text)
        os.replace(partial, path)
    except OSError:
        if os.path.exists(partial):
            os.remove(partial)
        raise
