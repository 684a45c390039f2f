"""Cameras, regions and motion."""

import bpy

from stage import feature


@feature("camera: wide, vertical fit, shifted")
def _(s):
    c = s.camera.data
    c.lens, c.sensor_fit, c.shift_x, c.shift_y = 22, "VERTICAL", 0.1, -0.08


@feature("camera: tall picture")
def _(s):
    s.scene.render.resolution_x, s.scene.render.resolution_y = 80, 128


@feature("camera: orthographic")
def _(s):
    s.camera.data.type, s.camera.data.ortho_scale = "ORTHO", 5.0


@feature("camera: panorama")
def _(s):
    bpy.data.objects.remove(s.lamp)  # which only DRC would show
    s.light("POINT", 400, (2.5, -2.5, 4.5), shadow_soft_size=0.0)
    s.camera.location = (0.3, -1.6, 1.2)
    s.camera.data.type = "PANO"
    if hasattr(s.camera.data, "panorama_type"):
        s.camera.data.panorama_type = "EQUIRECTANGULAR"
    else:
        s.camera.data.cycles.panorama_type = "EQUIRECTANGULAR"


@feature("camera: depth of field", spp=512)
def _(s):
    s.camera.data.dof.use_dof = True
    s.camera.data.dof.aperture_fstop, s.camera.data.dof.focus_object = 0.12, s.ball


@feature("camera: region")
def _(s):
    r = s.scene.render
    r.use_border, r.use_crop_to_border = True, True
    r.border_min_x, r.border_max_x, r.border_min_y, r.border_max_y = 0.25, 0.75, 0.2, 0.7


def blurred(s, object_, x0, x1):
    """An even movement along x while the shutter is open."""
    s.scene.render.use_motion_blur, s.scene.render.motion_blur_shutter = True, 0.8
    for frame, x in ((0, x0), (2, x1)):
        object_.location.x = x
        object_.keyframe_insert("location", frame=frame)
    for curve in curves_of(object_):
        for point in curve.keyframe_points:
            point.interpolation = "LINEAR"
    s.scene.frame_set(1)


@feature("motion blur: object", spp=512)
def _(s):
    blurred(s, s.ball, -1.2, -0.2)


@feature("motion blur: camera", spp=512)
def _(s):
    blurred(s, s.camera, 3.0, 3.4)


def curves_of(object_):
    """The F-curves of an object's action: of its first slot, where actions are layered."""
    action = object_.animation_data.action
    if hasattr(action, "fcurves"):
        return list(action.fcurves)
    return [c for layer in action.layers for strip in layer.strips for bag in strip.channelbags for c in bag.fcurves]
