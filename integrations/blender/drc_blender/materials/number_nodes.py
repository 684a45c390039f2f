"""Constants, arithmetic on numbers and vectors, and what is taken as constant. Each function takes the
reader and the output socket, and returns the expression of that output."""

import numpy as np

from .blackbody import blackbody
from .colour_maths import NUMBERS, mapped_range
from .expressions import as_colour, as_number, combined, constant
from .ray_kinds import KNOWN, TOLD


def _value(reader, at):
    return constant(float(at.socket.default_value))


def _rgb(reader, at):
    return constant(*tuple(at.socket.default_value)[:3])


def _maths(reader, at):
    node = at.node
    function = NUMBERS.get(node.operation)
    if function is None:
        return reader.unsupported(
            at, f"the operation {node.operation} has no equal; its first input is used", reader.value(at.inputs()[0])
        )
    count = function.__code__.co_argcount
    made = combined(lambda *v: function(*v), *(as_number(reader.value(s)) for s in at.inputs()[:count]))
    return combined(lambda v: np.clip(v, 0, 1), made) if node.use_clamp else made


def _vector_maths(reader, at):
    kind = at.node.operation
    v = [as_colour(reader.value(s)) if s.socket.type != "VALUE" else reader.value(s) for s in at.inputs()]
    simple = {
        "ADD": np.add,
        "SUBTRACT": np.subtract,
        "MULTIPLY": np.multiply,
        "MINIMUM": np.minimum,
        "MAXIMUM": np.maximum,
    }
    if kind in simple:
        return combined(simple[kind], v[0], v[1])
    single = {
        "ABSOLUTE": np.abs,
        "FLOOR": np.floor,
        "CEIL": np.ceil,
        "FRACTION": lambda x: x - np.floor(x),
        "SINE": np.sin,
        "COSINE": np.cos,
        "TANGENT": np.tan,
        "NORMALIZE": lambda x: x / np.maximum(np.linalg.norm(x, axis=1, keepdims=True), 1e-20),
    }
    if kind in single:
        return combined(single[kind], v[0])
    if kind == "DIVIDE":
        return combined(lambda a, b: np.where(b == 0, 0, a / np.where(b == 0, 1, b)), v[0], v[1])
    if kind == "SCALE":
        return combined(np.multiply, v[0], v[-1])
    if kind == "MULTIPLY_ADD":
        return combined(lambda a, b, c: a * b + c, *v[:3])
    if kind == "DOT_PRODUCT":
        return combined(lambda a, b: np.sum(a * b, axis=1, keepdims=True), v[0], v[1])
    if kind == "CROSS_PRODUCT":
        return combined(lambda a, b: np.cross(a, b), v[0], v[1])
    if kind == "LENGTH":
        return combined(lambda a: np.linalg.norm(a, axis=1, keepdims=True), v[0])
    if kind == "DISTANCE":
        return combined(lambda a, b: np.linalg.norm(a - b, axis=1, keepdims=True), v[0], v[1])
    return reader.unsupported(at, f"the vector operation {kind} has no equal; its first input is used", v[0])


def _separate(reader, at):
    mode = getattr(at.node, "mode", "RGB")
    if mode != "RGB":
        reader.unsupported(at, f"the mode {mode} of Separate Color has no equal; RGB is used")
    index = {"R": 0, "Red": 0, "X": 0, "G": 1, "Green": 1, "Y": 1}.get(at.socket.name, 2)
    return combined(lambda c: c[:, index : index + 1], as_colour(reader.value(at.inputs()[0])))


def _combine(reader, at):
    mode = getattr(at.node, "mode", "RGB")
    if mode != "RGB":
        reader.unsupported(at, f"the mode {mode} of Combine Color has no equal; RGB is used")
    return combined(
        lambda *v: np.concatenate(np.broadcast_arrays(*v), axis=1),
        *(as_number(reader.value(s)) for s in at.inputs()[:3]),
    )


def _clamp(reader, at):
    value, low, high = (as_number(reader.value(s)) for s in at.inputs()[:3])
    if at.node.clamp_type == "RANGE":
        return combined(lambda v, a, b: np.clip(v, np.minimum(a, b), np.maximum(a, b)), value, low, high)
    return combined(lambda v, a, b: np.minimum(np.maximum(v, a), b), value, low, high)


def _map_range(reader, at):
    kind = at.node.interpolation_type
    if kind not in ("LINEAR", "SMOOTHSTEP", "SMOOTHERSTEP") or getattr(at.node, "data_type", "FLOAT") != "FLOAT":
        reader.unsupported(at, "this kind of Map Range has no equal; it is linear")
    inputs = [as_number(reader.value(s)) for s in at.inputs()[:5]]
    return combined(lambda *v: mapped_range(kind, at.node.clamp, *v), *inputs)


def _grey(reader, at):
    return as_number(reader.value(at.inputs()[0]))


def _blackbody(reader, at):
    value = as_number(reader.value(at.inputs()[0]))
    if not value.is_constant:
        reader.unsupported(at, "the temperature is taken as constant")
    return constant(*blackbody(float(value.constant()[0])))


def _at_the_normal(reader, at):
    """What a factor that depends on the direction of view is along the normal."""
    if at.node.type == "FRESNEL":
        ior = max(float(reader.value(at.input("IOR")).constant()[0]), 1e-5)
        value = ((ior - 1) / (ior + 1)) ** 2
    else:
        value = 0.0
    return reader.unsupported(
        at, "a factor that depends on the direction of view has no equal; it is that along the normal", constant(value)
    )


def _light_path(reader, at):
    name = at.socket.name
    value = constant(1.0 if name in TOLD[reader.ray or "camera"] else 0.0)
    reader.rays_matter = True
    if reader.ray is not None and name in KNOWN:
        return value
    return reader.unsupported(at, f"'{name}' of Light Path has no equal; it is that of the camera's rays", value)


NODES = {
    "BLACKBODY": _blackbody,
    "CLAMP": _clamp,
    "COMBINE_COLOR": _combine,
    "COMBRGB": _combine,
    "COMBXYZ": _combine,
    "FRESNEL": _at_the_normal,
    "LAYER_WEIGHT": _at_the_normal,
    "LIGHT_PATH": _light_path,
    "MAP_RANGE": _map_range,
    "MATH": _maths,
    "RGB": _rgb,
    "RGBTOBW": _grey,
    "SEPARATE_COLOR": _separate,
    "SEPRGB": _separate,
    "SEPXYZ": _separate,
    "VALUE": _value,
    "VECT_MATH": _vector_maths,
}
