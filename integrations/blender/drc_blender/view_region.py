"""What a viewport that looks through a camera has of it, and the part of a viewport that is to be rendered."""

from bpy_extras.view3d_utils import location_3d_to_region_2d

from .export.cameras import depth_of_field


def camera_of(context, scene):
    """That the viewport looks through, or would."""
    space = context.space_data
    return space.camera if space.use_local_camera else scene.camera


def depth_of_field_of(context, depsgraph):
    """(radius of the lens, distance in focus) of a viewport, which only has some if it looks through a camera."""
    camera = camera_of(context, depsgraph.scene) if context.region_data.view_perspective == "CAMERA" else None
    if camera is None or camera.type != "CAMERA":
        return 0.0, 1e6
    return depth_of_field(camera.evaluated_get(depsgraph))


def part_of(context, scene):
    """(x0, x1, y0, y1), from 0 to 1 across the viewport from its top left; None for all of it, or if the part is out of
    sight. Seen through the camera it is the scene's render region, else the viewport's own."""
    space, region, view = context.space_data, context.region, context.region_data
    through_camera = view.view_perspective == "CAMERA"
    render = scene.render
    if through_camera and render.use_border:
        border = render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y
    elif not through_camera and space.use_render_border:
        border = (
            space.render_border_min_x,
            space.render_border_max_x,
            space.render_border_min_y,
            space.render_border_max_y,
        )
    else:
        return None
    low, high = (0.0, 0.0), (1.0, 1.0)  # of what the border is a part of, from the lower left
    if through_camera:
        frame = camera_frame(camera_of(context, scene), scene, region, view)
        if frame is None:
            return None
        low, high = frame
    width, height = high[0] - low[0], high[1] - low[1]
    x0, x1 = (clamped(low[0] + width * x) for x in border[:2])
    y1, y0 = (clamped(1 - low[1] - height * y) for y in border[2:])
    return (x0, x1, y0, y1) if x0 < x1 and y0 < y1 else None


def camera_frame(camera, scene, region, view):
    """Lower left and upper right of the camera's picture, from 0 to 1 across the viewport from its lower left."""
    if camera is None or camera.type != "CAMERA":
        return None
    found = [
        location_3d_to_region_2d(region, view, camera.matrix_world @ corner)
        for corner in camera.data.view_frame(scene=scene)
    ]
    if any(corner is None for corner in found):
        return None
    xs, ys = [c.x / region.width for c in found], [c.y / region.height for c in found]
    return (min(xs), min(ys)), (max(xs), max(ys))


def clamped(value):
    return min(1.0, max(0.0, value))
