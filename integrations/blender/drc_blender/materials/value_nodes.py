"""Nodes that give numbers, colours and vectors, as expressions. Each function here takes the reader and the output
socket, and returns the expression of that output."""
import numpy as np

from . import noise
from .blackbody import blackbody
from .colour_maths import BLENDS, NUMBERS, brightness_contrast, hue_saturation, mapped_range, rotation
from .expressions import SPACE, UV, Expression, as_colour, as_number, combined, constant
from .image_lookup import equirectangular, mirror_ball


def _value(reader, at):
    return constant(float(at.socket.default_value))


def _rgb(reader, at):
    return constant(*tuple(at.socket.default_value)[:3])


def _coordinates(reader, at):
    name = at.socket.name
    if name == "UV":
        return uv_map("")
    if name == "Normal":
        return _of_place("normal")
    if name == "Object":
        if at.node.object is None:
            return _of_place("object")
        inverse = np.linalg.inv(np.array(at.node.object.matrix_world)).astype(np.float32)
        return combined(lambda p: p @ inverse[:3, :3].T + inverse[:3, 3], _of_place("position"))
    if name == "Generated":
        return _of_place("generated")
    return reader.unsupported(at, f"the texture coordinate '{name}' has no equal; Generated is used", _of_place("generated"))


def _of_place(name):
    def values(points):
        found = getattr(points, name)
        return np.zeros((1, 3), dtype=np.float32) if found is None else found

    return Expression(values, [(SPACE,)])


def uv_map(name):
    def values(points):
        uv = points.uv(name)
        return np.concatenate([uv, np.zeros((len(uv), 1), dtype=np.float32)], axis=1)

    return Expression(values, [(UV, name)])


def _uv_map(reader, at):
    return uv_map(at.node.uv_map)


def _geometry(reader, at):
    name = at.socket.name
    if name in ("Position", "Normal", "True Normal"):
        return _of_place("position" if name == "Position" else "normal")
    if name == "Backfacing":
        return reader.unsupported(at, "which side is seen cannot be told; the front is taken", constant(0.0))
    return reader.unsupported(at, f"'{name}' of Geometry has no equal; 0 is used", constant(0.0))


def _attribute(reader, at):
    name = getattr(at.node, "layer_name", None) or getattr(at.node, "attribute_name", "")

    def values(points):
        found = points.attributes.get(name)
        if found is None and not name:
            found = next(iter(points.attributes.values()), None)
        if found is None and name in points.uvs:
            uv = points.uvs[name]
            found = np.concatenate([uv, np.zeros((len(uv), 1), dtype=np.float32)], axis=1)
        return np.zeros((1, 3), dtype=np.float32) if found is None else found

    colour = Expression(values, [(SPACE,)])
    if at.socket.name == "Alpha":
        return constant(1.0)
    return as_number(colour) if at.socket.name == "Fac" else colour


def _mapping(reader, at):
    vector = reader.value(at.input("Vector"))
    location, turn, scale = (reader.value(at.input(n)) if at.input(n) else constant(0.0, 0.0, 0.0)
                             for n in ("Location", "Rotation", "Scale"))
    kind = at.node.vector_type

    def mapped(v, location, turn, scale):
        if kind == "TEXTURE":
            v = np.einsum("nij,ni->nj", rotation(turn), v - location)
            return v / np.where(scale == 0, 1, scale)
        if kind == "NORMAL":
            v = np.einsum("nij,nj->ni", rotation(turn), v / np.where(scale == 0, 1, scale))
            return v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1e-20)
        v = np.einsum("nij,nj->ni", rotation(turn), np.broadcast_to(v * scale, np.broadcast_shapes(v.shape, scale.shape)))
        return v if kind == "VECTOR" else v + location

    return combined(mapped, vector, location, turn, scale)


def _texture_vector(reader, at, without):
    """The Vector input of a texture, or the coordinates that count if nothing is linked."""
    socket = at.input("Vector")
    if socket is None or socket.source().socket == socket.socket:
        return without
    return as_colour(reader.value(socket))


def _image(reader, at):
    node = at.node
    image = node.image
    if image is None:
        return constant(0.0) if at.socket.name == "Alpha" else constant(0.0, 0.0, 0.0)
    pixels = reader.images.pixels(image)
    if pixels is None:
        return reader.unsupported(at, f"the image '{image.name}' cannot be read; it is magenta, as in Cycles",
                                  constant(1.0) if at.socket.name == "Alpha" else constant(1.0, 0.0, 1.0))
    if image.source in ("TILED", "SEQUENCE", "MOVIE"):
        reader.unsupported(at, f"of the image '{image.name}', only one picture is used")
    vector = _texture_vector(reader, at, uv_map(""))
    if node.projection != "FLAT":
        reader.unsupported(at, f"the projection {node.projection.title()} has no equal; Flat is used")
    alpha = at.socket.name == "Alpha"

    def looked_up(v):
        found = pixels.lookup(v[:, :2], node.extension, node.interpolation)
        return found[:, 3:] if alpha else found[:, :3]

    made = combined(looked_up, vector)
    made.image = None if alpha else at
    return made


def _environment(reader, at):
    node = at.node
    pixels = reader.images.pixels(node.image) if node.image is not None else None
    if pixels is None:
        return reader.unsupported(at, "the environment's image is missing; it is magenta, as in Cycles", constant(1.0, 0.0, 1.0))
    project = equirectangular if node.projection == "EQUIRECTANGULAR" else mirror_ball

    def looked_up(v):
        v = v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1e-20)
        return pixels.lookup(project(v), "REPEAT", node.interpolation)[:, :3]

    return combined(looked_up, _texture_vector(reader, at, _of_place("generated")))


def _sky(reader, at):
    sky = reader.sky(at.node)
    if isinstance(sky, str):
        return reader.unsupported(at, sky + "; it is black", constant(0.0, 0.0, 0.0))

    def looked_up(v):
        v = v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1e-20)
        found = sky.pixels.lookup(equirectangular(v), "REPEAT", "Linear")[:, :3]
        return found + sky.sun_radiance if reader.suns_shown and sky.sun_radiance is not None else found

    return combined(looked_up, _texture_vector(reader, at, _of_place("generated")))


def _scaled(reader, at):
    return combined(lambda v, s: v * s, _texture_vector(reader, at, _of_place("generated")), reader.value(at.input("Scale")))


def _noise(reader, at):
    node = at.node
    if node.noise_dimensions != "3D":
        reader.unsupported(at, f"noise of {node.noise_dimensions} has no equal; that of 3D is used")
    if getattr(node, "noise_type", "FBM") != "FBM":
        reader.unsupported(at, f"noise of the kind {node.noise_type} has no equal; fBM is used")
    numbers = []
    for name, default in (("Detail", 2.0), ("Roughness", 0.5), ("Lacunarity", 2.0), ("Distortion", 0.0)):
        socket = at.input(name)
        value = reader.value(socket) if socket is not None else constant(default)
        if not value.is_constant:
            reader.unsupported(at, f"{name} of noise is taken as constant")
            value = constant(default)
        numbers.append(float(value.constant()[0]))
    coloured = at.socket.name == "Color"
    return combined(lambda p: noise.noise(p, *numbers, getattr(node, "normalize", True), coloured), _scaled(reader, at))


def _checker(reader, at):
    which = combined(noise.checker, _scaled(reader, at))
    if at.socket.name != "Color":
        return which
    return combined(lambda w, a, b: w * a + (1 - w) * b, which, reader.value(at.input("Color1")), reader.value(at.input("Color2")))


def _gradient(reader, at):
    value = combined(lambda p: noise.gradient(p, at.node.gradient_type), _texture_vector(reader, at, _of_place("generated")))
    return as_colour(value) if at.socket.name == "Color" else value


def _brick(reader, at):
    node = at.node
    names = ("Mortar Size", "Mortar Smooth", "Bias", "Brick Width", "Row Height")
    sizes = [reader.value(at.input(n)) for n in names]
    if not all(s.is_constant for s in sizes):
        reader.unsupported(at, "the sizes of bricks are taken as constant")
    sizes = [float(s.constant()[0]) for s in sizes]
    patterns = combined(lambda p: np.concatenate(noise.bricks(
        p, *sizes, node.offset, node.offset_frequency, node.squash, node.squash_frequency), axis=1), _scaled(reader, at))
    if at.socket.name != "Color":
        return combined(lambda p: p[:, 1:2], patterns)
    return combined(lambda p, a, b, m: ((1 - p[:, :1]) * a + p[:, :1] * b) * (1 - p[:, 1:2]) + p[:, 1:2] * m, patterns,
                    *(reader.value(at.input(n)) for n in ("Color1", "Color2", "Mortar")))


def _maths(reader, at):
    node = at.node
    function = NUMBERS.get(node.operation)
    if function is None:
        return reader.unsupported(at, f"the operation {node.operation} has no equal; its first input is used", reader.value(at.inputs()[0]))
    count = function.__code__.co_argcount
    made = combined(lambda *v: function(*v), *(as_number(reader.value(s)) for s in at.inputs()[:count]))
    return combined(lambda v: np.clip(v, 0, 1), made) if node.use_clamp else made


def _vector_maths(reader, at):
    kind = at.node.operation
    v = [as_colour(reader.value(s)) if s.socket.type != "VALUE" else reader.value(s) for s in at.inputs()]
    simple = {"ADD": np.add, "SUBTRACT": np.subtract, "MULTIPLY": np.multiply, "MINIMUM": np.minimum, "MAXIMUM": np.maximum}
    if kind in simple:
        return combined(simple[kind], v[0], v[1])
    single = {"ABSOLUTE": np.abs, "FLOOR": np.floor, "CEIL": np.ceil, "FRACTION": lambda x: x - np.floor(x),
              "SINE": np.sin, "COSINE": np.cos, "TANGENT": np.tan,
              "NORMALIZE": lambda x: x / np.maximum(np.linalg.norm(x, axis=1, keepdims=True), 1e-20)}
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
        return _blended(reader, at, node.blend_type, as_number(factor), as_colour(a), as_colour(b), node.clamp_factor, node.clamp_result)
    return _blended(reader, at, "MIX", factor, a, b, node.clamp_factor, False)


def _mix_rgb(reader, at):
    factor, a, b = (reader.value(s) for s in at.inputs()[:3])
    return _blended(reader, at, at.node.blend_type, as_number(factor), as_colour(a), as_colour(b), True, at.node.use_clamp)


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
        return combined(lambda t, v: v + t * (np.interp(v, x, tables[0]) - v), reader.value(inputs[0]), as_number(reader.value(inputs[1])))

    def curved(t, c):
        level = (c - black) / np.where(white == black, 1, white - black)
        found = np.stack([np.interp(np.interp(level[:, i], x, tables[3]), x, tables[i]) for i in range(3)], axis=1)
        return c + t * (found - c)

    return combined(curved, as_number(reader.value(inputs[0])), as_colour(reader.value(inputs[1])))


def _separate(reader, at):
    mode = getattr(at.node, "mode", "RGB")
    if mode != "RGB":
        reader.unsupported(at, f"the mode {mode} of Separate Color has no equal; RGB is used")
    index = {"R": 0, "Red": 0, "X": 0, "G": 1, "Green": 1, "Y": 1}.get(at.socket.name, 2)
    return combined(lambda c: c[:, index:index + 1], as_colour(reader.value(at.inputs()[0])))


def _combine(reader, at):
    mode = getattr(at.node, "mode", "RGB")
    if mode != "RGB":
        reader.unsupported(at, f"the mode {mode} of Combine Color has no equal; RGB is used")
    return combined(lambda *v: np.concatenate(np.broadcast_arrays(*v), axis=1), *(as_number(reader.value(s)) for s in at.inputs()[:3]))


def _invert(reader, at):
    return combined(lambda t, c: c + t * (1 - 2 * c), as_number(reader.value(at.inputs()[0])), as_colour(reader.value(at.inputs()[1])))


def _hue_saturation(reader, at):
    inputs = [reader.value(at.input(n)) for n in ("Hue", "Saturation", "Value")]
    factor = at.input("Fac") or at.input("Factor")
    return combined(hue_saturation, *inputs, reader.value(factor), as_colour(reader.value(at.input("Color"))))


def _gamma(reader, at):
    return combined(lambda c, g: np.where(c > 0, np.maximum(c, 1e-20) ** g, c), *(reader.value(s) for s in at.inputs()[:2]))


def _bright_contrast(reader, at):
    return combined(brightness_contrast, *(reader.value(s) for s in at.inputs()[:3]))


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
    return reader.unsupported(at, "a factor that depends on the direction of view has no equal; it is that along the normal", constant(value))


def _light_path(reader, at):
    value = 1.0 if at.socket.name == "Is Camera Ray" else 0.0
    return reader.unsupported(at, "surfaces are the same for all rays; they are as the camera sees them", constant(value))


NODES = {
    "ATTRIBUTE": _attribute, "BLACKBODY": _blackbody, "BRIGHTCONTRAST": _bright_contrast, "CLAMP": _clamp,
    "COMBINE_COLOR": _combine, "COMBRGB": _combine, "COMBXYZ": _combine, "CURVE_FLOAT": _curves, "CURVE_RGB": _curves,
    "CURVE_VEC": _curves, "FRESNEL": _at_the_normal, "GAMMA": _gamma, "HUE_SAT": _hue_saturation, "INVERT": _invert,
    "LAYER_WEIGHT": _at_the_normal, "LIGHT_PATH": _light_path, "MAPPING": _mapping, "MAP_RANGE": _map_range,
    "MATH": _maths, "MIX": _mix, "MIX_RGB": _mix_rgb, "NEW_GEOMETRY": _geometry, "RGB": _rgb, "RGBTOBW": _grey,
    "SEPARATE_COLOR": _separate, "SEPRGB": _separate, "SEPXYZ": _separate, "TEX_BRICK": _brick, "TEX_CHECKER": _checker,
    "TEX_COORD": _coordinates, "TEX_ENVIRONMENT": _environment, "TEX_GRADIENT": _gradient, "TEX_IMAGE": _image,
    "TEX_NOISE": _noise, "TEX_SKY": _sky, "UVMAP": _uv_map, "VALTORGB": _colour_ramp, "VALUE": _value, "VECT_MATH": _vector_maths,
    "VERTEX_COLOR": _attribute,
}
