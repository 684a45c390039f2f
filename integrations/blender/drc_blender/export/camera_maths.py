"""What a Blender camera sees, as pbrt's screen window, lens and crop window."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Lens:
    """The settings of a camera that decide which part of space is in the picture."""

    orthographic: bool = False
    focal_length: float = 50.0  # mm
    ortho_scale: float = 6.0  # world units
    sensor_width: float = 36.0  # mm
    sensor_height: float = 24.0
    sensor_fit: str = "AUTO"  # or HORIZONTAL, VERTICAL
    shift_x: float = 0.0  # of the longer side, or of that which the sensor is fitted to
    shift_y: float = 0.0


def screen_window(lens, width, height, pixel_aspect=1.0):
    """(x0, x1, y0, y1) on the plane at distance 1 or, of an orthographic camera, in world units.

    width, height: of the picture in pixels; pixel_aspect: height of a pixel over its width.
    """
    tall = height * pixel_aspect
    fit = lens.sensor_fit
    if fit == "AUTO":
        fit = "HORIZONTAL" if width >= tall else "VERTICAL"
        sensor = lens.sensor_width
    else:
        sensor = lens.sensor_width if fit == "HORIZONTAL" else lens.sensor_height
    fitted = width if fit == "HORIZONTAL" else tall
    per_pixel = (lens.ortho_scale if lens.orthographic else sensor / lens.focal_length) / fitted
    x, y = lens.shift_x * fitted, lens.shift_y * fitted
    return tuple(per_pixel * v for v in (x - width / 2, x + width / 2, y - tall / 2, y + tall / 2))


def lens_radius(orthographic, focal_length, f_stop):
    """In world units, taken as metres. As in Cycles, the aperture of an orthographic camera is 1 m over the f-stop."""
    aperture = 1.0 if orthographic else focal_length * 1e-3
    return aperture / (2 * max(f_stop, 1e-5))


def pixel_bounds(border, width, height):
    """(x0, x1, y0, y1) of a render region, in pixels from the top left; border: (x0, x1, y0, y1) in [0, 1], from the
    bottom left. As in Blender, edges are rounded towards the lower left, and a region has a pixel at least."""
    x0, x1 = int(border[0] * width), int(border[1] * width)
    y0, y1 = int(border[2] * height), int(border[3] * height)
    x0, y0 = max(0, min(x0, width - 1)), max(0, min(y0, height - 1))
    x1, y1 = max(x0 + 1, min(x1, width)), max(y0 + 1, min(y1, height))
    return x0, x1, height - y1, height - y0


def filter_sigma(width):
    """Standard deviation, in pixels, of Cycles' Blackman-Harris filter of this width, by its variance."""
    return 0.1385 * width
