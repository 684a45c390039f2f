#!/usr/bin/env python3
"""Makes the bathroom scene: green glazed tiles, a bathtub, a basin. Python's standard library only.

    python3 scenes/bathroom/make.py

writes scene.pbrt, geometry/*.ply and textures/*.png beside this file. Metres, z up: the room is 3.2 m (x) by 3.8 m (y) by
2.6 m, its window in the wall x = 0. Everything here is CC0.
"""
import math
import os
import random
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(HERE))
from modelling import (ROOM, Frame, add, box, cross, emit, glossy, grid, lathe, matte, meshes, mul, quad, rgb, rod,  # noqa: E402
                       rounded_box, sub, unit, value_noise, write_ply, write_png)

random.seed(7)
LATTICE = [random.random() for _ in range(4096)]
noise = value_noise(LATTICE)

WIDTH, DEPTH, HEIGHT, THICK = 3.2, 3.8, 2.6, 0.3
TILED = 2.0                       # the tiles end here
WINDOW = (1.95, 3.05, 1.0, 2.15)  # y0 y1 z0 z1
DOOR = (1.55, 2.37, 2.02)         # x0 x1 z1, in the wall y = 0
GAP = 0.004                       # tiles stand this far out of the grout; their faces lie in the walls' planes


# ---- textures ------------------------------------------------------------------------------------------------------
# An atlas of 4 x 8 pieces of glaze: each tile shows one of them.
def glaze(u, v):
    cell = int(u * 4) + 4 * int(v * 8)
    tone = 0.88 + 0.22 * LATTICE[cell * 31 + 5]
    cloud = noise(u * 40 + cell, v * 80, 512)
    tone *= 0.95 + 0.10 * cloud
    hue = LATTICE[cell * 17 + 2] - 0.5
    return (0.42 * tone - 0.05 * hue, 0.665 * tone, 0.53 * tone + 0.06 * hue)


def stone(u, v):
    cell = int(u * 4) + 4 * int(v * 8)
    tone = 0.95 + 0.07 * LATTICE[cell * 29 + 11] - 0.05 * noise(u * 48, v * 96 + cell, 512)
    return (0.86 * tone, 0.84 * tone, 0.79 * tone)


def oak(u, v):
    grain = 0.6 * noise(u * 6, v * 90, 512) + 0.4 * noise(u * 20, v * 240, 512)
    tone = 0.82 + 0.30 * grain
    return (0.70 * tone, 0.53 * tone, 0.36 * tone)


# ---- tiles ---------------------------------------------------------------------------------------------------------
def shrink(corners, by):
    """A convex anticlockwise polygon, its edges moved inwards."""
    lines = []
    for k, (x, y) in enumerate(corners):
        x1, y1 = corners[(k + 1) % len(corners)]
        length = math.hypot(x1 - x, y1 - y)
        n = (-(y1 - y) / length, (x1 - x) / length)
        lines.append((n, n[0] * x + n[1] * y + by))
    inner = []
    for k, (n, d) in enumerate(lines):
        m, e = lines[k - 1]
        det = m[0] * n[1] - m[1] * n[0]
        inner.append(((e * n[1] - m[1] * d) / det, (m[0] * d - e * n[0]) / det))
    return inner


def clip(corners, n, d):
    """The part of a convex polygon where n . p >= d."""
    kept = []
    for k, p in enumerate(corners):
        q = corners[(k + 1) % len(corners)]
        a, b = n[0] * p[0] + n[1] * p[1] - d, n[0] * q[0] + n[1] * q[1] - d
        if a >= 0:
            kept.append(p)
        if (a < 0) != (b < 0):
            t = a / (a - b)
            kept.append((p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])))
    return [p for k, p in enumerate(kept) if math.dist(p, kept[k - 1]) > 1e-6]


def tile(material, corners, plane, tilt, size, bevel=0.005):
    """A tile with rounded edges, set by hand: it does not lie quite flat. `size` spans its piece of the atlas."""
    origin, right, up = plane
    n = cross(right, up)
    a, b = random.gauss(0, tilt), random.gauss(0, tilt)
    cell = random.randrange(32)
    x0, y0 = min(p[0] for p in corners), min(p[1] for p in corners)
    mx, my = sum(p[0] for p in corners) / len(corners), sum(p[1] for p in corners) / len(corners)
    outer, inner = shrink(corners, 0.0015), shrink(corners, bevel)
    vertices, count = [], len(corners)

    def place(p, height, normal):
        q = add(origin, add(mul(right, p[0]), add(mul(up, p[1]), mul(n, height))))
        s, t = 0.08 + 0.84 * min(1, (p[0] - x0) / size[0]), 0.08 + 0.84 * min(1, (p[1] - y0) / size[1])
        world = add(mul(right, normal[0]), add(mul(up, normal[1]), mul(n, normal[2])))
        vertices.append((q, unit(world), ((cell % 4 + s) / 4, (cell // 4 + t) / 8)))
    for p in inner:
        place(p, a * (p[0] - mx) + b * (p[1] - my), (-a + 0.15 * (p[0] - mx), -b + 0.15 * (p[1] - my), 1))
    for p, q in zip(outer, inner):
        place(p, -GAP - 0.001, (1.2 * (p[0] - q[0]), 1.2 * (p[1] - q[1]), bevel))
    faces = [(0, k, k + 1) for k in range(1, count - 1)]
    for k in range(count):
        j = (k + 1) % count
        faces += [(count + k, count + j, j), (count + k, j, k)]
    emit(material, vertices, faces, ROOM)


def without(rect, hole):
    """The up to four rectangles that are left of x0 y0 x1 y1."""
    x0, y0, x1, y1 = rect
    hx0, hy0, hx1, hy1 = hole
    if hx0 >= x1 or hx1 <= x0 or hy0 >= y1 or hy1 <= y0:
        return [rect]
    a, b = max(x0, hx0), min(x1, hx1)
    return [(x0, y0, min(x1, hx0), y1), (max(x0, hx1), y0, x1, y1), (a, y0, b, min(y1, hy0)), (a, max(y0, hy1), b, y1)]


def tiled_wall(origin, right, length, hole=None):
    """Bricks of 20 x 10 cm, half overlapping; the lowest course is dark."""
    w, h = 0.2, 0.1
    for row in range(round(TILED / h)):
        x = -w / 2 * (row % 2)
        while x < length - 1e-6:
            rect = (max(0, x), row * h, min(length, x + w), (row + 1) * h)
            for x0, y0, x1, y1 in without(rect, hole) if hole else [rect]:
                if x1 - x0 > 0.015 and y1 - y0 > 0.015:
                    tile("dark_tile" if row == 0 else "tile", [(x0, y0), (x1, y0), (x1, y1), (x0, y1)],
                         (origin, right, (0, 0, 1)), 0.004, (w, h))
            x += w


def tiled_floor():
    """Hexagons 15 cm wide, a dark one here and there."""
    w = 0.15
    r = w / math.sqrt(3)
    for row in range(int(DEPTH / (1.5 * r)) + 2):
        for column in range(int(WIDTH / w) + 2):
            x, y = (column + 0.5 * (row % 2)) * w, row * 1.5 * r
            corners = [(x + r * math.cos(math.radians(60 * k - 30)), y + r * math.sin(math.radians(60 * k - 30))) for k in range(6)]
            for n, d in (((1, 0), 0), ((-1, 0), -WIDTH), ((0, 1), 0), ((0, -1), -DEPTH)):
                corners = clip(corners, n, d) if corners else []
            if len(corners) < 3:
                continue
            width = max(p[0] for p in corners) - min(p[0] for p in corners)
            depth = max(p[1] for p in corners) - min(p[1] for p in corners)
            if min(width, depth) < 0.015:
                continue
            dark = row % 4 == 0 and column % 4 == (0 if row % 8 == 0 else 2)
            tile("dark_tile" if dark else "floor", corners, ((0, 0, 0), (1, 0, 0), (0, 1, 0)), 0.002, (w, 2 * r), 0.004)


# ---- the room ------------------------------------------------------------------------------------------------------
def shell():
    t = THICK
    y0, y1, z0, z1 = WINDOW
    top, low = HEIGHT + t, -t
    # Slabs that overlap at their edges: light has no seam to come through. Up to TILED they are grout, behind the tiles.
    box("grout", (-t, -t, -t), (WIDTH + t, DEPTH + t, -GAP))
    box("ceiling", (-t, -t, HEIGHT), (WIDTH + t, DEPTH + t, top))
    for material, z_low, z_high, g in (("grout", low, TILED, GAP), ("plaster", TILED, top, 0)):
        box(material, (-t, DEPTH + g, z_low), (WIDTH + t, DEPTH + t, z_high))
        box(material, (-t, -t, z_low), (WIDTH + t, -g, z_high))
        box(material, (WIDTH + g, -t, z_low), (WIDTH + t, DEPTH + t, z_high))
        box(material, (-t, -t, z_low), (-g, y0, z_high))
        box(material, (-t, y1, z_low), (-g, DEPTH + t, z_high))
    box("grout", (-t, y0 - 0.01, -t), (-GAP, y1 + 0.01, z0))
    box("plaster", (-t, y0 - 0.01, z1), (0, y1 + 0.01, top))
    # Plaster lines the window's reveal.
    e = 0.002
    box("plaster", (-t, y0, z0 - 0.01), (-0.004, y0 + e, z1))
    box("plaster", (-t, y1 - e, z0 - 0.01), (-0.004, y1, z1))

    tiled_wall((0, DEPTH, 0), (1, 0, 0), WIDTH)
    tiled_wall((WIDTH, DEPTH, 0), (0, -1, 0), DEPTH)
    tiled_wall((0, 0, 0), (0, 1, 0), DEPTH, (y0 - 0.03, z0 - 0.02, y1 + 0.03, z1))
    tiled_wall((WIDTH, 0, 0), (-1, 0, 0), WIDTH, (WIDTH - DOOR[1] - 0.03, 0, WIDTH - DOOR[0] + 0.03, DOOR[2]))
    tiled_floor()

    # A dark moulding ends the tiles.
    r = 0.012
    for lo, hi in (((0, DEPTH - r, 0), (WIDTH, DEPTH + r, 0)), ((WIDTH - r, 0, 0), (WIDTH + r, DEPTH, 0)),
                   ((-r, 0, 0), (r, y0 - 0.06, 0)), ((-r, y1 + 0.06, 0), (r, DEPTH, 0)),
                   ((0, -r, 0), (DOOR[0] - 0.07, r, 0)), ((DOOR[1] + 0.07, -r, 0), (WIDTH, r, 0))):
        rounded_box("dark_tile", (lo[0], lo[1], TILED - 0.004), (hi[0], hi[1], TILED + 0.026), r, ROOM, 4)


def window():
    y0, y1, z0, z1 = WINDOW
    e = 0.002
    # The casing around the opening, and the sill.
    w, d = 0.06, 0.018
    for lo, hi in (((-0.01, y0 - w, z0), (d, y0 + 0.004, z1 + w)), ((-0.01, y1 - 0.004, z0), (d, y1 + w, z1 + w)),
                   ((-0.01, y0, z1 - 0.004), (d, y1, z1 + w))):
        rounded_box("paint", lo, hi, 0.005)
    rounded_box("paint", (-0.24, y0 + e, z0 - 0.03), (0.0, y1 - e, z0 + 0.006), 0.006)
    rounded_box("paint", (-0.02, y0 - w - 0.02, z0 - 0.03), (0.07, y1 + w + 0.02, z0 + 0.006), 0.008)
    # The frame: two frosted panes below, open above.
    x0, x1, f, split = -0.20, -0.145, 0.05, 1.66
    mid = (y0 + y1) / 2
    for lo, hi in (((x0, y0 + e, z0), (x1, y1 - e, z0 + f)), ((x0, y0 + e, z1 - f), (x1, y1 - e, z1 - e)),
                   ((x0, y0 + e, z0), (x1, y0 + f, z1 - e)), ((x0, y1 - f, z0), (x1, y1 - e, z1 - e)),
                   ((x0, y0 + e, split), (x1, y1 - e, split + f)), ((x0, mid - 0.028, z0), (x1, mid + 0.028, z1 - e))):
        rounded_box("paint", lo, hi, 0.007)
    for a, b in ((y0 + f - 0.01, mid - 0.02), (mid + 0.02, y1 - f + 0.01)):
        quad("frosted", (-0.172, a, z0 + f - 0.01), (-0.172, b, z0 + f - 0.01), (-0.172, b, split + 0.01), (-0.172, a, split + 0.01))
    # What lies outside.
    quad("ground", (-30, -30, -0.5), (-THICK, -30, -0.5), (-THICK, 30, -0.5), (-30, 30, -0.5))


def door():
    x0, x1, z1 = DOOR
    w = 0.07
    for lo, hi in (((x0 - w, -0.02, 0), (x0, 0.02, z1 + w)), ((x1, -0.02, 0), (x1 + w, 0.02, z1 + w)), ((x0, -0.02, z1), (x1, 0.02, z1 + w))):
        rounded_box("paint", lo, hi, 0.006)
    box("paint", (x0, -0.03, 0.001), (x1, -0.008, z1))
    # Two panels, each a frame that stands out.
    for a, b in ((0.14, 0.86), (1.0, z1 - 0.14)):
        for lo, hi in (((x0 + 0.12, a), (x1 - 0.12, a + 0.03)), ((x0 + 0.12, b - 0.03), (x1 - 0.12, b)),
                       ((x0 + 0.12, a), (x0 + 0.15, b)), ((x1 - 0.15, a), (x1 - 0.12, b))):
            rounded_box("paint", (lo[0], -0.02, lo[1]), (hi[0], 0.006, hi[1]), 0.006)
    lathe("brass", ball(0.028, 0.0), Frame((x0 + 0.07, 0.045, 1.02)), 16)
    rod("brass", (x0 + 0.07, -0.01, 1.02), (x0 + 0.07, 0.045, 1.02), 0.010)


# ---- shapes --------------------------------------------------------------------------------------------------------
def ball(radius, height, steps=10):
    """A profile for lathe()."""
    points = [(radius * math.cos(a), height + radius * math.sin(a)) for a in (math.pi * (i / steps - 0.5) for i in range(steps + 1))]
    return [(0, points[0][1])] + points[1:-1] + [(0, points[-1][1])]


def spline(points, steps):
    """Catmull-Rom through points of any dimension."""
    def at(k): return points[min(max(k, 0), len(points) - 1)]
    curve = []
    for k in range(len(points) - 1):
        for i in range(steps):
            t = i / steps
            p, q, r, s = at(k - 1), at(k), at(k + 1), at(k + 2)
            curve.append(tuple(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t ** 3)
                               for a, b, c, d in zip(p, q, r, s)))
    return curve + [tuple(points[-1])]


def tube(material, points, radius, frame=ROOM, segments=14, caps=True):
    """Sweeps a circle along a curve; its ends are rounded."""
    path = list(points)
    count = len(path)
    tangents = [unit(sub(path[min(k + 1, count - 1)], path[max(k - 1, 0)])) for k in range(count)]
    side = unit(cross(tangents[0], (0, 0, 1) if abs(tangents[0][2]) < 0.9 else (1, 0, 0)))
    rings = []  # center, tangent, side, radius, slope
    for p, tangent in zip(path, tangents):
        side = unit(sub(side, mul(tangent, sum(a * b for a, b in zip(side, tangent)))))
        rings.append((p, tangent, side, radius, 0.0))
    if caps:
        def end(ring, sign):
            p, tangent, s, r, _ = ring
            return [(add(p, mul(tangent, sign * r * math.sin(a))), tangent, s, r * math.cos(a), sign * math.sin(a))
                    for a in (math.pi / 2 * k / 3 for k in range(1, 4))]
        rings = end(rings[0], -1)[::-1] + rings + end(rings[-1], 1)
    vertices, faces = [], []
    for p, tangent, s, r, slope in rings:
        up = cross(tangent, s)
        for j in range(segments + 1):
            a = 2 * math.pi * (j % segments) / segments
            out = add(mul(s, math.cos(a)), mul(up, math.sin(a)))
            n = add(mul(out, math.sqrt(max(0, 1 - slope * slope))), mul(tangent, slope))
            vertices.append((add(p, mul(out, max(r, 1e-6))), unit(n), (j / segments, 0)))
    for i in range(len(rings) - 1):
        for j in range(segments):
            a, b = i * (segments + 1) + j, i * (segments + 1) + j + 1
            c, d = b + segments + 1, a + segments + 1
            faces += [(a, b, c), (a, c, d)]
    emit(material, vertices, faces, frame)


# ---- the bathtub ---------------------------------------------------------------------------------------------------
TUB = (1.06, 3.33)  # its middle; it stands lengthwise along the back wall
# Half length, half width, height: up the outside, over the rim, down the inside.
TUB_PROFILE = spline([(0.64, 0.27, 0.0), (0.655, 0.28, 0.03), (0.70, 0.31, 0.20), (0.77, 0.345, 0.42), (0.825, 0.372, 0.545),
                      (0.850, 0.386, 0.575), (0.848, 0.385, 0.592), (0.828, 0.368, 0.600), (0.806, 0.350, 0.590),
                      (0.790, 0.336, 0.555), (0.735, 0.305, 0.38), (0.665, 0.265, 0.20), (0.60, 0.215, 0.145), (0.45, 0.15, 0.128),
                      (0.20, 0.07, 0.122), (0.0, 0.0, 0.12)], 5)


def tub_point(u, v):
    """u: around, v: along the profile."""
    k = min(max(v, 0), 1) * (len(TUB_PROFILE) - 1)
    i = min(int(k), len(TUB_PROFILE) - 2)
    a, b, z = (p + (k - i) * (q - p) for p, q in zip(TUB_PROFILE[i], TUB_PROFILE[i + 1]))
    c, s = math.cos(2 * math.pi * u), math.sin(2 * math.pi * u)
    # A superellipse: fuller than an ellipse.
    x, y = math.copysign(abs(c) ** 0.86, c), math.copysign(abs(s) ** 0.86, s)
    lift = 1 + 0.14 * max(0, z - 0.15) / 0.45 * c ** 4  # its ends are higher
    return (TUB[0] + a * x, TUB[1] + b * y, z * lift)


def tub_normal(u, v):
    e = 2e-3
    v = min(max(v, 2 * e), 1 - 2 * e)
    return unit(cross(sub(tub_point(u + e, v), tub_point(u - e, v)), sub(tub_point(u, v + e), tub_point(u, v - e))))


def bathtub():
    grid("ceramic", tub_point, 75, 60)
    # The drain, and the filler that stands between the tub and the wall.
    lathe("chrome", [(0, 0.1205), (0.028, 0.1205), (0.028, 0.1235), (0.012, 0.125), (0, 0.1245)], Frame((TUB[0], TUB[1], 0.001)), 24)
    x, y, z = TUB[0] + 0.05, 3.70, 0.80
    for dx in (-0.10, 0.10):
        tube("chrome", [(x + dx, DEPTH + 0.01, z), (x + dx, y, z)], 0.013, segments=12)
        flange(x + dx, z, 0.034)
        cross_handle((x + dx, y - 0.035, z), 0.042, 0.008, 0.5)
        tube("chrome", [(x + dx, y, z), (x + dx, y - 0.04, z)], 0.011, segments=12)
    tube("chrome", [(x - 0.135, y, z), (x + 0.135, y, z)], 0.021)
    spout = spline([(x, y, z), (x, y - 0.02, z + 0.03), (x, y - 0.06, z + 0.075), (x, y - 0.12, z + 0.075), (x, y - 0.165, z + 0.03),
                    (x, y - 0.172, z - 0.015)], 4)
    tube("chrome", spout, 0.014, segments=14)


def cross_handle(at, reach, radius, turn):
    """Turned in the wall's plane."""
    for angle in (turn, turn + math.pi / 2):
        arm = (reach * math.cos(angle), 0, reach * math.sin(angle))
        tube("chrome", [sub(at, arm), add(at, arm)], radius, segments=10)


def tub_towel():
    """Hangs over the tub's front rim."""
    u0, u1 = 0.79, 0.865
    v0, v1 = 0.10, 0.70  # from low on the outside to inside

    def side(offset):
        def surface(u, v):
            du = u0 + (u1 - u0) * u
            fold = 0.5 + 0.5 * math.sin(2 * math.pi * 3.3 * u + 0.8)
            hang = abs(v - 0.55) / 0.55
            vv = v0 + (v1 - v0) * v
            return add(tub_point(du, vv), mul(tub_normal(du, vv), offset + 0.016 * hang * fold + 0.003))
        return surface
    outer, inner = side(0.010), side(0.0)
    grid("towel", outer, 30, 36)
    for edge in (lambda s, t: (0.0, t), lambda s, t: (1.0, 1 - t)):
        def hem(s, t, edge=edge):
            u, v = edge(s, t)
            return add(mul(outer(u, v), 1 - s), mul(inner(u, v), s))
        grid("towel", hem, 30, 1)

    def low(s, t):
        return add(mul(inner(s, 0), 1 - t), mul(outer(s, 0), t))
    grid("towel", low, 1, 30)


# ---- the basin -----------------------------------------------------------------------------------------------------
BASIN = (2.52, 3.55)  # the bowl's middle
COUNTER = 0.80        # height of the counter's top


def vanity():
    x0, x1, y0 = 2.08, 2.98, 3.30
    rounded_box("oak", (x0 - 0.02, y0 - 0.02, COUNTER - 0.035), (x1 + 0.02, DEPTH, COUNTER), 0.006)
    box("oak", (x0, y0 + 0.012, 0.44), (x1, DEPTH, COUNTER - 0.035))
    for a, b in ((x0, (x0 + x1) / 2), ((x0 + x1) / 2, x1)):
        rounded_box("oak", (a + 0.003, y0 - 0.008, 0.443), (b - 0.003, y0 + 0.010, COUNTER - 0.042), 0.004)
        lathe("brass", ball(0.014, 0), Frame(((a + b) / 2, y0 - 0.028, 0.62)), 16)
        rod("brass", ((a + b) / 2, y0 - 0.03, 0.62), ((a + b) / 2, y0, 0.62), 0.005)
    bowl = spline([(0.0, 0.0005), (0.11, 0.0005), (0.125, 0.006), (0.165, 0.05), (0.195, 0.105), (0.205, 0.130), (0.2035, 0.137),
                   (0.199, 0.1385), (0.194, 0.134), (0.184, 0.105), (0.155, 0.055), (0.105, 0.026), (0.04, 0.018), (0.0, 0.017)], 3)

    def surface(u, v):
        k = v * (len(bowl) - 1)
        i = min(int(k), len(bowl) - 2)
        r, z = (p + (k - i) * (q - p) for p, q in zip(bowl[i], bowl[i + 1]))
        return (BASIN[0] + r * math.cos(2 * math.pi * u), BASIN[1] + r * math.sin(2 * math.pi * u), COUNTER + z)
    grid("ceramic", surface, len(bowl) - 1, 56)
    lathe("chrome", [(0, 0.0175), (0.024, 0.0175), (0.024, 0.021), (0.010, 0.022), (0, 0.0215)], Frame((BASIN[0], BASIN[1], COUNTER)), 24)
    # A tap in the wall, with two handles.
    x, z = BASIN[0], COUNTER + 0.27
    spout = spline([(x, DEPTH + 0.01, z), (x, DEPTH - 0.08, z), (x, DEPTH - 0.15, z - 0.001), (x, DEPTH - 0.185, z - 0.018), (x, DEPTH - 0.19, z - 0.055)], 6)
    tube("chrome", spout, 0.011)
    for dx in (-0.11, 0.0, 0.11):
        flange(x + dx, z)
    for dx in (-0.11, 0.11):
        tube("chrome", [(x + dx, DEPTH, z), (x + dx, DEPTH - 0.05, z)], 0.011)
        cross_handle((x + dx, DEPTH - 0.052, z), 0.034, 0.0065, 0.3)


def flange(x, z, radius=0.026):
    """A flat disk on the back wall."""
    count = 28
    profile = [(radius, 0.0, 1.0, 0.0), (radius, 0.007, 1.0, 0.0), (radius, 0.007, 0.5, 0.8), (radius - 0.004, 0.009, 0.0, 1.0), (0.0, 0.010, 0.0, 1.0)]
    vertices, faces = [], []
    for r, d, out, front in profile:
        for j in range(count):
            a = 2 * math.pi * j / count
            vertices.append(((x + r * math.cos(a), DEPTH - d, z + r * math.sin(a)), unit((out * math.cos(a), -front, out * math.sin(a))), (0, 0)))
    for i in range(len(profile) - 1):
        for j in range(count):
            a, b = i * count + j, i * count + (j + 1) % count
            faces += [(a, b, b + count), (a, b + count, a + count)] if i < len(profile) - 2 else [(a, b, a + count)]
    emit("chrome", vertices, faces, ROOM)


MIRROR = (BASIN[0], 1.56, 0.36)  # x z radius


def mirror():
    x, z, r = MIRROR
    y, count = DEPTH - 0.022, 96
    rim = [(r * math.cos(2 * math.pi * k / count), r * math.sin(2 * math.pi * k / count)) for k in range(count)]
    vertices = [((x, y, z), (0, -1, 0), (0, 0))] + [((x + a, y, z + b), (0, -1, 0), (0, 0)) for a, b in rim]
    emit("mirror", vertices, [(0, k + 1, (k + 1) % count + 1) for k in range(count)], ROOM)

    def frame(u, v):
        a, b = 2 * math.pi * u, 2 * math.pi * v
        d = r + 0.011 * math.cos(b)
        return (x + d * math.cos(a), y - 0.002 - 0.013 * math.sin(b), z + d * math.sin(a))
    grid("brass", frame, 10, 72)
    box("brass", (x - 0.12, y + 0.008, z - 0.12), (x + 0.12, DEPTH, z + 0.12))


LAMP = (BASIN[0], DEPTH - 0.11, 2.13)


def lamp():
    """A brass bowl that throws its light at the ceiling: below it nothing is lit directly."""
    x, y, z = LAMP
    f = Frame(LAMP)
    bowl = [(0.075 * math.sin(a), -0.075 * math.cos(a)) for a in (math.pi / 2 * k / 8 for k in range(9))]
    inside = [(max(0, r - 0.003), h + 0.003 if r < 0.07 else 0.0) for r, h in reversed(bowl)]
    lathe("brass", [(0, bowl[0][1])] + bowl[1:] + inside[:-1] + [(0, inside[-1][1])], f, 40)
    tube("brass", spline([(x, y + 0.072, z - 0.015), (x, DEPTH - 0.02, z - 0.02), (x, DEPTH + 0.01, z - 0.02)], 4), 0.009)


# ---- things --------------------------------------------------------------------------------------------------------
def shelf():
    x0, x1, z = 0.62, 1.52, 1.38
    rounded_box("oak", (x0, DEPTH - 0.17, z), (x1, DEPTH, z + 0.024), 0.005)
    for x in (x0 + 0.14, x1 - 0.14):
        tube("brass", [(x, DEPTH + 0.005, z - 0.13), (x, DEPTH - 0.006, z - 0.13), (x, DEPTH - 0.14, z - 0.006)], 0.006, segments=10)
        tube("brass", [(x, DEPTH - 0.006, z - 0.15), (x, DEPTH - 0.006, z - 0.01)], 0.006, segments=10)
    top = z + 0.0245
    y = DEPTH - 0.085

    def bottle(material, cap, x, r, h, neck, segments=28):
        body = [(0, 0), (r * 0.94, 0), (r, r * 0.06), (r, h), (r * 0.95, h + r * 0.25), (r * 0.75, h + r * 0.5), (neck, h + r * 0.68), (neck, h + r), (0, h + r)]
        lathe(material, body, Frame((x, y, top)), segments)
        lathe(cap, [(0, 0), (neck * 1.25, 0), (neck * 1.25, 0.022), (neck * 1.1, 0.026), (0, 0.026)], Frame((x, y, top + h + r - 0.004)), segments)
    bottle("amber", "white", 1.40, 0.032, 0.11, 0.011)
    bottle("white", "brass", 1.315, 0.028, 0.145, 0.010)
    bottle("rose", "white", 1.235, 0.030, 0.07, 0.014)
    # Folded hand towels.
    for k, (m, turn) in enumerate((("towel", 2), ("linen", -2), ("towel", 1))):
        rounded_box(m, (-0.11, -0.07, 0.001 + 0.036 * k), (0.11, 0.07, 0.036 * (k + 1)), 0.015, Frame((1.03, y, top), turn), 4)
    hanging_plant(0.755, y, top)


def leaf(material, base, turn, pitch, length, wide, bend, rows=6):
    """From `base` outwards; it bends down towards its tip."""
    def surface(u, v):
        s = 2 * u - 1
        half = wide * math.sin(math.pi * min(1, 0.04 + 0.96 * v) ** 0.75) * 0.5 + 0.0006
        angle = pitch - bend * v
        along = length * v
        rise = math.sin(pitch - bend * v / 2) * along + 0.25 * half * abs(s)
        out = math.cos(angle / 2 + pitch / 2) * along
        return (base[0] + out * math.cos(turn) + s * half * math.sin(turn), base[1] + out * math.sin(turn) - s * half * math.cos(turn), base[2] + rise)
    grid(material, surface, rows, 2)


def pot(material, at, radius, height):
    lathe(material, [(0, 0.0005), (radius * 0.78, 0.0005), (radius * 0.82, 0.006), (radius, height - 0.004), (radius - 0.003, height),
                     (radius - 0.008, height - 0.002), (radius - 0.010, height - 0.02), (0, height - 0.02)], Frame(at), 36)
    lathe("soil", [(radius - 0.008, height - 0.019), (radius * 0.5, height - 0.014), (0, height - 0.012)], Frame(at), 20)


def hanging_plant(x, y, z):
    """Strings of small leaves fall over the shelf's edge."""
    pot("terracotta", (x, y, z), 0.055, 0.09)
    for k in range(11):
        turn = -math.pi / 2 + (k - 5) * 0.27 + random.uniform(-0.1, 0.1)
        reach, fall = 0.10 + random.uniform(0, 0.025), 0.14 + random.uniform(0, 0.26)
        c, s = math.cos(turn), math.sin(turn)
        start = (x + 0.02 * c, y + 0.02 * s, z + 0.08)
        front = max(reach, 0.105 / max(0.3, -s)) if s < -0.3 else reach
        fall = fall if s < -0.55 else 0.05
        path = spline([start, (x + 0.06 * c, y + 0.06 * s, z + 0.125), (x + front * c, y + front * s, z + 0.075),
                       (x + (front + 0.012) * c, y + (front + 0.012) * s, z - fall * 0.5), (x + (front + 0.010) * c + 0.01, y + (front + 0.012) * s, z - fall)], 5)
        tube("stem", path, 0.0018, segments=6, caps=False)
        for j in range(2, len(path)):
            for way in (1, -1):
                leaf("leaf", path[j], turn + way * 1.2 + random.uniform(-0.5, 0.5), random.uniform(-0.3, 0.5), random.uniform(0.026, 0.04),
                     random.uniform(0.018, 0.026), 0.9, 2)


def sill_plant():
    """A fern on the window sill."""
    at = (-0.06, 2.30, WINDOW[2] + 0.0055)
    pot("white", at, 0.062, 0.10)
    for k in range(22):
        turn = k * 2.399
        upright = 0.35 + 0.75 * (k / 22)
        leaf("leaf", add(at, (0.015 * math.cos(turn), 0.015 * math.sin(turn), 0.085)), turn, upright + 0.25, 0.16 + 0.05 * (k % 4) / 3, 0.028, 1.1, 8)


def on_counter():
    z = COUNTER + 0.0003
    # A soap dispenser, a tumbler with two brushes, a bar of soap in its dish.
    f = Frame((2.22, 3.60, z))
    lathe("amber", [(0, 0), (0.034, 0), (0.036, 0.003), (0.036, 0.11), (0.032, 0.122), (0.018, 0.132), (0.014, 0.136), (0.014, 0.145), (0, 0.145)], f, 32)
    lathe("white", [(0, 0.1445), (0.016, 0.1445), (0.016, 0.160), (0.006, 0.163), (0.006, 0.185), (0, 0.185)], f, 24)
    tube("white", [(2.22, 3.60, z + 0.184), (2.205, 3.575, z + 0.184), (2.197, 3.562, z + 0.178)], 0.006, segments=10)
    f = Frame((2.86, 3.62, z))
    lathe("ceramic", [(0, 0), (0.034, 0), (0.036, 0.003), (0.038, 0.095), (0.0365, 0.097), (0.035, 0.095), (0.033, 0.008), (0, 0.008)], f, 32)
    for m, lean in (("rose", (0.035, 0.012)), ("leaf", (-0.02, 0.028))):
        a, b = (2.86 - 0.5 * lean[0], 3.62 - 0.5 * lean[1], z + 0.012), (2.86 + lean[0] * 1.25, 3.62 + lean[1] * 1.25, z + 0.18)
        tube(m, [a, b], 0.0035, segments=8)
        tube("white", [sub(b, mul(unit(sub(b, a)), 0.028)), b], 0.0062, segments=8)
    rounded_box("white", (-0.055, -0.035, 0.0), (0.055, 0.035, 0.012), 0.006, Frame((2.85, 3.42, z), 15))
    rounded_box("rose", (-0.038, -0.024, 0.0115), (0.038, 0.024, 0.032), 0.010, Frame((2.85, 3.42, z), 24), 4)


def basket():
    """Below the counter, with rolled towels in it."""
    x, y = 2.53, 3.52
    height, count = 0.24, 12

    def wall(inside):
        def surface(u, v):
            if inside:
                u = 1 - u
            ridge = 0.004 * math.cos(2 * math.pi * count * 2 * u) * math.cos(math.pi * 14 * v)
            r = 0.155 + 0.025 * v + (-0.010 if inside else ridge)
            return (x + 1.25 * r * math.cos(2 * math.pi * u), y + 0.9 * r * math.sin(2 * math.pi * u), 0.001 + height * v)
        return surface
    grid("wicker", wall(False), 24, 96)
    grid("wicker", wall(True), 2, 48)
    rim = [(x + 1.25 * 0.176 * math.cos(2 * math.pi * k / 48), y + 0.9 * 0.176 * math.sin(2 * math.pi * k / 48), height) for k in range(49)]
    tube("wicker", rim, 0.009, segments=10, caps=False)
    quad("wicker", (x - 0.12, y - 0.09, 0.02), (x + 0.12, y - 0.09, 0.02), (x + 0.12, y + 0.09, 0.02), (x - 0.12, y + 0.09, 0.02))
    for k, (dx, dy, m, h) in enumerate(((-0.10, 0.0, "towel", 0.33), (0.005, -0.045, "linen", 0.31), (0.01, 0.06, "towel", 0.34), (0.11, 0.0, "linen", 0.32))):
        roll = [(0, 0.02), (0.05, 0.02), (0.05, h - 0.012), (0.045, h - 0.002), (0.040, h)]
        for j in range(3):
            r = 0.036 - 0.011 * j
            roll += [(r, h - 0.004), (r - 0.003, h - 0.004), (r - 0.006, h - 0.001)]
        lathe(m, roll + [(0, h - 0.006)], Frame((x + dx, y + dy, 0)), 28)


def stool():
    """In front of the tub: a round seat on three legs, with a book and a candle."""
    x, y, h = 0.62, 2.62, 0.44
    lathe("oak", [(0, h - 0.03), (0.15, h - 0.03), (0.158, h - 0.026), (0.16, h - 0.015), (0.158, h - 0.004), (0.15, h), (0, h)], Frame((x, y, 0)), 48)
    for k in range(3):
        a = 2 * math.pi * k / 3 + 0.5
        tube("oak", [(x + 0.16 * math.cos(a), y + 0.16 * math.sin(a), 0.015), (x + 0.10 * math.cos(a), y + 0.10 * math.sin(a), h - 0.02)], 0.014)
    f = Frame((x - 0.02, y + 0.03, h + 0.0003), 24)
    box("paper", (-0.08, -0.06, 0), (0.08, 0.06, 0.003), f)
    box("paper", (-0.08, -0.06, 0.021), (0.08, 0.06, 0.024), f)
    box("paper", (-0.08, -0.06, 0.003), (-0.077, 0.06, 0.021), f)
    box("linen", (-0.077, -0.057, 0.003), (0.077, 0.057, 0.021), f)
    g = Frame(f.point((-0.01, 0.005, 0.0243)))
    lathe("ceramic", [(0, 0), (0.032, 0), (0.036, 0.006), (0.036, 0.055), (0.034, 0.057), (0.032, 0.055), (0.031, 0.045), (0, 0.045)], g, 28)
    lathe("linen", [(0.0315, 0.0455), (0.01, 0.044), (0, 0.044)], g, 20)
    rod("soil", add(g.at, (0, 0, 0.043)), add(g.at, (0, 0, 0.056)), 0.001, segments=6)


def snake_plant():
    """On the floor, beside the basin."""
    at = (2.93, 2.88, 0.0005)
    pot("terracotta", at, 0.13, 0.24)
    for k in range(11):
        turn = k * 2.399 + 0.3
        c, t = math.cos(turn), math.sin(turn)
        near, height, lean, wide = 0.02 + 0.055 * (k / 10), 0.72 - 0.03 * k + 0.07 * (k % 3), 0.05 + 0.09 * (k / 10), 0.030 + 0.004 * (k % 2)

        def surface(u, v):
            a = 2 * u - 1
            half = wide * min(1, 0.55 + 1.1 * v) * (1 - v ** 5)
            out = near + lean * v * v + 0.35 * half * (a * a - 1)
            twist = turn + 0.9 * v * (1 if k % 2 else -1)
            return (at[0] + out * c - a * half * math.sin(twist), at[1] + out * t + a * half * math.cos(twist), 0.215 + height * v)
        grid("leaf", surface, 12, 4)


def mat():
    """A ribbed bath mat."""
    f = Frame((1.38, 2.70, 0.0005), -3)
    w, d, ribs = 0.80, 0.46, 26

    def surface(u, v):
        v = 0.5 - 0.5 * math.cos(math.pi * v)  # more rows towards the edges
        edge = min(u * w, (1 - u) * w, v * d, (1 - v) * d)
        height = 0.016 * min(1, edge / 0.012) ** 0.5 * (0.72 + 0.28 * math.sqrt(abs(math.cos(math.pi * ribs * u))))
        return ((u - 0.5) * w, (v - 0.5) * d, height)
    grid("mat", surface, 12, ribs * 5, f)


def towel_rail():
    """On the front wall, for the mirror to show."""
    f = Frame((2.80, 0, 0), 180)  # the wall is y = 0, the room on its side towards -y
    y, z = -0.07, 1.72
    tube("chrome", [(-0.30, y, z), (0.30, y, z)], 0.010, f, 12)
    for x in (-0.28, 0.28):
        tube("chrome", [(x, y, z), (x, 0.01, z)], 0.008, f, 12)

    def surface(u, v):
        # Up the back, over the rail, down the front.
        s = (2 * v - 1) * abs(2 * v - 1)
        drop = max(0.0, abs(s) - 0.03) * (0.62 if s > 0 else 0.5)
        turn = max(-1, min(1, s / 0.03)) * math.pi / 2
        wave = 0.012 * math.sin(2 * math.pi * 3 * u + 0.4) * min(1, drop * 4)
        return (-0.2 + 0.4 * u, y - 0.016 * math.sin(turn) - wave * (1 if s > 0 else 0.5), z + 0.016 * math.cos(turn) - drop)
    grid("towel", lambda u, v: surface(1 - u, v), 48, 24, f)


# ---- files ---------------------------------------------------------------------------------------------------------
def metal(eta, k, roughness):
    return (f'"string type" [ "metal" ] {rgb("eta", *eta)} {rgb("k", *k)} "float uroughness" [ {roughness} ] '
            f'"float vroughness" [ {roughness} ] "bool remaproughness" [ "false" ]')


MATERIALS = {
    "tile": glossy('"texture Kd" [ "glaze" ]', 0.08),
    "dark_tile": glossy(rgb("Kd", 0.035, 0.11, 0.075), 0.08),
    "floor": glossy('"texture Kd" [ "stone" ]', 0.15),
    "grout": matte(0.70, 0.69, 0.64),
    "plaster": matte(0.80, 0.79, 0.75),
    "ceiling": matte(0.84, 0.84, 0.82),
    "paint": glossy(rgb("Kd", 0.80, 0.79, 0.76), 0.15),
    # Frosted panes: what light comes through them is spread in all directions.
    "frosted": '"string type" [ "translucent" ] "rgb Kd" [ 0.95 0.97 0.96 ] "rgb Ks" [ 0 0 0 ] "rgb reflect" [ 0.3 0.3 0.3 ] "rgb transmit" [ 0.5 0.5 0.5 ]',
    "ground": matte(0.30, 0.31, 0.24),
    "ceramic": glossy(rgb("Kd", 0.82, 0.81, 0.79), 0.04),
    "chrome": metal((3.18, 3.18, 2.33), (3.31, 3.33, 3.14), 0.06),
    "brass": metal((0.444, 0.527, 1.094), (3.695, 2.765, 1.829), 0.15),
    "mirror": '"string type" [ "mirror" ] "rgb Kr" [ 0.93 0.94 0.93 ]',
    "oak": glossy('"texture Kd" [ "oak" ]', 0.2),
    "wicker": matte(0.46, 0.31, 0.17),
    "towel": matte(0.66, 0.40, 0.13),
    "linen": matte(0.74, 0.71, 0.64),
    "mat": matte(0.80, 0.77, 0.70),
    "white": glossy(rgb("Kd", 0.76, 0.76, 0.74), 0.1),
    "amber": glossy(rgb("Kd", 0.20, 0.075, 0.02), 0.08),
    "rose": glossy(rgb("Kd", 0.62, 0.30, 0.26), 0.15),
    "terracotta": matte(0.52, 0.24, 0.14),
    "paper": matte(0.16, 0.26, 0.36),
    "leaf": glossy(rgb("Kd", 0.09, 0.26, 0.06), 0.3, 0.03),
    "stem": matte(0.20, 0.24, 0.08),
    "soil": matte(0.06, 0.04, 0.03),
    "lampbody": matte(0, 0, 0),
}
TEXTURES = {"glaze": (glaze, 256), "stone": (stone, 256), "oak": (oak, 256)}
# What the scene file says of them.
PARTS = {
    "The room": ("tile", "dark_tile", "floor", "grout", "plaster", "ceiling"),
    "Window and door, and what lies outside": ("paint", "frosted", "ground"),
    "Bathtub, basin, taps, mirror": ("ceramic", "chrome", "brass", "mirror"),
    "Furniture": ("oak", "wicker"),
    "Cloth": ("towel", "linen", "mat"),
    "Small things": ("white", "amber", "rose", "terracotta", "paper"),
    "Plants": ("leaf", "stem", "soil"),
}


def write_scene(path):
    lines = ["# A bathroom with green tiles. Made by make.py, which see. Metres, z up. CC0.", "",
             "# Mirrored, since pbrt's camera is left-handed and this scene is not.", "Scale -1 1 1",
             "LookAt 2.20 0.14 1.40  1.40 3.6 0.96  0 0 1",
             'Camera "perspective" "float fov" [ 47 ]',
             'Film "image" "integer xresolution" [ 1280 ] "integer yresolution" [ 720 ] "string filename" [ "bathroom.exr" ]',
             'Sampler "sobol" "integer pixelsamples" [ 64 ]',
             'PixelFilter "triangle" "float xwidth" [ 1 ] "float ywidth" [ 1 ]',
             'Integrator "path" "integer maxdepth" [ 65 ]', "", "WorldBegin", "",
             "# The sky, and the sun that falls through the open half of the window onto the back wall.",
             'LightSource "infinite" "rgb L" [ 19 21 24 ]',
             'LightSource "distant" "rgb L" [ 27 23 17.5 ] "point from" [ -1 -1.05 0.62 ] "point to" [ 0 0 0 ]', ""]
    for name in TEXTURES:
        scale = 1.6 if name == "oak" else 1
        lines.append(f'Texture "{name}" "spectrum" "imagemap" "string filename" [ "textures/{name}.png" ] '
                     f'"float uscale" [ {scale} ] "float vscale" [ {scale} ]')
    lines.append("")
    for name, parameters in MATERIALS.items():
        lines.append(f'MakeNamedMaterial "{name}" {parameters}')
    for part, names in PARTS.items():
        lines += ["", f"# {part}."]
        for name in names:
            lines += [f'NamedMaterial "{name}"', f'Shape "plymesh" "string filename" [ "geometry/{name}.ply" ]']
    x, y, z = LAMP
    lines += ["", "# The lamp above the mirror: it shines out of its bowl at the ceiling.", "AttributeBegin", '  NamedMaterial "lampbody"',
              '  AreaLightSource "diffuse" "rgb L" [ 100 67 36 ]', f"  Translate {x} {y} {z - 0.02:.3f}",
              '  Shape "disk" "float radius" [ 0.05 ]', "AttributeEnd", "", "WorldEnd", ""]
    assert sorted(meshes) == sorted(n for names in PARTS.values() for n in names)
    with open(path, "w") as f:
        f.write("\n".join(lines))


def main():
    for make in (shell, window, door, bathtub, tub_towel, vanity, mirror, lamp, shelf, sill_plant, on_counter, basket, stool, snake_plant, mat, towel_rail):
        make()
    for folder in ("geometry", "textures"):
        os.makedirs(os.path.join(HERE, folder), exist_ok=True)
    for name, mesh in meshes.items():
        write_ply(os.path.join(HERE, "geometry", name + ".ply"), mesh, "texture" in MATERIALS[name])
    for name, (shade, size) in TEXTURES.items():
        write_png(os.path.join(HERE, "textures", name + ".png"), size, shade)
    write_scene(os.path.join(HERE, "scene.pbrt"))
    print(sum(len(m.faces) for m in meshes.values()), "triangles in", len(meshes), "meshes")


if __name__ == "__main__":
    main()
