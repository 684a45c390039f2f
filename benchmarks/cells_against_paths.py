#!/usr/bin/env python3
"""The picture with radiance cells beside the path tracer's, material by material.

    benchmarks/cells_against_paths.py DRC [DRC...] [--spp 160] [--seeds 2] [--cell-size auto,.04] [--only NAME,...]

All walls of a closed room have the material: a window lets the sky in, and a lamp hangs near a wall. What a cell answers
must be exact as cells shrink, so that blocks of 16x16 pixels have the path tracer's means: within .5 %, beside walls and
corners within 2 %. Prints, for each build of drc, the mean ratio and the ratio of the block that differs most, both less
what the noise of path and cells together explains (three standard errors, by the scatter among seeds). Needs numpy and
OpenEXR.
"""
import argparse
import os
import subprocess
import sys
import tempfile

import numpy as np
import OpenEXR

from common import table

WIDTH, HEIGHT, BLOCK = 160, 112, 16


def quad(*corners):
    return ('Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point3 P" [' + " ".join(corners) +
            '] "point2 uv" [0 0 1 0 1 1 0 1]\n')


def room(material):
    """A room [0,4]x[0,4]x[0,2.7], z up, in the words of pbrt-v4."""
    return f"""LookAt 1 3 1.4  3.9 0.1 1.4  0 0 1
Camera "perspective" "float fov" [75]
Film "rgb" "integer xresolution" [{WIDTH}] "integer yresolution" [{HEIGHT}] "string filename" ["x.exr"]
Integrator "path" "integer maxdepth" [16]
WorldBegin
LightSource "infinite" "rgb L" [3 3 3]
AttributeBegin
Material "diffuse" "rgb reflectance" [0 0 0]
AreaLightSource "diffuse" "rgb L" [16 14 11]
Translate 3.6 1.8 1.7
Shape "sphere" "float radius" [0.1]
AttributeEnd
{material}
""" + "".join(quad(*corners) for corners in (
        ("0 0 0", "0 0 2.7", "4 0 2.7", "4 0 0"), ("4 0 0", "4 0 2.7", "4 4 2.7", "4 4 0"),
        ("0 0 0", "0 4 0", "0 4 2.7", "0 0 2.7"), ("0 0 2.7", "0 4 2.7", "4 4 2.7", "4 0 2.7"),
        ("0 0 0", "4 0 0", "4 4 0", "0 4 0"), ("0 4 0", "2.2 4 0", "2.2 4 2.7", "0 4 2.7"),
        ("3.6 4 0", "4 4 0", "4 4 2.7", "3.6 4 2.7"), ("2.2 4 0", "3.6 4 0", "3.6 4 0.9", "2.2 4 0.9"),
        ("2.2 4 2.2", "3.6 4 2.2", "3.6 4 2.7", "2.2 4 2.7"), ("2.6 0.3 0", "3.4 0.3 0", "3.4 0.3 1", "2.6 0.3 1")))


def mix(first, second, amount=0.5):
    return (f'MakeNamedMaterial "a" "string type" {first}\nMakeNamedMaterial "b" "string type" {second}\n'
            f'Material "mix" "string materials" ["a" "b"] "float amount" [{amount}]')


BUMPS = ('Texture "waves" "float" "wrinkled" "integer octaves" [3]\n'
         'Texture "bumps" "float" "scale" "texture tex" "waves" "float scale" [0.05]\n')
GREY = '"rgb reflectance" [.7 .7 .7]'


def principled(roughness, more=""):
    return f'Material "principled" "rgb basecolor" [.7 .65 .6] "float roughness" [{roughness}] {more}'


MATERIALS = {
    "diffuse": f'Material "diffuse" {GREY}',
    "diffuse, bump map": BUMPS + f'Material "diffuse" {GREY} "texture displacement" "bumps"',
    "diffuse, roughness .5": f'Material "diffuse" {GREY} "float diffuseroughness" [.5]',
    "diffuse, roughness 1": f'Material "diffuse" {GREY} "float diffuseroughness" [1]',
    "coated diffuse, smooth": f'Material "coateddiffuse" {GREY} "float roughness" [0]',
    "coated diffuse, alpha .5": f'Material "coateddiffuse" {GREY} "float roughness" [.5] "bool remaproughness" ["false"]',
    "coated diffuse, alpha .8": f'Material "coateddiffuse" {GREY} "float roughness" [.8] "bool remaproughness" ["false"]',
    "conductor, alpha .3": f'Material "conductor" {GREY} "float roughness" [.3] "bool remaproughness" ["false"]',
    "conductor, alpha .5": f'Material "conductor" {GREY} "float roughness" [.5] "bool remaproughness" ["false"]',
    "conductor, alpha .7": f'Material "conductor" {GREY} "float roughness" [.7] "bool remaproughness" ["false"]',
    "conductor, alpha .9 and .5": f'Material "conductor" {GREY} "float uroughness" [.9] "float vroughness" [.5] '
                                  '"bool remaproughness" ["false"]',
    "coated conductor, alpha .7": f'Material "coatedconductor" {GREY} "float conductor.roughness" [.7] '
                                  '"float interface.roughness" [.6] "bool remaproughness" ["false"]',
    "diffuse transmission": 'Material "diffusetransmission" "rgb reflectance" [.4 .4 .4] "rgb transmittance" [.3 .3 .2]',
    "principled, roughness .3": principled(.3),
    "principled, roughness .5": principled(.5),
    "principled, roughness .7": principled(.7),
    "principled, roughness .9": principled(.9),
    "principled, roughness 1": principled(1),
    "principled .9, bump map": BUMPS + principled(.9, '"texture displacement" "bumps"'),
    "principled .9, no specular": principled(.9, '"float specularlevel" [0]'),
    "principled .9, diffuse roughness": principled(.9, '"float diffuseroughness" [.8]'),
    "principled .9, metal": principled(.9, '"float metallic" [1]'),
    "principled .8, half metal": principled(.8, '"float metallic" [.5]'),
    "principled .8, sheen": principled(.8, '"float sheen" [.8] "float sheenroughness" [.4]'),
    "principled .8, rough coat": principled(.8, '"float coat" [1] "float coatroughness" [.7] "rgb coattint" [.8 .6 .4]'),
    "principled .8, coloured coat": principled(.8, '"float coat" [1] "rgb coattint" [.6 .4 .2]'),
    "principled .8, translucent": principled(.8, '"float subsurface" [.7] "bool thinwall" ["true"]'),
    "principled .9, transmission": principled(.9, '"float transmission" [.4]'),
    "mix of metal .8 and diffuse": mix('"conductor" "rgb reflectance" [.8 .8 .8] "float roughness" [.8] '
                                       '"bool remaproughness" ["false"]', f'"diffuse" {GREY}'),
    "mix of coated and diffuse": mix(f'"coateddiffuse" {GREY} "float roughness" [.6]', f'"diffuse" {GREY}'),
    "hair": 'Material "hair" "rgb reflectance" [.5 .4 .3]',
    "subsurface": 'Material "subsurface" "rgb reflectance" [.6 .5 .4] "float roughness" [.7]',
}


def with_gloss(kind, alpha, ks=.3):
    """A material of pbrt-v3 with a diffuse base."""
    names = ("uroughness", "vroughness") if kind == "substrate" else ("roughness",)
    return (f'Material "{kind}" "rgb Kd" [.6 .6 .6] "rgb Ks" [{ks} {ks} {ks}] "bool remaproughness" ["false"] ' +
            " ".join(f'"float {name}" [{alpha}]' for name in names))


def disney(roughness, more=""):
    return f'Material "disney" "rgb color" [.7 .6 .5] "float roughness" [{roughness}] {more}'


# Materials that pbrt-v4 has no words for, in a room in those of pbrt-v3.
MATERIALS_V3 = {
    **{f"matte, sigma {s}": f'Material "matte" "rgb Kd" [.7 .7 .7] "float sigma" [{s}]' for s in (20, 40)},
    **{f"plastic, alpha {a}": with_gloss("plastic", a, 1) for a in (.3, .5, .8)},
    **{f"substrate, alpha {a}": with_gloss("substrate", a) for a in (.3, .6)},
    **{f"{kind}, alpha .7": with_gloss(kind, .7) for kind in ("uber", "translucent")},
    **{f"disney, roughness {r}": disney(r) for r in (.5, .8, 1)},
    "disney .8, sheen": disney(.8, '"float sheen" [.6]'),
}


def scene_of(name):
    if name in MATERIALS:
        return room(MATERIALS[name])
    text = room(MATERIALS_V3[name])
    for v4, v3 in (('"rgb" "integer', '"image" "integer'), ('"point3 P"', '"point P"'), ('"point2 uv"', '"float uv"'),
                   ('"diffuse" "rgb reflectance"', '"matte" "rgb Kd"')):
        text = text.replace(v4, v3)
    return text + "WorldEnd\n"


def blocks(path):
    """Means of blocks, [blocks], of luminance."""
    with OpenEXR.File(path) as file:
        channels = file.channels()
        rgb = channels["RGB"].pixels if "RGB" in channels else channels["RGBA"].pixels[..., :3]
    y = rgb.astype(np.float64) @ [.2126, .7152, .0722]
    return y.reshape(HEIGHT // BLOCK, BLOCK, WIDTH // BLOCK, BLOCK).mean((1, 3)).ravel()


def render(drc, scene, folder, seed, *options):
    picture = os.path.join(folder, "picture.exr")
    subprocess.run([drc, "render", scene, "-o", picture, "--quiet", "--denoise", "off", "--seed", str(seed), *options],
                   check=True)
    return blocks(picture)


def beyond_noise(test, paths):
    """The ratio's distance from one, less three standard errors, signed: of the block that is farthest, and of all."""
    def distance(a, b):
        a, b = np.asarray(a), np.asarray(b)
        ratio = a.mean(0) / b.mean(0) - 1
        error = np.sqrt(a.var(0, ddof=1) / len(a) + b.var(0, ddof=1) / len(b)) / b.mean(0)
        # The scatter among a few seeds tells little of one block; that of all blocks together tells more.
        error = np.sqrt(np.mean(error ** 2))
        return np.sign(ratio) * np.maximum(0, np.abs(ratio) - 3 * error), error
    block, error = distance(test, paths)
    mean, _ = distance(np.mean(test, 1, keepdims=True), np.mean(paths, 1, keepdims=True))
    return block[np.argmax(np.abs(block))], mean[0], error


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("drc", nargs="+", help="builds; the last one's path tracer is what all are compared with")
    parser.add_argument("--spp", type=int, default=160)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--cell-size", default="auto", help="world units, separated by commas")
    parser.add_argument("--only", help="names of materials, or parts of them, separated by commas")
    args = parser.parse_args()
    names = [n for n in [*MATERIALS, *MATERIALS_V3] if not args.only or any(o in n for o in args.only.split(","))]
    columns = [(drc, size) for drc in args.drc for size in args.cell_size.split(",")]
    rows = []
    for name in names:
        row = [name]
        with tempfile.TemporaryDirectory() as folder:
            scene = os.path.join(folder, "scene.pbrt")
            with open(scene, "w") as file:
                file.write(scene_of(name))
            spp = ["--spp", str(args.spp)]
            paths = [render(args.drc[-1], scene, folder, 100 + s, "--integrator", "path", *spp)
                     for s in range(args.seeds)]
            for drc, size in columns:
                cell = [] if size == "auto" else ["--cell-size", size]
                tests = [render(drc, scene, folder, s, *spp, *cell) for s in range(args.seeds)]
                block, mean, error = beyond_noise(tests, paths)
                row += [f"{100 * mean:+.1f}", f"{100 * block:+.1f}", f"{100 * error:.2f}"]
        rows.append(row)
        print("  ".join(row), file=sys.stderr, flush=True)
    heads = [f"{h} %" for h in ("mean", "block", "noise")]
    print(table(["material", *heads * len(columns)], rows))


main()
