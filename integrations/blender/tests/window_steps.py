"""What test_in_window.py does in Blender: steps of a generator, between which Blender draws and answers events.

    blender --python window_steps.py -- DRC REPORT.json SCREEN FOLDER

SCREEN is the file in which Xvfb has its picture, FOLDER is where pictures of the window are kept.

A step waits for the seconds that it yields, or until the function that it yields is true. The report is a list of (what,
whether it is as it should be, detail).
"""

import importlib
import json
import os
import shutil
import subprocess
import sys
import time
import traceback

import bpy
import numpy as np
from mathutils import Quaternion

DRC, REPORT, SCREEN, FOLDER = sys.argv[sys.argv.index("--") + 1 :]
ADD_ON = "bl_ext.user_default.drc"
SETTLED = 3.0  # seconds after which a small viewport has a few samples a pixel
PATIENCE = 60.0
seen = []


def check(what, good, detail=""):
    seen.append((what, bool(good), str(detail)))
    with open(REPORT, "w") as f:
        json.dump(seen, f)


# What is there


def viewport():
    """(area, region, space)"""
    area = next(a for a in bpy.context.window_manager.windows[0].screen.areas if a.type == "VIEW_3D")
    return area, next(r for r in area.regions if r.type == "WINDOW"), area.spaces[0]


def in_viewport():
    area, region, _ = viewport()
    return bpy.context.temp_override(window=bpy.context.window_manager.windows[0], area=area, region=region)


def children():
    """Process ids of renderers that this Blender has started; zombies count."""
    found = []
    for pid in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{pid}/stat") as f:
                name, _, rest = f.read().partition("(")[2].rpartition(")")
        except OSError:  # it has ended meanwhile
            continue
        if int(rest.split()[1]) == os.getpid():
            found.append(int(pid))
    return sorted(found)


def picture(name):
    """Of the viewport, as it is seen: height x width x 3, from the top."""
    with open(SCREEN, "rb") as f:
        data = f.read()
    # Of the format of xwd: a head of big-endian words, colours of 12 bytes, rows of pixels as blue, green, red, unused.
    head = np.frombuffer(data, ">u4", 25)
    begin, width, height, line = int(head[0] + 12 * head[19]), int(head[4]), int(head[5]), int(head[12])
    pixels = np.frombuffer(data, np.uint8, height * line, begin).reshape(height, line)[:, : 4 * width]
    pixels = pixels.reshape(height, width, 4)[..., 2::-1]
    image_files = importlib.import_module(ADD_ON + ".export.image_files")
    with open(os.path.join(FOLDER, f"{bpy.app.version[0]}.{bpy.app.version[1]}-{name}.png"), "wb") as f:
        f.write(image_files.png_bytes(pixels))
    _, region, _ = viewport()
    top = height - region.y - region.height
    return pixels[top : top + region.height, region.x : region.x + region.width] / np.float32(255)


def blocks(values, side=16):
    height, width = (n // side * side for n in values.shape[:2])
    return values[:height, :width].reshape(height // side, side, width // side, side, 3).mean(axis=(1, 3))


def check_alike(what, ours, theirs):
    """As seen, so through the view transform. Noise is left out of it; a picture that is shifted, mirrored or of other
    colours is not alike."""
    a, b = blocks(ours), blocks(theirs)
    apart, alike = float(abs(a - b).mean()), float(np.corrcoef(a.ravel(), b.ravel())[0, 1])
    check(what, apart < 0.02 and alike > 0.98, f"apart by {apart:.4f} of white, correlation {alike:.4f}")


def is_rendering():
    return bpy.app.is_job_running("RENDER")


# The steps


def scene_of_ours():
    """The scene that Blender starts with, on a floor, under a lamp that is not seen."""
    bpy.ops.mesh.primitive_plane_add(size=12, location=(0, 0, -1))
    bpy.data.objects["Light"].data.shadow_soft_size = 0
    base = bpy.data.objects["Cube"].active_material.node_tree.nodes["Principled BSDF"].inputs["Base Color"]
    base.default_value = (0.8, 0.1, 0.05, 1)
    _, _, space = viewport()
    space.overlay.show_overlays = space.show_gizmo = space.show_region_toolbar = space.show_region_header = False
    space.show_region_tool_header = False
    space.shading.type = "RENDERED"
    scene = bpy.context.scene
    scene.cycles.preview_samples, scene.cycles.use_preview_denoising = 32, False
    scene.render.resolution_percentage = 25
    scene.drc.stop, scene.drc.time = "TIME", 3
    return scene, space


def compared(scene, name):
    """Steps: the viewport by Cycles and by DRC."""
    scene.render.engine = "CYCLES"
    yield 2 * SETTLED
    theirs = picture(name + "-cycles")
    check(f"{name}: no renderer beside Cycles", not children(), children())
    scene.render.engine = "DRC"
    yield lambda: len(children()) == 1
    yield 2 * SETTLED
    check_alike(f"{name} is as Cycles'", picture(name + "-drc"), theirs)


def steps():
    bpy.context.preferences.addons[ADD_ON].preferences.program = DRC
    scene, space = scene_of_ours()
    yield 1
    yield from viewports(scene, space)
    yield from changes(scene, space)
    yield from renders(scene)
    yield from failures(scene)
    yield from disabled(scene)
    bpy.context.scene.drc.time = 60
    bpy.ops.render.render("INVOKE_DEFAULT")
    yield 3
    check("quits while it renders", is_rendering())
    bpy.ops.wm.quit_blender()


def viewports(scene, space):
    yield from compared(scene, "perspective")
    space.region_3d.view_perspective = "ORTHO"
    yield from compared(scene, "orthographic")
    space.region_3d.view_perspective = "PERSP"
    with in_viewport():
        bpy.ops.view3d.render_border(xmin=200, xmax=700, ymin=150, ymax=500)
    yield from compared(scene, "border")
    with in_viewport():
        bpy.ops.view3d.clear_render_border()
        bpy.ops.view3d.view_camera()
    scene.render.use_border = True
    scene.render.border_min_x, scene.render.border_max_y = 0.3, 0.7
    yield from compared(scene, "camera with a border")
    scene.render.use_border = False
    dof = scene.camera.data.dof
    dof.use_dof, dof.focus_distance, dof.aperture_fstop = True, 5.0, 0.05
    yield from compared(scene, "camera with depth of field")
    dof.use_dof = False
    with in_viewport():
        bpy.ops.view3d.view_camera()
    yield SETTLED


def changes(scene, space):
    before, first = children(), picture("before")
    bpy.data.objects["Cube"].select_set(not bpy.data.objects["Cube"].select_get())
    yield SETTLED
    check("a selection keeps the renderer", children() == before, (before, children()))
    space.region_3d.view_rotation = Quaternion((0, 0, 1), 0.6) @ space.region_3d.view_rotation
    yield SETTLED
    orbited = picture("orbited")
    check("orbiting keeps the renderer", children() == before, (before, children()))
    check("orbiting shows something else", abs(blocks(orbited) - blocks(first)).mean() > 0.02)
    lens, space.lens = space.lens, 20
    yield SETTLED
    wide = picture("wide")
    check("another lens keeps the renderer", children() == before, (before, children()))
    check("another lens shows something else", abs(blocks(wide) - blocks(orbited)).mean() > 0.02)
    space.lens = lens
    base = bpy.data.objects["Cube"].active_material.node_tree.nodes["Principled BSDF"].inputs["Base Color"]
    base.default_value = (0.05, 0.1, 0.8, 1)
    yield lambda: children() != before and len(children()) == 1
    yield SETTLED
    painted = picture("painted")
    gain = (blocks(painted) - blocks(orbited)).max(axis=(0, 1))
    check("another colour is shown", gain[2] > 0.1, gain)
    space.shading.type = "SOLID"
    yield lambda: not children()
    check("solid shading ends the renderer", not children(), children())
    space.shading.type = "RENDERED"
    yield lambda: len(children()) == 1
    yield SETTLED


def renders(scene):
    before = children()
    bpy.ops.render.render("INVOKE_DEFAULT")
    yield lambda: len(children()) == 2
    yield lambda: not is_rendering()
    check("a render ends", not is_rendering())
    yield SETTLED
    check("a render keeps the viewport's renderer", children() == before, (before, children()))
    scene.drc.time = 60
    if not shutil.which("xdotool"):  # an event of Python's would not do: Blender looks for the key itself
        return
    bpy.ops.render.render("INVOKE_DEFAULT")
    yield SETTLED
    began = time.monotonic()
    subprocess.run(["xdotool", "mousemove", "600", "400", "key", "Escape"], check=True)
    yield lambda: not is_rendering()
    check("Escape ends a render", not is_rendering() and time.monotonic() - began < 3, time.monotonic() - began)
    check("Escape ends its renderer", children() == before, (before, children()))


def failures(scene):
    killed = children()[0]
    os.kill(killed, 9)
    yield SETTLED
    picture("killed")
    # Another may have been started: the end of a render tells the viewport of a change.
    check("a renderer that is killed leaves no zombie", killed not in children(), (killed, children()))
    preferences = bpy.context.preferences.addons[ADD_ON].preferences
    preferences.program = "/nowhere/drc"
    bpy.data.objects["Cube"].location.z += 0.1
    yield SETTLED
    picture("missing")
    said = [viewport._error for viewport in importlib.import_module(ADD_ON + ".viewport")._all]
    check("a missing program is told", any("there is no program /nowhere/drc" in (line or "") for line in said), said)
    preferences.program = DRC
    bpy.data.objects["Cube"].location.z += 0.1
    yield SETTLED
    said = [viewport._error for viewport in importlib.import_module(ADD_ON + ".viewport")._all]
    check("with a program, the viewport renders again", not any(said) and len(children()) == 1, (said, children()))


def disabled(scene):
    import addon_utils

    bpy.ops.render.render("INVOKE_DEFAULT")
    yield lambda: len(children()) == 2
    addon_utils.disable(ADD_ON)
    yield 1
    check("disabled while it renders, the add-on leaves nothing running", not children(), children())
    addon_utils.enable(ADD_ON)
    yield 1
    scene.render.engine = "DRC"
    yield lambda: len(children()) == 1
    check("enabled, it renders again", len(children()) == 1)


def main():
    todo, wait = steps(), [None, 0.0]

    def tick():
        condition, end = wait
        if condition is not None and time.monotonic() < end and not condition():
            return 0.1
        try:
            said = next(todo)
        except StopIteration:
            return None
        except Exception:  # of any step: the report is what tells of it
            check("all steps are taken", False, traceback.format_exc())
            os._exit(1)
        wait[:] = [said, time.monotonic() + PATIENCE] if callable(said) else [None, 0.0]
        return 0.1 if callable(said) else said

    bpy.app.timers.register(tick, first_interval=2.0, persistent=True)


bpy.context.preferences.view.show_splash = False
main()
