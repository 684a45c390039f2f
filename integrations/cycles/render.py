#!/usr/bin/env python3
"""Renders a pbrt-v3 scene with Blender's Cycles on the CPU, or says in one line which of its lines Cycles cannot match.

Nothing is clamped, caustics are on, paths have up to 128 bounces, sampling is not adaptive, no view transform. Open
Image Denoise gets albedo and normal, both filtered by themselves first ("accurate"). Spheres and disks are fine
meshes, spheres with their own normals. Pixel filters other than pbrt's usual box are Gaussians of the same variance.
"""
import math
import os
import re
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))

import budget
import pbrt_geometry as geometry
from drc_export import refuse
from pbrt_scene import ImageTexture
from pbrt_subset import read_scene

MAX_BOUNCES = 128
MOST_SAMPLES = 1 << 20
# Kept free of sampling where there is a time limit: a share, since Cycles looks at its clock between batches of
# samples; what it takes to write; and for each pixel what Open Image Denoise takes of one core (19e-6 measured, Zen 5).
SHARE_KEPT = 0.04
SECONDS_TO_WRITE, SECONDS_PER_WRITTEN_PIXEL = 0.3, 0.5e-6
SECONDS_TO_DENOISE, SECONDS_PER_DENOISED_PIXEL = 0.3, 22e-6


class Nodes:
    """A node tree, filled by calls."""

    def __init__(self, tree):
        self.tree = tree
        tree.nodes.clear()

    def add(self, kind, settings=(), **inputs):
        """A node. Inputs by name, spaces written as _; values are constants or other nodes' outputs."""
        node = self.tree.nodes.new(kind)
        for name, value in dict(settings).items():
            setattr(node, name, value)
        for name, value in inputs.items():
            self.set(self.input(node, name.replace("_", " ")), value)
        return node

    @staticmethod
    def input(node, name):
        return next(i for i in node.inputs if i.name == name and i.enabled)

    def set(self, socket, value):
        if hasattr(value, "is_output"):
            self.tree.links.new(value, socket)
        elif isinstance(value, tuple) and socket.type == "RGBA":
            socket.default_value = value + (1.0,)
        else:
            socket.default_value = value

    def mix_shaders(self, factor, first, second):
        node = self.tree.nodes.new("ShaderNodeMixShader")
        for socket, value in zip(node.inputs, (factor, first, second)):
            self.set(socket, value)
        return node.outputs[0]


class Translation:
    """From what pbrt_subset reads to the scene of Blender."""

    def __init__(self, bpy, scene, width, height):
        self.bpy, self.scene = bpy, bpy.context.scene
        self.materials, self.images, self.sphere = {}, {}, None
        for shape in scene.shapes:
            self.shape(shape)
        self.scene.world = bpy.data.worlds.new("world")
        self.scene.world.use_nodes = True
        infinite = [light for light in scene.lights if light.kind == "infinite"]
        if len(infinite) > 1:
            refuse(infinite[1].pos, "a second infinite light is not matched by Cycles")
        self.world(infinite[0] if infinite else None)
        for light in scene.lights:
            if light.kind != "infinite":
                self.light(light)
        self.camera(scene.camera, width, height)
        self.filter(scene.filter)

    def object(self, name, data, matrix=geometry.IDENTITY):
        from mathutils import Matrix
        found = self.bpy.data.objects.new(name, data)
        found.matrix_world = Matrix([list(row) for row in matrix])
        self.scene.collection.objects.link(found)
        return found

    # Materials

    def image(self, path, srgb):
        if (path, srgb) not in self.images:
            image = self.bpy.data.images.load(os.path.abspath(path))
            image.colorspace_settings.name = "Non-Color"
            image.alpha_mode = "CHANNEL_PACKED"
            self.images[path, srgb] = self.linear(image) if srgb else image
        return self.images[path, srgb]

    def linear(self, image):
        """Decoded here: Cycles would interpolate between values as they are encoded, pbrt does between linear ones."""
        import numpy as np
        width, height = image.size
        v = np.empty(width * height * 4, dtype=np.float32)
        image.pixels.foreach_get(v)
        v = np.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4).astype(np.float32)
        v[3::4] = 1
        found = self.bpy.data.images.new("linear", width, height, alpha=True, float_buffer=True, is_data=True)
        found.pixels.foreach_set(v)
        found.update()
        self.bpy.data.images.remove(image)
        return found

    def color(self, nodes, value):
        if not isinstance(value, ImageTexture):
            return value
        if value.path.lower().endswith(".pfm"):
            refuse(value.pos, "a PFM picture is not matched by Cycles")
        (su, sv), (du, dv) = value.uv_scale, value.uv_offset
        uv = nodes.add("ShaderNodeUVMap", {"uv_map": "uv"}).outputs[0]
        st = nodes.add("ShaderNodeMapping", {"vector_type": "POINT"}, Vector=uv, Location=(du, dv, 0.0),
                       Scale=(su, sv, 1.0)).outputs[0]
        extension = {"repeat": "REPEAT", "clamp": "EXTEND", "black": "CLIP"}[value.wrap]
        node = nodes.add("ShaderNodeTexImage", {"interpolation": "Linear", "extension": extension,
                                                "image": self.image(value.path, value.srgb)},
                         Vector=st)
        return node.outputs["Color"]

    def material(self, shape):
        key = (id(shape.material), shape.radiance, shape.two_sided)
        if key not in self.materials:
            material = self.bpy.data.materials.new("material")
            material.use_nodes = True
            nodes = Nodes(material.node_tree)
            surface = getattr(self, shape.material.kind)(nodes, shape.material)
            if shape.radiance is not None:
                emission = nodes.add("ShaderNodeEmission", Color=shape.radiance, Strength=1.0).outputs[0]
                if not shape.two_sided:
                    back = nodes.add("ShaderNodeNewGeometry").outputs["Backfacing"]
                    dark = nodes.add("ShaderNodeEmission", Color=(0.0, 0.0, 0.0), Strength=0.0).outputs[0]
                    emission = nodes.mix_shaders(back, emission, dark)
                sum_node = nodes.tree.nodes.new("ShaderNodeAddShader")
                nodes.set(sum_node.inputs[0], surface)
                nodes.set(sum_node.inputs[1], emission)
                surface = sum_node.outputs[0]
                material.cycles.emission_sampling = "FRONT_BACK" if shape.two_sided else "FRONT"
            nodes.add("ShaderNodeOutputMaterial", Surface=surface)
            self.materials[key] = material
        return self.materials[key]

    def matte(self, nodes, m):
        return nodes.add("ShaderNodeBsdfDiffuse", Color=self.color(nodes, m.Kd), Roughness=0.0).outputs[0]

    def mirror(self, nodes, m):
        return nodes.add("ShaderNodeBsdfAnisotropic", {"distribution": "GGX"}, Color=self.color(nodes, m.Kr),
                         Roughness=0.0).outputs[0]

    def glass(self, nodes, m):
        # Cycles' own glass carries light through a boundary unchanged; pbrt scales radiance by the square of the ratio
        # of the indices, which matters wherever light does not come out as it went in.
        inside = nodes.add("ShaderNodeNewGeometry").outputs["Backfacing"]
        entering, leaving = (tuple(k * m.eta ** e for k in m.Kt) for e in (-2, 2))
        tint = nodes.add("ShaderNodeMix", {"data_type": "RGBA", "clamp_factor": True}, Factor=inside, A=entering,
                         B=leaving)
        tinted = next(o for o in tint.outputs if o.enabled)
        refraction = nodes.add("ShaderNodeBsdfRefraction", Color=tinted, Roughness=0.0, IOR=m.eta).outputs[0]
        reflection = nodes.add("ShaderNodeBsdfAnisotropic", {"distribution": "GGX"}, Color=m.Kr,
                               Roughness=0.0).outputs[0]
        reflected = nodes.add("ShaderNodeFresnel", IOR=m.eta).outputs[0]
        return nodes.mix_shaders(reflected, refraction, reflection)

    def metal(self, nodes, m):
        if not hasattr(self.bpy.types, "ShaderNodeBsdfMetallic"):
            refuse(m.pos, f"metal is not matched by Cycles of Blender {self.bpy.app.version_string}, only from 4.3 on")
        # Cycles' roughness is the root of alpha.
        return nodes.add("ShaderNodeBsdfMetallic", {"distribution": "GGX", "fresnel_type": "PHYSICAL_CONDUCTOR"},
                         IOR=m.eta, Extinction=m.k, Roughness=math.sqrt(m.alpha)).outputs[0]

    # Shapes

    def shape(self, s):
        material = self.material(s)
        if s.kind == "sphere" and not (s.one_sided() and s.reverse):
            s.check_sides()
            data = self.unit_sphere()
            matrix = geometry.multiply(s.matrix, geometry.scale(*[s.radius] * 3))
        else:
            data, matrix = self.mesh(s.mesh()), geometry.IDENTITY
            data.materials.append(material)
        found = self.object("shape", data, matrix)
        found.material_slots[0].link = "OBJECT"
        found.material_slots[0].material = material
        # Rays start where they hit, as pbrt's do.
        found.cycles.shadow_terminator_geometry_offset = 0.0
        found.cycles.shadow_terminator_offset = 0.0

    def unit_sphere(self):
        if self.sphere is None:
            self.sphere = self.mesh(geometry.sphere_mesh(1.0))
            self.sphere.materials.append(None)
        return self.sphere

    def mesh(self, mesh):
        import numpy as np
        corners = np.frombuffer(bytes_of(mesh.indices, "i"), dtype=np.int32)
        points = np.frombuffer(bytes_of(mesh.positions, "f"), dtype=np.float32)
        data = self.bpy.data.meshes.new("mesh")
        data.vertices.add(len(points) // 3)
        data.vertices.foreach_set("co", points)
        data.loops.add(len(corners))
        data.loops.foreach_set("vertex_index", corners)
        data.polygons.add(len(corners) // 3)
        data.polygons.foreach_set("loop_start", np.arange(0, len(corners), 3, dtype=np.int32))
        data.polygons.foreach_set("loop_total", np.full(len(corners) // 3, 3, dtype=np.int32))
        smooth = mesh.normals is not None
        data.polygons.foreach_set("use_smooth", np.full(len(corners) // 3, smooth))
        if mesh.uvs is not None:
            uvs = np.frombuffer(bytes_of(mesh.uvs, "f"), dtype=np.float32).reshape(-1, 2)
            data.uv_layers.new(name="uv").data.foreach_set("uv", uvs[corners].ravel())
        data.update(calc_edges=True)
        if smooth:
            data.normals_split_custom_set_from_vertices(
                np.frombuffer(bytes_of(mesh.normals, "f"), dtype=np.float32).reshape(-1, 3).tolist())
        return data

    # Lights, camera, filter

    def world(self, light):
        nodes = Nodes(self.scene.world.node_tree)
        color = light.radiance if light else (0.0, 0.0, 0.0)
        if light and light.image is not None:
            if light.image.lower().endswith(".pfm"):
                refuse(light.pos, "a PFM picture is not matched by Cycles")
            if len(set(light.radiance)) > 1:
                refuse(light.pos, "an image of an infinite light that is also tinted is not matched by Cycles")
            srgb = light.image.lower().endswith((".png", ".tga"))
            # Cycles' map begins at -x and runs the other way round: its x is turned about.
            size = geometry.uniform_scale(light.matrix)
            back = geometry.inverse(light.matrix)
            rows = [tuple(sign * size * x for x in back[k][:3]) for k, sign in enumerate((-1.0, 1.0, 1.0))]
            direction = nodes.add("ShaderNodeTexCoord").outputs["Generated"]
            parts = [nodes.add("ShaderNodeVectorMath", {"operation": "DOT_PRODUCT"}) for _ in rows]
            for part, row in zip(parts, rows):
                nodes.set(part.inputs[0], direction)
                nodes.set(part.inputs[1], row)
            joined = nodes.add("ShaderNodeCombineXYZ", X=parts[0].outputs["Value"], Y=parts[1].outputs["Value"],
                               Z=parts[2].outputs["Value"]).outputs[0]
            color = nodes.add("ShaderNodeTexEnvironment",
                              {"image": self.image(light.image, srgb),
                               "interpolation": "Linear"}, Vector=joined).outputs["Color"]
        strength = light.radiance[0] if light and light.image is not None else 1.0
        background = nodes.add("ShaderNodeBackground", Color=color, Strength=strength).outputs[0]
        nodes.add("ShaderNodeOutputWorld", Surface=background)

    def light(self, light):
        from mathutils import Vector
        if light.kind == "point":
            data = self.bpy.data.lights.new("light", "POINT")
            data.shadow_soft_size = 0.0
            data.energy = 4 * math.pi  # watts, for an intensity of 1
            color, found = light.intensity, self.object("light", data)
            found.location = light.position
        else:
            data = self.bpy.data.lights.new("light", "SUN")
            data.angle = 0.0
            data.energy = 1.0
            color, found = light.radiance, self.object("light", data)
            found.rotation_mode = "QUATERNION"
            found.rotation_quaternion = Vector(light.direction).to_track_quat("Z", "Y")
        brightest = max(color) or 1.0
        data.energy *= brightest
        data.color = [c / brightest for c in color]

    def camera(self, c, width, height):
        data = self.bpy.data.cameras.new("camera")
        # A sensor as large on both sides as what the shorter side sees one unit away.
        data.lens = 10.0
        data.sensor_width = data.sensor_height = 2 * data.lens * math.tan(math.radians(c.fov) / 2)
        data.sensor_fit = "HORIZONTAL" if width < height else "VERTICAL"
        data.clip_start, data.clip_end = 1e-6, 1e9
        rows = [(c.x[k], c.y[k], -c.z[k], c.position[k]) for k in range(3)] + [geometry.IDENTITY[3]]
        self.scene.camera = self.object("camera", data, tuple(rows))

    def filter(self, f):
        cycles = self.scene.cycles
        if f.kind == "box" and f.radius == 0.5:
            cycles.pixel_filter_type = "BOX"
            return
        # Cycles' Gaussian has a standard deviation of a quarter of what it calls width.
        width = 4 * math.sqrt(variance(f))
        if not 0.01 <= width <= 10:
            refuse(f.pos, f'the pixel filter "{f.kind}" with this width is not matched by Cycles')
        cycles.pixel_filter_type, cycles.filter_width = "GAUSSIAN", width
        budget.note(f'{f.pos}: for the pixel filter "{f.kind}" Cycles takes a Gaussian of the same variance')


def bytes_of(values, kind):
    import array
    return memoryview(array.array(kind, values))


def variance(f):
    """Of a filter along one axis, in square pixels."""
    if f.kind == "box":
        return f.radius ** 2 / 3
    if f.kind == "triangle":
        return f.radius ** 2 / 6
    if f.kind != "gaussian":
        refuse(f.pos, f'the pixel filter "{f.kind}" is not matched by Cycles')
    alpha, steps = f.values["alpha"], 1000
    xs = [f.radius * (i + 0.5) / steps for i in range(steps)]
    weights = [math.exp(-alpha * x * x) - math.exp(-alpha * f.radius ** 2) for x in xs]
    return sum(w * x * x for w, x in zip(weights, xs)) / sum(weights)


def configure(bpy, args):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles, render = scene.cycles, scene.render
    cycles.device, cycles.feature_set, cycles.shading_system = "CPU", "SUPPORTED", False
    cycles.use_adaptive_sampling = False
    cycles.seed = args.seed % 2**31
    cycles.samples = args.spp or MOST_SAMPLES
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.blur_glossy = 0.0
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = MAX_BOUNCES
    cycles.transmission_bounces = cycles.transparent_max_bounces = MAX_BOUNCES
    cycles.use_fast_gi = False
    cycles.film_exposure = 1.0
    cycles.use_denoising = args.denoiser == "oidn"
    if cycles.use_denoising:
        cycles.denoiser = "OPENIMAGEDENOISE"
        cycles.denoising_input_passes = "RGB_ALBEDO_NORMAL"
        cycles.denoising_prefilter = "ACCURATE"
        cycles.denoising_quality = "HIGH"
        cycles.denoising_use_gpu = False
    render.threads_mode, render.threads = "FIXED", args.threads
    render.resolution_x, render.resolution_y, render.resolution_percentage = args.width, args.height, 100
    render.pixel_aspect_x = render.pixel_aspect_y = 1.0
    render.use_compositing = render.use_sequencer = render.use_border = False
    render.use_motion_blur = False
    render.dither_intensity = 0.0
    scene.view_settings.view_transform = "Raw"
    image = render.image_settings
    image.file_format, image.color_mode, image.color_depth, image.exr_codec = "OPEN_EXR", "RGB", "32", "ZIP"
    render.use_file_extension, render.use_overwrite = False, True


def render(bpy, args, deadline):
    """Renders into the file; seconds of sampling, None if Cycles does not say."""
    cycles, pixels = bpy.context.scene.cycles, args.width * args.height
    if args.seconds:
        kept = SHARE_KEPT * args.seconds + SECONDS_TO_WRITE + SECONDS_PER_WRITTEN_PIXEL * pixels
        if cycles.use_denoising:
            kept += SECONDS_TO_DENOISE + SECONDS_PER_DENOISED_PIXEL * pixels / args.threads
        cycles.time_limit = max(0.01, deadline.left() - kept)
    times = []

    def told(line, *_):
        # The first line that counts samples comes before them, the last one that counts any before what comes after.
        found = re.search(r"\bSample (\d+)/", line)
        if found and (not times or int(found[1]) > 0):
            times.append(time.monotonic())

    bpy.app.handlers.render_stats.append(told)
    bpy.context.scene.render.filepath = os.path.abspath(args.output)
    bpy.ops.render.render(write_still=True)
    return times[-1] - times[0] if len(times) > 1 else None


def flip(bpy, path):
    """Left to right, in place."""
    import numpy as np
    image = bpy.data.images.load(os.path.abspath(path))
    image.colorspace_settings.name = "Non-Color"
    width, height = image.size
    pixels = np.empty(width * height * 4, dtype=np.float32)
    image.pixels.foreach_get(pixels)
    image.pixels.foreach_set(np.ascontiguousarray(pixels.reshape(height, width, 4)[:, ::-1]).ravel())
    image.save_render(os.path.abspath(path), scene=bpy.context.scene)


def main():
    parser = budget.arguments(__doc__)
    parser.add_argument("--denoiser", choices=["off", "oidn"], default="off")
    args = parser.parse_args()
    deadline = budget.Deadline(args.seconds or 0)
    with tempfile.TemporaryDirectory() as folder:
        scene = read_scene(args.scene, folder, args.drc)
        # Blender tells of its progress on standard output; what matters is on standard error.
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        import bpy
        bpy.ops.wm.read_factory_settings(use_empty=True)
        configure(bpy, args)
        Translation(bpy, scene, args.width, args.height)
    seconds = render(bpy, args, deadline)
    if scene.camera.mirrored:
        flip(bpy, args.output)
    if seconds is not None:
        budget.write_timing(args.timing, seconds)
    sys.stderr.flush()
    os._exit(0)  # leaves out what Blender does to take itself down


if __name__ == "__main__":
    budget.run(main)
