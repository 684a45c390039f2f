"""The camera of a scene: what it sees, its lens, and how it moves while the shutter is open."""

import numpy as np

from .camera_maths import Lens, lens_radius, pixel_bounds, screen_window
from .pbrt_text import statement, transform
from .spaces import world_to_camera, world_to_panorama


def lens_of(camera):
    return Lens(
        camera.type == "ORTHO",
        camera.lens,
        camera.ortho_scale,
        camera.sensor_width,
        camera.sensor_height,
        camera.sensor_fit,
        camera.shift_x,
        camera.shift_y,
    )


def focus_distance(object_, camera):
    """Along the direction of view."""
    dof = camera.dof
    if dof.focus_object is None:
        return dof.focus_distance
    matrix, target = np.array(object_.matrix_world), np.array(dof.focus_object.matrix_world.translation)
    view = matrix[:3, 2] / np.linalg.norm(matrix[:3, 2])
    return abs(float(np.dot(matrix[:3, 3] - target, view)))


def depth_of_field(object_):
    """(radius of the thin lens, distance in focus)"""
    camera = object_.data
    if not camera.dof.use_dof:
        return 0.0, 1e6
    radius = lens_radius(camera.type == "ORTHO", camera.lens, camera.dof.aperture_fstop)
    distance = max(focus_distance(object_, camera), 1e-4)
    return (radius, distance) if np.isfinite([radius, distance]).all() else (0.0, 1e6)


def is_panorama(camera):
    return camera.type == "PANO"


def panorama_kind(camera):
    """Blender 5 has it in the camera, Blender 4 in Cycles' settings or in both."""
    kind = getattr(camera, "panorama_type", None) or getattr(getattr(camera, "cycles", None), "panorama_type", None)
    return kind or "EQUIRECTANGULAR"


def camera_lines(object_, matrices, width, height, pixel_aspect, report):
    """(lines of the place, lines of the lens). object_: of the camera; matrices: its matrix_world at one time, or at the
    shutter's opening and closing."""
    camera = object_.data
    place = (object_.name,)
    panorama = is_panorama(camera)
    to_camera = world_to_panorama if panorama else world_to_camera
    place_lines = transforms([to_camera(m) for m in matrices])
    params = {"float shutteropen": 0, "float shutterclose": 1}
    if panorama:
        if panorama_kind(camera) != "EQUIRECTANGULAR":
            report.add("of panoramas, only Equirectangular has an equal; it is used", *place)
        return place_lines, [statement("Camera", "spherical", params={"string mapping": "equirectangular", **params})]
    lens = lens_of(camera)
    params["float screenwindow"] = screen_window(lens, width, height, pixel_aspect)
    if not lens.orthographic:
        params["float fov"] = 90  # the screen window is that at distance 1
    if camera.dof.use_dof:
        params["float lensradius"], params["float focaldistance"] = depth_of_field(object_)
        if camera.dof.aperture_blades >= 3 or camera.dof.aperture_ratio != 1:
            report.add("apertures with blades or a ratio have no equal; it is a circle", *place)
    return place_lines, [statement("Camera", "orthographic" if lens.orthographic else "perspective", params=params)]


def view_lines(view):
    """(lines of the place, lines of the lens) of the viewport, a View."""
    params = {"float screenwindow": view.window}
    if not view.orthographic:
        params["float fov"] = 90
    return transforms([world_to_camera(view.matrix())]), [
        statement("Camera", "orthographic" if view.orthographic else "perspective", params=params)
    ]


def transforms(matrices):
    """The transformation, at both ends of the shutter if there are two."""
    if len(matrices) == 1 or np.allclose(matrices[0], matrices[-1], rtol=0, atol=1e-7):
        return [transform(matrices[0])]
    return [
        "ActiveTransform StartTime",
        transform(matrices[0]),
        "ActiveTransform EndTime",
        transform(matrices[-1]),
        "ActiveTransform All",
    ]


def film_lines(scene, width, height, filter_kind, filter_width):
    """scene: has the region to render; None: all of it."""
    params = {"integer xresolution": width, "integer yresolution": height, "string filename": "drc.exr"}
    render = scene.render if scene is not None else None
    if render is not None and render.use_border:
        border = (render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y)
        params["integer pixelbounds"] = pixel_bounds(border, width, height)
    if render is not None and render.film_transparent:
        params["bool transparent"] = True
    lines = [statement("Film", "rgb", params=params)]
    if filter_kind == "BOX":
        half = filter_width / 2
        return lines + [statement("PixelFilter", "box", params={"float xradius": half, "float yradius": half})]
    from .camera_maths import filter_sigma

    sigma = filter_sigma(filter_width)
    return lines + [
        statement(
            "PixelFilter",
            "gaussian",
            params={"float xradius": filter_width / 2, "float yradius": filter_width / 2, "float sigma": sigma},
        )
    ]
