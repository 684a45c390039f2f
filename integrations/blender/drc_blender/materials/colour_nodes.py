"""Nodes that change colours. Each function takes the
reader and the output socket, and returns the expression of that output."""

import numpy as np

from .colour_maths import BLENDS, brightness_contrast, hue_saturation
from .expressions import as_colour, as_number, combined


def _blended(reader, at, kind, factor, a, b, clamp_factor, clamp_result):
    function = BLENDS.get(kind)
    if function is None:
        function = BLENDS["MIX"]
        reader.unsupported(at, f"the blend mode {kind} has no equal; Mix is used")

    def blend(t, a, b):
        t = np.clip(t, 0, 1) if clamp_factor else t
        found = function(t, a, b)
        return np.clip(found, 0, 1) if clamp_result else found

    return combined(blend, factor, a, b)


def _mix(reader, at):
    node = at.node
    inputs = {s.socket.name: s for s in at.inputs()}
    factor, a, b = (reader.value(inputs[n]) for n in ("Factor", "A", "B"))
    if node.data_type == "RGBA":
        return _blended(
            reader,
            at,
            node.blend_type,
            as_number(factor),
            as_colour(a),
            as_colour(b),
            node.clamp_factor,
            node.clamp_result,
        )
    return _blended(reader, at, "MIX", factor, a, b, node.clamp_factor, False)


def _mix_rgb(reader, at):
    factor, a, b = (reader.value(s) for s in at.inputs()[:3])
    return _blended(
        reader, at, at.node.blend_type, as_number(factor), as_colour(a), as_colour(b), True, at.node.use_clamp
    )


STEPS = 4096


def _colour_ramp(reader, at):
    ramp = at.node.color_ramp
    table = np.array([ramp.evaluate(i / (STEPS - 1)) for i in range(STEPS)], dtype=np.float32)
    table = table[:, 3:] if at.socket.name == "Alpha" else table[:, :3]
    x = np.linspace(0, 1, STEPS)
    nearest = ramp.interpolation == "CONSTANT"

    def ramped(f):
        f = np.clip(f[:, 0], 0, 1)
        if nearest:
            return table[np.minimum((f * (STEPS - 1)).astype(int), STEPS - 1)]
        return np.stack([np.interp(f, x, column) for column in table.T], axis=1)

    return combined(ramped, as_number(reader.value(at.inputs()[0])))


def _curves(reader, at):
    mapping = at.node.mapping
    mapping.initialize()
    low, high = mapping.clip_min_x if mapping.use_clip else 0.0, mapping.clip_max_x if mapping.use_clip else 1.0
    x = np.linspace(min(low, 0.0), max(high, 1.0), STEPS)
    tables = [np.array([mapping.evaluate(curve, float(v)) for v in x]) for curve in mapping.curves]
    black, white = np.array(mapping.black_level), np.array(mapping.white_level)
    inputs = at.inputs()
    if len(tables) == 1:  # Float Curve
        return combined(
            lambda t, v: v + t * (np.interp(v, x, tables[0]) - v),
            reader.value(inputs[0]),
            as_number(reader.value(inputs[1])),
        )

    def curved(t, c):
        level = (c - black) / np.where(white == black, 1, white - black)
        found = np.stack([np.interp(np.interp(level[:, i], x, tables[3]), x, tables[i]) for i in range(3)], axis=1)
        return c + t * (found - c)

    return combined(curved, as_number(reader.value(inputs[0])), as_colour(reader.value(inputs[1])))


def _invert(reader, at):
    return combined(
        lambda t, c: c + t * (1 - 2 * c),
        as_number(reader.value(at.inputs()[0])),
        as_colour(reader.value(at.inputs()[1])),
    )


def _hue_saturation(reader, at):
    inputs = [reader.value(at.input(n)) for n in ("Hue", "Saturation", "Value")]
    factor = at.input("Fac") or at.input("Factor")
    return combined(hue_saturation, *inputs, reader.value(factor), as_colour(reader.value(at.input("Color"))))


def _gamma(reader, at):
    return combined(
        lambda c, g: np.where(c > 0, np.maximum(c, 1e-20) ** g, c), *(reader.value(s) for s in at.inputs()[:2])
    )


def _bright_contrast(reader, at):
    return combined(brightness_contrast, *(reader.value(s) for s in at.inputs()[:3]))


NODES = {
    "BRIGHTCONTRAST": _bright_contrast,
    "CURVE_FLOAT": _curves,
    "CURVE_RGB": _curves,
    "CURVE_VEC": _curves,
    "GAMMA": _gamma,
    "HUE_SAT": _hue_saturation,
    "INVERT": _invert,
    "MIX": _mix,
    "MIX_RGB": _mix_rgb,
    "VALTORGB": _colour_ramp,
}
