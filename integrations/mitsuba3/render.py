#!/usr/bin/env python3
"""Renders a pbrt-v3 scene with Mitsuba 3, or says in one line which of its lines Mitsuba cannot match.

Pictures are made in passes of other seeds each, whose weighted sums are added. Variant llvm_ad_rgb if LLVM's library is
there and works, else scalar_rgb; --variant decides otherwise. Paths of up to 128 bounces, Russian roulette from the
fifth on.
"""
import os
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))

import budget
import pbrt_geometry as geometry
from drc_export import refuse
from pbrt_scene import ImageTexture
from pbrt_subset import read_scene
from ply_file import write_ply

# Mitsuba's microfacets shadow without regard to each other's height, pbrt's with it. Up to this alpha reflections
# differ by less than 0.6 % at 85 degrees.
LARGEST_ALPHA = 0.05
MAX_BOUNCES, ROULETTE_FROM = 128, 5
# Of LLVM 15 Mitsuba 3.9 asks what it does not know, and LLVM ends the process.
OLDEST_LLVM = 17
LEAST_MAP_ROWS = 1024
# What compiled kernels hold in memory at once.
LLVM_SAMPLES = 1 << 21


def choose_variant(mi, wanted):
    if wanted:
        mi.set_variant(wanted)
        return wanted
    try:
        import drjit as dr
        mi.set_variant("llvm_ad_rgb")
        if dr.detail.llvm_version()[0] < OLDEST_LLVM:
            raise RuntimeError
        picture = mi.render(mi.load_dict({
            "type": "scene", "integrator": {"type": "path"}, "light": {"type": "constant"},
            "sphere": {"type": "sphere"},
            "sensor": {"type": "perspective", "film": {"type": "hdrfilm", "width": 2, "height": 2}}}), spp=1)
        if picture.numpy().size > 0:
            return "llvm_ad_rgb"
    except Exception:  # LLVM is missing, or too old for this Mitsuba, and says so in several ways
        pass
    mi.set_variant("scalar_rgb")
    return "scalar_rgb"


class Translation:
    """From what pbrt_subset reads to Mitsuba's dictionary."""

    def __init__(self, mi, scene, width, height, folder):
        self.mi, self.folder = mi, folder
        self.parts, self.bsdfs, self.images = {}, {}, {}
        self.low, self.high = [float("inf")] * 3, [-float("inf")] * 3
        for i, shape in enumerate(scene.shapes):
            self.parts[f"shape{i}"] = self.shape(shape, i)
        for i, light in enumerate(scene.lights):
            self.parts[f"light{i}"] = self.light(light)
        if sum(light.kind == "infinite" for light in scene.lights) > 1:
            refuse(scene.lights[-1].pos, "a second infinite light is not matched by Mitsuba")
        self.parts["sensor"] = self.sensor(scene, width, height)
        self.parts["type"] = "scene"
        self.parts["integrator"] = {"type": "path", "max_depth": MAX_BOUNCES + 1, "rr_depth": ROULETTE_FROM,
                                    "hide_emitters": False}

    def transform(self, matrix):
        return self.mi.ScalarTransform4f([list(row) for row in matrix])

    def rgb(self, value):
        return {"type": "rgb", "value": list(value)}

    def color(self, value, pos):
        if not isinstance(value, ImageTexture):
            if max(value) > 1:
                refuse(pos, "a surface that reflects more than it receives is not matched by Mitsuba")
            return self.rgb(value)
        if value.wrap == "black":
            refuse(value.pos, 'the wrap mode "black" is not matched by Mitsuba')
        (su, sv), (du, dv) = value.uv_scale, value.uv_offset
        # Mitsuba counts v from the picture's top.
        to_uv = self.mi.ScalarTransform3f([[su, 0, du], [0, -sv, 1 - dv], [0, 0, 1]])
        return {"type": "bitmap", "filename": value.path, "raw": not value.srgb, "filter_type": "bilinear",
                "wrap_mode": value.wrap, "to_uv": to_uv}

    def bsdf(self, m):
        if id(m) not in self.bsdfs:
            self.bsdfs[id(m)] = getattr(self, m.kind)(m)
        return self.bsdfs[id(m)]

    def matte(self, m):
        return {"type": "twosided", "inner": {"type": "diffuse", "reflectance": self.color(m.Kd, m.pos)}}

    def mirror(self, m):
        return {"type": "twosided", "inner": {"type": "conductor", "material": "none",
                                              "specular_reflectance": self.color(m.Kr, m.pos)}}

    def glass(self, m):
        return {"type": "dielectric", "int_ior": m.eta, "ext_ior": 1.0,
                "specular_reflectance": self.color(m.Kr, m.pos), "specular_transmittance": self.color(m.Kt, m.pos)}

    def metal(self, m):
        if m.alpha > LARGEST_ALPHA:
            refuse(m.pos, f"metal rougher than alpha {LARGEST_ALPHA} (here {m.alpha:.3g}) is not matched by Mitsuba")
        return {"type": "twosided", "inner": {"type": "roughconductor", "distribution": "ggx", "alpha": m.alpha,
                                              "eta": self.rgb(m.eta), "k": self.rgb(m.k)}}

    def shape(self, s, index):
        part = {"bsdf": self.bsdf(s.material)}
        black = s.material.kind == "matte" and not s.material.textured() and max(s.material.Kd) == 0
        if s.radiance is not None:
            if s.two_sided:
                refuse(s.pos, "a light that shines on both sides is not matched by Mitsuba")
            part["emitter"] = {"type": "area", "radiance": self.rgb(s.radiance)}
        if s.kind == "sphere" and not s.material.textured() and geometry.determinant(s.matrix) > 0 \
                and geometry.uniform_scale(s.matrix, 1e-6) is not None:
            self.extend(s.matrix, s.radius)
            part.update({"type": "sphere", "flip_normals": s.reverse,
                         "to_world": self.transform(geometry.multiply(s.matrix, geometry.scale(*[s.radius] * 3)))})
            return part
        part.update(self.mesh(s, black, index))
        return part

    def mesh(self, s, black, index):
        if s.is_complete() and not (s.radiance is not None and s.ply["normals"]):
            s.check_sides()
            self.enclose(*s.ply["bounds"])
            return {"type": "ply", "filename": s.ply["file"], "face_normals": not s.ply["normals"]}
        mesh = s.mesh()
        if s.radiance is not None and not mesh.normals_follow_faces():
            if not black:
                refuse(s.pos, "a light with smooth normals that also reflects is not matched by Mitsuba")
            mesh.normals = None
        axes = [mesh.positions[k::3] for k in range(3)]
        self.enclose([min(axis) for axis in axes], [max(axis) for axis in axes])
        path = os.path.join(self.folder, f"{index}.ply")
        write_ply(mesh, path)
        return {"type": "ply", "filename": path, "face_normals": mesh.normals is None}

    def enclose(self, low, high):
        self.low = [min(a, b) for a, b in zip(self.low, low)]
        self.high = [max(a, b) for a, b in zip(self.high, high)]

    def extend(self, matrix, radius):
        size = radius * geometry.uniform_scale(matrix)
        center = geometry.column(matrix, 3)
        self.enclose([x - size for x in center], [x + size for x in center])

    def light(self, light):
        if light.kind == "point":
            return {"type": "point", "position": list(light.position), "intensity": self.rgb(light.intensity)}
        if light.kind == "distant":
            return {"type": "directional", "direction": [-x for x in light.direction],
                    "irradiance": self.rgb(light.radiance)}
        if light.image is None:
            return {"type": "constant", "radiance": self.rgb(light.radiance)}
        if len(set(light.radiance)) > 1:
            refuse(light.pos, "an image of an infinite light that is also tinted is not matched by Mitsuba")
        # pbrt's map has its poles on z and begins at x; Mitsuba's has them on y and begins at -z.
        size = geometry.uniform_scale(light.matrix)
        turn = geometry.multiply(geometry.scale(*[1 / size] * 3), light.matrix)
        turn = tuple(row[:3] + (0.0,) for row in turn[:3]) + (geometry.IDENTITY[3],)
        axes = ((0.0, 0.0, -1.0, 0.0), (1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), geometry.IDENTITY[3])
        return {"type": "envmap", "bitmap": self.environment(light.image), "scale": light.radiance[0],
                "to_world": self.transform(geometry.multiply(turn, axes))}

    def environment(self, path):
        """Mitsuba has the first and last row at the poles, pbrt half a row away: the same function, on more rows."""
        import numpy as np
        mi = self.mi
        bitmap = mi.Bitmap(path).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, srgb_gamma=False)
        texels = np.array(bitmap)
        height = texels.shape[0]
        rows = height * max(2, -(-LEAST_MAP_ROWS // height))
        y = np.arange(rows) / (rows - 1) * height - 0.5
        low = np.floor(y).astype(int)
        share = (y - low)[:, None, None]
        mixed = (1 - share) * texels[low % height] + share * texels[(low + 1) % height]
        return mi.Bitmap(np.ascontiguousarray(mixed, dtype=np.float32))

    def sensor(self, scene, width, height):
        c = scene.camera
        # Mitsuba's x points to the left.
        rows = [(-c.x[k], c.y[k], c.z[k], c.position[k]) for k in range(3)] + [geometry.IDENTITY[3]]
        # Only what lies between the two is seen: everything does.
        far = sum(max(abs(h - c.position[k]), abs(low - c.position[k]))
                  for k, (low, h) in enumerate(zip(self.low, self.high)))
        far = 2 * far if 0 < far < float("inf") else 1.0
        return {"type": "perspective", "fov": c.fov, "fov_axis": "smaller", "to_world": self.transform(rows),
                "near_clip": 1e-5 * far, "far_clip": far, "sampler": {"type": "independent"},
                "film": {"type": "hdrfilm", "width": width, "height": height, "pixel_format": "rgb",
                         "component_format": "float32", "rfilter": self.filter(scene.filter)}}

    def filter(self, f):
        if f.kind == "box" and f.radius == 0.5:
            return {"type": "box"}
        if f.kind == "triangle":
            return {"type": "tent", "radius": f.radius}
        if f.kind == "gaussian":
            deviation = (2 * f.values["alpha"]) ** -0.5
            # Mitsuba's ends at four standard deviations.
            if abs(4 * deviation - f.radius) < 1e-3 * f.radius:
                return {"type": "gaussian", "stddev": deviation}
        if f.kind == "mitchell" and f.radius == 2:
            return {"type": "mitchell", "B": f.values["B"], "C": f.values["C"]}
        refuse(f.pos, f'the pixel filter "{f.kind}" with this width is not matched by Mitsuba')


def render_passes(mi, scene, args, variant, deadline):
    """The film's weighted sums, and the seconds of rendering."""
    import drjit as dr
    import numpy as np
    integrator, film = scene.integrator(), scene.sensors()[0].film()
    cap = max(1, LLVM_SAMPLES // (args.width * args.height)) if "llvm" in variant else 1 << 16
    writing = 0.1 + 0.3e-6 * args.width * args.height
    total, done, passes, began, per_sample = None, 0, 0, time.monotonic(), None
    while True:
        if args.spp:
            count = min(cap, args.spp - done)
        elif per_sample is None:
            count = 1
        else:
            left = deadline.left() - writing
            # By halves, since passes do not all take the same; the last takes what is left.
            count = min(cap, int(left / per_sample / (2 if left > 20 * per_sample else 1)))
        if count < 1:
            break
        start = time.monotonic()
        integrator.render(scene, seed=(args.seed * 65536 + passes) % 2**32, spp=count, develop=False)
        sums = np.array(film.bitmap(raw=True), dtype=np.float64)
        dr.sync_thread()
        took = (time.monotonic() - start) / count
        # A first pass also compiles.
        per_sample = took if passes < 2 else max(took, 0.8 * per_sample)
        total = sums if total is None else total + sums
        done, passes = done + count, passes + 1
    seconds = time.monotonic() - began
    budget.note(f"Mitsuba {mi.__version__}, {variant}: {done} samples per pixel in {passes} passes, {seconds:.2f} s")
    return total, seconds


def main():
    parser = budget.arguments(__doc__)
    parser.add_argument("--variant", help="of Mitsuba")
    args = parser.parse_args()
    deadline = budget.Deadline(args.seconds or 0)
    with tempfile.TemporaryDirectory() as folder:
        scene = read_scene(args.scene, folder, args.drc)
        import mitsuba as mi
        import numpy as np
        variant = choose_variant(mi, args.variant)
        import drjit as dr
        dr.set_thread_count(args.threads)
        mi.set_log_level(mi.LogLevel.Error)
        loaded = mi.load_dict(Translation(mi, scene, args.width, args.height, folder).parts)
    total, seconds = render_passes(mi, loaded, args, variant, deadline)
    picture = total[..., :3] / np.maximum(total[..., 3:4], 1e-30)
    if scene.camera.mirrored:
        picture = picture[:, ::-1]
    mi.Bitmap(np.ascontiguousarray(picture, dtype=np.float32)).write(args.output)
    budget.write_timing(args.timing, seconds)
    sys.stderr.flush()
    os._exit(0)  # to take everything down takes Mitsuba longer than to write the picture


if __name__ == "__main__":
    budget.run(main)
