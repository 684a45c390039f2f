#!/usr/bin/env python3
"""Makes the quickstart scene: a living room by daylight. Python's standard library only.

    python3 scenes/quickstart/make.py

writes scene.pbrt, geometry/*.ply and textures/*.png beside this file. Metres, z up: the room is 6 m (x) by 4.6 m (y) by
2.7 m, its window in the wall x = 0. Everything here is CC0.
"""
import math
import os
import random
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(HERE))
from modelling import (ROOM, Frame, add, box, glossy, grid, lathe, matte, meshes, mul, pillow, quad, rgb, rod,  # noqa: E402
                       rounded_box, sub, value_noise, write_ply, write_png)

random.seed(20)
LATTICE = [random.random() for _ in range(4096)]
noise = value_noise(LATTICE)


# ---- textures ------------------------------------------------------------------------------------------------------
def planks(u, v):
    row = int(v * 8)
    shift = LATTICE[row * 7 + 3]
    along = (u + shift) % 1
    board = row * 2 + int(along * 2)
    tone = 0.84 + 0.26 * LATTICE[board * 13 + 1]
    grain = 0.6 * noise(along * 6, v * 160 + board * 5, 512) + 0.4 * noise(along * 24, v * 420, 512)
    tone *= 0.84 + 0.32 * grain
    edge = min(v * 8 % 1, 1 - v * 8 % 1) < 0.018 or min(along * 2 % 1, 1 - along * 2 % 1) < 0.003
    tone *= 0.62 if edge else 1
    return (0.66 * tone, 0.50 * tone, 0.35 * tone)


def weave(u, v):
    tone = 0.9 + 0.1 * noise(u * 128, v * 128, 128)
    band = abs(v - 0.5) > 0.40 or abs(u - 0.5) > 0.43
    line = abs(abs(v - 0.5) - 0.38) < 0.008 or abs(abs(u - 0.5) - 0.415) < 0.006
    zigzag = abs((v * 9 + abs((u * 12) % 1 - 0.5)) % 1 - 0.5) < 0.10
    color = (0.36, 0.20, 0.17) if band or line else (0.62, 0.36, 0.24) if zigzag else (0.86, 0.81, 0.72)
    return tuple(c * tone for c in color)


def landscape(u, v):
    hills = [(0.55, 0.06, 3.1, (0.52, 0.62, 0.66)), (0.66, 0.08, 2.1, (0.32, 0.46, 0.48)), (0.80, 0.07, 1.3, (0.16, 0.28, 0.28))]
    color = (0.95 - 0.15 * v, 0.80 - 0.05 * v, 0.62 + 0.12 * v)
    if math.hypot(u - 0.64, v - 0.34) < 0.11:
        color = (0.93, 0.46, 0.28)
    for level, height, waves, tint in hills:
        if v > level - height * math.sin(waves * math.pi * u + level * 9):
            color = tint
    return tuple(c * (0.95 + 0.1 * noise(u * 40, v * 40, 64)) for c in color)


def shapes(u, v):
    color = (0.92, 0.89, 0.83)
    if math.hypot(u - 0.40, v - 0.38) < 0.24:
        color = (0.13, 0.27, 0.38)
    if 0.46 < u < 0.80 and 0.42 < v < 0.80:
        color = (0.83, 0.56, 0.20)
    if math.hypot(u - 0.62, v - 0.70) < 0.13:
        color = (0.68, 0.22, 0.17)
    return color


# ---- the room ------------------------------------------------------------------------------------------------------
WIDTH, DEPTH, HEIGHT, THICK = 6.0, 4.6, 2.7, 0.25
WINDOW = (1.05, 3.55, 0.45, 2.35)  # y0 y1 z0 z1


def shell():
    t = THICK
    y0, y1, z0, z1 = WINDOW
    # Slabs that overlap at their edges: light has no seam to come through.
    box("floor", (-t, -t, -t), (WIDTH + t, DEPTH + t, 0))
    box("ceiling", (-t, -t, HEIGHT), (WIDTH + t, DEPTH + t, HEIGHT + t))
    box("accent", (-t, DEPTH, -t), (WIDTH + t, DEPTH + t, HEIGHT + t))
    box("wall", (-t, -t, -t), (WIDTH + t, 0, HEIGHT + t))
    box("wall", (WIDTH, -t, -t), (WIDTH + t, DEPTH + t, HEIGHT + t))
    box("wall", (-t, -t, -t), (0, y0, HEIGHT + t))
    box("wall", (-t, y1, -t), (0, DEPTH + t, HEIGHT + t))
    box("wall", (-t, y0 - 0.01, -t), (0, y1 + 0.01, z0))
    box("wall", (-t, y0 - 0.01, z1), (0, y1 + 0.01, HEIGHT + t))
    for lo, hi in (((0.0, DEPTH - 0.014, 0), (WIDTH, DEPTH, 0.10)), ((0, 0, 0), (WIDTH, 0.014, 0.10)),
                   ((0, 0, 0), (0.014, DEPTH, 0.10)), ((WIDTH - 0.014, 0, 0), (WIDTH, DEPTH, 0.10))):
        rounded_box("trim", lo, hi, 0.005)
    # Window frame with two mullions and a transom; a sill.
    x0, x1, w = -0.17, -0.11, 0.055
    for lo, hi in (((x0, y0, z0), (x1, y1, z0 + w)), ((x0, y0, z1 - w), (x1, y1, z1)), ((x0, y0, z0), (x1, y0 + w, z1)),
                   ((x0, y1 - w, z0), (x1, y1, z1)), ((x0, y0, 1.82), (x1, y1, 1.86))):
        rounded_box("trim", lo, hi, 0.008)
    for k in (1, 2):
        y = y0 + (y1 - y0) * k / 3
        rounded_box("trim", (x0, y - 0.024, z0), (x1, y + 0.024, z1), 0.008)
    rounded_box("trim", (-0.11, y0 - 0.05, z0 - 0.035), (0.09, y1 + 0.05, z0), 0.01)
    # What lies outside.
    quad("lawn", (-40, -30, -0.6), (-THICK, -30, -0.6), (-THICK, 30, -0.6), (-40, 30, -0.6))


def curtains():
    y0, y1, _, z1 = WINDOW
    top = z1 + 0.16
    rod("brass", (0.12, y0 - 0.42, top), (0.12, y1 + 0.42, top), 0.013)
    for a, b, phase in ((y0 - 0.34, y0 + 0.12, 0.0), (y1 - 0.12, y1 + 0.34, 1.1)):
        def surface(u, v, a=a, b=b, phase=phase):
            fold = 0.035 * (0.55 + 0.45 * (1 - v)) * math.sin(2 * math.pi * 5 * u + phase + 0.6 * math.sin(3 * v))
            return (0.12 + fold, a + (b - a) * u, 0.025 + (top - 0.03) * v)
        grid("linen", surface, 10, 90)


def sofa():
    f = Frame((2.65, 3.62, 0), 0)  # front towards -y
    w = 1.12
    rounded_box("sofa", (-w, 0.02, 0.10), (w, 0.90, 0.30), 0.03, f)
    rounded_box("sofa", (-w, 0.70, 0.12), (w, 0.92, 0.80), 0.07, f, 5)
    for s in (-1, 1):
        rounded_box("sofa", (min(s * w, s * (w - 0.19)), 0.0, 0.12), (max(s * w, s * (w - 0.19)), 0.90, 0.60), 0.07, f, 5)
        for y in (0.08, 0.84):
            lathe("wood", [(0, 0), (0.018, 0), (0.028, 0.11), (0, 0.11)], Frame((2.65 + s * (w - 0.1), 3.62 + y, 0)), 16)
        x0, x1 = (-w + 0.19, 0.0) if s < 0 else (0.0, w - 0.19)
        rounded_box("sofa", (x0 + 0.004, -0.02, 0.29), (x1 - 0.004, 0.74, 0.46), 0.06, f, 5)
        rounded_box("sofa", (x0 + 0.006, 0.56, 0.45), (x1 - 0.006, 0.76, 0.84), 0.08, f, 5)
    pillow("rust", 0.48, 0.44, 0.19, Frame((1.97, 4.02, 0.46), 12), 0.35)
    pillow("mustard", 0.44, 0.40, 0.18, Frame((2.32, 3.98, 0.46), -8), 0.38)
    pillow("teal", 0.48, 0.44, 0.19, Frame((3.36, 4.02, 0.46), -14), 0.35)


def armchair():
    f = Frame((0.95, 1.25, 0), 118)
    rounded_box("velvet", (-0.36, 0.0, 0.20), (0.36, 0.68, 0.32), 0.05, f, 4)
    rounded_box("velvet", (-0.27, -0.02, 0.31), (0.27, 0.56, 0.45), 0.06, f, 5)
    rounded_box("velvet", (-0.36, 0.54, 0.24), (0.36, 0.72, 0.86), 0.08, f, 5)
    for s in (-1, 1):
        rounded_box("velvet", (min(s * 0.36, s * 0.26), 0, 0.28), (max(s * 0.36, s * 0.26), 0.64, 0.58), 0.045, f, 4)
        for y in (0.06, 0.64):
            p = f.point((s * 0.31, y, 0))
            rod("wood", p, add(p, (0, 0, 0.22)), 0.018)
    pillow("linen", 0.40, 0.36, 0.16, Frame(f.point((0.02, 0.46, 0.44)), 118), 0.3)


def coffee_table():
    f = Frame((2.62, 2.30, 0), 4)
    rounded_box("wood", (-0.62, -0.34, 0.36), (0.62, 0.34, 0.40), 0.015, f)
    rounded_box("wood", (-0.52, -0.26, 0.14), (0.52, 0.26, 0.16), 0.008, f)
    for x in (-0.54, 0.54):
        for y in (-0.27, 0.27):
            rounded_box("wood", (x - 0.024, y - 0.024, 0.008), (x + 0.024, y + 0.024, 0.36), 0.007, f)

    def on_top(x, y):
        p = f.point((x, y, 0.4005))
        return Frame(p)
    # A brass vase.
    vase = [(0, 0), (0.05, 0)]
    for i in range(1, 25):
        t = i / 24
        vase.append((0.034 + 0.058 * math.sin(math.pi * min(1, t * 1.12)) ** 1.4 * (1 - 0.35 * t) + 0.016 * t ** 6, 0.30 * t))
    inside = [(r - 0.004, z) for r, z in reversed(vase[3:])]
    lathe("brass", vase + inside + [(0, inside[-1][1])], on_top(-0.36, 0.10), 48)
    for k in range(7):  # dry stems
        turn, reach = k * 0.9 + 0.3, 0.05 + 0.03 * (k % 3)
        base = add(on_top(-0.36, 0.10).at, (0, 0, 0.10))
        tip = add(base, (reach * math.cos(turn) * 1.6, reach * math.sin(turn) * 1.6, 0.42 + 0.05 * (k % 3)))
        rod("stem", base, tip, 0.0022, segments=6)
        for j in range(5):
            at = add(base, mul(sub(tip, base), 0.72 + 0.07 * j))
            lathe("grass", [(0, -0.018), (0.007, 0), (0, 0.022)], Frame(at), 8)
    # A ceramic bowl with fruit.
    bowl = [(0, 0), (0.055, 0), (0.06, 0.012)]
    bowl += [(0.06 + 0.085 * math.sin(i / 12 * math.pi / 2), 0.012 + 0.075 * (1 - math.cos(i / 12 * math.pi / 2))) for i in range(1, 13)]
    bowl += [(r - 0.007, max(0.014, z + 0.003)) for r, z in reversed(bowl[3:])]
    lathe("ceramic", bowl + [(0, 0.016)], on_top(0.10, -0.06), 48)
    for x, y, z, r, m in ((0.045, 0.02, 0.062, 0.040, "orange"), (-0.045, 0.03, 0.060, 0.038, "apple"), (0.0, -0.05, 0.060, 0.039, "orange")):
        ball = [(r * math.cos(a), z + r * 0.95 * math.sin(a)) for a in (-math.pi / 2 + math.pi * i / 16 for i in range(17))]
        ball[0], ball[-1] = (0, ball[0][1]), (0, ball[-1][1])
        p = on_top(0.10 + x, -0.06 + y)
        lathe(m, ball, p, 28)
    # Tumblers of solid glass walls.
    for x, y in ((0.40, 0.12), (0.47, -0.05)):
        lathe("glass", [(0, 0), (0.031, 0), (0.036, 0.10), (0.0335, 0.10), (0.029, 0.012), (0, 0.012)], on_top(x, y), 40)
    # Books.
    z = 0.4005
    for w, d, h, turn, m in ((0.25, 0.18, 0.028, 10, "paper1"), (0.22, 0.16, 0.022, -6, "paper3")):
        book(Frame(f.point((-0.12, -0.16, z)), turn), w, d, h, m)
        z += h + 0.001
    # On the board below.
    book(Frame(f.point((0.2, 0.0, 0.1605)), 15), 0.28, 0.2, 0.03, "paper2")


def book(f, w, d, h, cover):
    """Lying flat, its middle at the frame's origin."""
    box(cover, (-w / 2, -d / 2, 0), (w / 2, d / 2, 0.003), f)
    box(cover, (-w / 2, -d / 2, h - 0.003), (w / 2, d / 2, h), f)
    box(cover, (-w / 2, -d / 2, 0.003), (-w / 2 + 0.003, d / 2, h - 0.003), f)
    box("pages", (-w / 2 + 0.003, -d / 2 + 0.004, 0.003), (w / 2 - 0.004, d / 2 - 0.004, h - 0.003), f)


def bookcase():
    x0, x1, y0, y1 = 4.35, 5.55, 4.28, 4.595
    t = 0.022
    f = ROOM
    for x in (x0, x1 - t):
        rounded_box("oak", (x, y0, 0), (x + t, y1, 2.05), 0.004, f, 2)
    box("oak", (x0 + t, y1 - 0.012, 0.05), (x1 - t, y1, 2.05))
    shelves = [0.05, 0.42, 0.80, 1.16, 1.50, 1.80, 2.028]
    for z in shelves:
        rounded_box("oak", (x0 + t, y0 + 0.002, z), (x1 - t, y1 - 0.012, z + t), 0.004, f, 2)
    papers = ["paper1", "paper2", "paper3", "paper4", "paper5", "pages"]
    for k, z in enumerate(shelves[:-1]):
        room = shelves[k + 1] - z - t
        x = x0 + t + 0.01
        limit = x1 - t - (0.45 if k in (2, 4) else 0.30 if k == 1 else 0.06)
        while x < limit:
            w, h, d = random.uniform(0.016, 0.048), room * random.uniform(0.62, 0.92), random.uniform(0.15, 0.22)
            rounded_box(random.choice(papers), (x, y0 + 0.03, z + t), (x + w, y0 + 0.03 + d, z + t + h), 0.004, f, 2)
            x += w + 0.0015
        if k == 1:
            rounded_box("paper2", (x1 - 0.27, y0 + 0.03, z + t), (x1 - 0.05, y0 + 0.2, z + t + 0.2), 0.01)
    # Ornaments where the books stop.
    globe = [(0.10 * math.cos(a), 0.115 + 0.10 * math.sin(a)) for a in (-math.pi / 2 + math.pi * i / 20 for i in range(21))]
    globe[0], globe[-1] = (0, globe[0][1]), (0, globe[-1][1])
    lathe("teal_glaze", globe, Frame((x1 - 0.25, 4.42, shelves[2] + t - 0.0145)), 40)
    jug = [(0, 0), (0.055, 0)] + [(0.045 + 0.04 * math.sin(math.pi * i / 20 * 0.9), 0.20 * i / 20) for i in range(1, 21)]
    lathe("ceramic", jug + [(jug[-1][0] - 0.006, 0.20), (0.05, 0.02), (0, 0.02)], Frame((x1 - 0.31, 4.42, shelves[4] + t)), 40)
    lathe("brass", [(0, 0), (0.04, 0), (0.04, 0.01), (0.008, 0.014), (0.008, 0.15), (0.02, 0.155), (0.02, 0.17), (0, 0.17)],
          Frame((x1 - 0.15, 4.42, shelves[4] + t)), 28)


def picture(x, z, w, h, face):
    y, rim, depth = DEPTH - 0.002, 0.022, 0.03
    for lo, hi in (((x, y - depth, z), (x + w, y, z + rim)), ((x, y - depth, z + h - rim), (x + w, y, z + h)),
                   ((x, y - depth, z + rim), (x + rim, y, z + h - rim)), ((x + w - rim, y - depth, z + rim), (x + w, y, z + h - rim))):
        rounded_box("frame", lo, hi, 0.004, ROOM, 2)
    # A mat, and the picture in it.
    m = 0.055
    quad("pages", (x + rim, y - 0.010, z + rim), (x + w - rim, y - 0.010, z + rim), (x + w - rim, y - 0.010, z + h - rim), (x + rim, y - 0.010, z + h - rim))
    quad(face, (x + rim + m, y - 0.012, z + rim + m), (x + w - rim - m, y - 0.012, z + rim + m),
         (x + w - rim - m, y - 0.012, z + h - rim - m), (x + rim + m, y - 0.012, z + h - rim - m), unit_uv=True)


LAMP = (4.02, 4.12)


def floor_lamp():
    f = Frame((LAMP[0], LAMP[1], 0))
    lathe("brass", [(0, 0.0005), (0.14, 0.0005), (0.14, 0.014), (0.02, 0.024), (0.011, 0.04), (0.011, 1.40), (0, 1.40)], f, 40)

    def shade(u, v):
        r = 0.21 - 0.07 * v
        return (r * math.cos(2 * math.pi * u), r * math.sin(2 * math.pi * u), 1.30 + 0.27 * v)
    grid("shade", shade, 2, 48, f)


def plant():
    x, y = 0.46, 4.10
    f = Frame((x, y, 0))
    lathe("ceramic", [(0, 0.0005), (0.12, 0.0005), (0.165, 0.30), (0.152, 0.30), (0.148, 0.27), (0, 0.27)], f, 40)
    lathe("soil", [(0, 0.26), (0.147, 0.272), (0, 0.274)], f, 24)
    for k in range(17):
        turn = k * 2.399 + 0.4
        reach, rise = 0.16 + 0.26 * ((k * 7) % 10) / 10, 0.50 + 0.75 * ((k * 3) % 11) / 11
        base = (x + 0.03 * math.cos(turn), y + 0.03 * math.sin(turn), 0.27)
        tip = (x + reach * math.cos(turn), min(y + reach * math.sin(turn), DEPTH - 0.22), 0.27 + rise)
        tip = (max(tip[0], 0.25), tip[1], tip[2])
        rod("stem", base, tip, 0.006, segments=8)
        length, wide = 0.30 + 0.05 * (k % 3), 0.085 + 0.012 * (k % 2)

        def leaf(u, v, turn=turn, tip=tip, length=length, wide=wide):
            s = (u - 0.5) * 2
            half = wide * math.sin(math.pi * min(1, v ** 0.8)) + 0.002
            out = length * v
            droop = 0.10 * v - 0.30 * v * v + 0.25 * half * abs(s)
            return (tip[0] + out * math.cos(turn) * 0.8 - s * half * math.sin(turn),
                    min(tip[1] + out * math.sin(turn) * 0.8 + s * half * math.cos(turn), DEPTH - 0.03), tip[2] + droop)
        grid("leaf", leaf, 10, 6)


def side_table():
    f = Frame((1.20, 3.98, 0))
    lathe("oak", [(0, 0.50), (0.24, 0.50), (0.24, 0.53), (0, 0.53)], f, 48)
    for k in range(3):
        a = 2 * math.pi * k / 3 + 0.5
        rod("oak", (1.20 + 0.18 * math.cos(a), 3.98 + 0.18 * math.sin(a), 0.0), (1.20 + 0.12 * math.cos(a), 3.98 + 0.12 * math.sin(a), 0.50), 0.016)
    mug = [(0, 0), (0.038, 0), (0.041, 0.09), (0.037, 0.09), (0.034, 0.008), (0, 0.008)]
    lathe("teal_glaze", mug, Frame((1.28, 3.92, 0.5305)), 32)
    book(Frame((1.12, 4.02, 0.5305), 25), 0.21, 0.15, 0.024, "paper4")
    book(Frame((1.12, 4.02, 0.5555), 8), 0.19, 0.14, 0.02, "paper5")


# ---- files ---------------------------------------------------------------------------------------------------------
MATERIALS = {
    "wall": matte(0.80, 0.78, 0.74),
    "accent": matte(0.42, 0.52, 0.50),
    "ceiling": matte(0.86, 0.86, 0.85),
    "trim": glossy(rgb("Kd", 0.80, 0.80, 0.78), 0.15),
    "floor": glossy('"texture Kd" [ "planks" ]', 0.14),
    "rug": '"string type" [ "matte" ] "texture Kd" [ "weave" ]',
    "lawn": matte(0.16, 0.22, 0.09),
    "linen": matte(0.80, 0.77, 0.70),
    "sofa": '"string type" [ "matte" ] "rgb Kd" [ 0.46 0.45 0.43 ] "float sigma" [ 25 ]',
    "velvet": '"string type" [ "matte" ] "rgb Kd" [ 0.12 0.25 0.22 ] "float sigma" [ 35 ]',
    "rust": matte(0.52, 0.17, 0.08),
    "mustard": matte(0.66, 0.42, 0.08),
    "teal": matte(0.07, 0.25, 0.28),
    "wood": glossy(rgb("Kd", 0.26, 0.13, 0.06), 0.12),
    "oak": glossy(rgb("Kd", 0.52, 0.36, 0.21), 0.2),
    "frame": glossy(rgb("Kd", 0.03, 0.03, 0.03), 0.12),
    "ceramic": glossy(rgb("Kd", 0.78, 0.75, 0.70), 0.02),
    "teal_glaze": glossy(rgb("Kd", 0.05, 0.26, 0.32), 0.03),
    "brass": '"string type" [ "metal" ] "rgb eta" [ 0.444 0.527 1.094 ] "rgb k" [ 3.695 2.765 1.829 ] '
             '"float uroughness" [ 0.12 ] "float vroughness" [ 0.12 ] "bool remaproughness" [ "false" ]',
    "glass": '"string type" [ "glass" ] "rgb Kr" [ 1 1 1 ] "rgb Kt" [ 1 1 1 ] "float index" [ 1.5 ]',
    "shade": '"string type" [ "translucent" ] "rgb Kd" [ 0.85 0.74 0.56 ] "rgb Ks" [ 0 0 0 ] '
             '"rgb reflect" [ 0.45 0.45 0.45 ] "rgb transmit" [ 0.5 0.5 0.5 ]',
    "leaf": matte(0.10, 0.26, 0.07),
    "stem": matte(0.24, 0.19, 0.08),
    "grass": matte(0.62, 0.48, 0.25),
    "soil": matte(0.06, 0.04, 0.03),
    "orange": '"string type" [ "plastic" ] "rgb Kd" [ 0.70 0.26 0.03 ] "rgb Ks" [ 0.12 0.12 0.12 ] "float roughness" [ 0.15 ] "bool remaproughness" [ "false" ]',
    "apple": '"string type" [ "plastic" ] "rgb Kd" [ 0.50 0.06 0.04 ] "rgb Ks" [ 0.2 0.2 0.2 ] "float roughness" [ 0.06 ] "bool remaproughness" [ "false" ]',
    "pages": matte(0.78, 0.75, 0.66),
    "paper1": matte(0.45, 0.10, 0.08),
    "paper2": matte(0.10, 0.18, 0.34),
    "paper3": matte(0.70, 0.55, 0.24),
    "paper4": matte(0.14, 0.30, 0.22),
    "paper5": matte(0.24, 0.20, 0.20),
    "landscape": '"string type" [ "matte" ] "texture Kd" [ "landscape" ]',
    "shapes": '"string type" [ "matte" ] "texture Kd" [ "shapes" ]',
    "lampbody": matte(0, 0, 0),
}
TEXTURES = {"planks": (planks, 512, 0.55), "weave": (weave, 256, 1), "landscape": (landscape, 256, 1), "shapes": (shapes, 128, 1)}


def write_scene(path):
    lines = ["# A living room by daylight. Made by make.py, which see. Metres, z up. CC0.",
             "LookAt 5.55 0.42 1.42  2.05 3.30 0.98  0 0 1",
             'Camera "perspective" "float fov" [ 50 ]',
             'Film "image" "integer xresolution" [ 960 ] "integer yresolution" [ 540 ] "string filename" [ "quickstart.exr" ]',
             'Sampler "sobol" "integer pixelsamples" [ 64 ]',
             'PixelFilter "triangle" "float xwidth" [ 1 ] "float ywidth" [ 1 ]',
             'Integrator "path" "integer maxdepth" [ 65 ]', "", "WorldBegin", "",
             "# The sky, and the sun that falls through the window onto the rug.",
             'LightSource "infinite" "rgb L" [ 4.2 5.0 6.2 ]',
             'LightSource "distant" "rgb L" [ 34 29 21 ] "point from" [ -1 -0.22 0.72 ] "point to" [ 0 0 0 ]', ""]
    for name, (_, _, scale) in TEXTURES.items():
        lines.append(f'Texture "{name}" "spectrum" "imagemap" "string filename" [ "textures/{name}.png" ] '
                     f'"float uscale" [ {scale} ] "float vscale" [ {scale} ]')
    lines.append("")
    for name, parameters in MATERIALS.items():
        lines.append(f'MakeNamedMaterial "{name}" {parameters}')
    lines.append("")
    for name in meshes:
        lines += [f'NamedMaterial "{name}"', f'Shape "plymesh" "string filename" [ "geometry/{name}.ply" ]']
    lines += ["", "# The bulb of the floor lamp.", "AttributeBegin", '  NamedMaterial "lampbody"',
              '  AreaLightSource "diffuse" "rgb L" [ 95 62 30 ]', f"  Translate {LAMP[0]} {LAMP[1]} 1.445",
              '  Shape "sphere" "float radius" [ 0.04 ]', "AttributeEnd", "", "WorldEnd", ""]
    with open(path, "w") as f:
        f.write("\n".join(lines))


def main():
    shell()
    curtains()
    rounded_box("rug", (1.35, 1.45, 0.0005), (3.95, 3.25, 0.012), 0.004, ROOM, 2)
    # The rug's pattern spans it once.
    rug = meshes["rug"]
    rug.vertices = [v[:6] + ((v[0] - 1.35) / 2.6, (v[1] - 1.45) / 1.8) for v in rug.vertices]
    sofa()
    armchair()
    coffee_table()
    bookcase()
    picture(1.72, 1.32, 0.86, 0.66, "landscape")
    picture(2.80, 1.36, 0.50, 0.58, "shapes")
    floor_lamp()
    plant()
    side_table()
    for folder in ("geometry", "textures"):
        os.makedirs(os.path.join(HERE, folder), exist_ok=True)
    for name, mesh in meshes.items():
        write_ply(os.path.join(HERE, "geometry", name + ".ply"), mesh)
    for name, (shade, size, _) in TEXTURES.items():
        write_png(os.path.join(HERE, "textures", name + ".png"), size, shade)
    write_scene(os.path.join(HERE, "scene.pbrt"))
    print(sum(len(m.faces) for m in meshes.values()), "triangles in", len(meshes), "meshes")


if __name__ == "__main__":
    main()
