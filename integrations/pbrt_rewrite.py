"""Runs pbrt itself, version 3 or 4, on a scene with our size, samples and integrator.

A copy of the scene, in a folder of its own, has Film, Sampler and Integrator replaced, what the scene includes in its
place, and absolute paths to the files that it names. The user's folder is left as it is.
"""
import os
import re
import shutil
import subprocess
import tempfile

import budget
from pbrt_tokens import Refused, Source, directives, find_file

FILE_PARAMETERS = ("filename", "mapname", "lensfile", "bsdffile")
REPLACED = ("Film", "Sampler", "Integrator", "SurfaceIntegrator", "Renderer", "Accelerator")
# Of Film: what changes the picture and is none of our business is kept.
FILM_REPLACED = ("filename", "xresolution", "yresolution")
# What only version 4 writes.
V4_DIRECTIVES = ("Attribute", "ColorSpace", "Option", "Import")
V4_FILMS = ("rgb", "gbuffer", "spectral")


class Settings:
    def __init__(self, width, height, spp, integrator, max_depth):
        self.width, self.height, self.spp = width, height, spp
        self.integrator, self.max_depth = integrator, max_depth


def rewritten(path, settings):
    """The text of the scene with our settings, and whether it is of version 4."""
    main = Source(path)
    parts, film = [], Film(settings)
    is_v4 = write(main, main, parts, film, 0)
    text = "".join(parts)
    at = re.search(r"^WorldBegin\b", text, re.MULTILINE)
    if at is None:
        raise Refused(None, f"{path}: there is no WorldBegin")
    head = (f'{film.text()}\nSampler "halton" "integer pixelsamples" [ {settings.spp} ]\n'
            f'Integrator "{settings.integrator}" "integer maxdepth" [ {settings.max_depth} ]\n')
    return text[:at.start()] + head + text[at.start():], is_v4


class Film:
    def __init__(self, settings):
        self.settings, self.kind, self.kept = settings, "image", ""

    def take(self, directive):
        (self.kind,) = directive.strings(1)
        self.kept = "".join(" " + source_text(p) for p in directive.params if p.name not in FILM_REPLACED)

    def text(self):
        return (f'Film "{self.kind}" "integer xresolution" [ {self.settings.width} ] '
                f'"integer yresolution" [ {self.settings.height} ] "string filename" [ "picture.exr" ]{self.kept}')


def source_text(param):
    values = " ".join(t.text for t in param.value_tokens)
    return f"{param.token.text} [ {values} ]"


def write(source, main, parts, film, depth):
    """Appends a file's directives to `parts`; whether one of them is of version 4."""
    is_v4 = False
    if depth > 20:
        raise Refused(None, f"{source.path}: files include each other without end")
    for d in directives(source):
        is_v4 = is_v4 or d.name in V4_DIRECTIVES
        if d.name == "Include":
            (name,) = d.strings(1)
            path = find_file(name, source, main)
            if path is None:
                raise Refused(d.pos, f'the included file "{name}" is not found')
            is_v4 = write(Source(path), main, parts, film, depth + 1) or is_v4
        elif d.name == "Film":
            film.take(d)
            is_v4 = is_v4 or film.kind in V4_FILMS
        elif d.name not in REPLACED:
            parts.append(with_paths(d, source, main) + "\n")
    return is_v4


def with_paths(d, source, main):
    """A directive as it is written, but with absolute paths."""
    text, at, parts = source.text, d.token.start, []
    for p in d.params:
        for token in p.value_tokens:
            if token.kind != "string" or not (p.name in FILE_PARAMETERS or p.kind == "spectrum"):
                continue
            path = find_file(token.value(), source, main)
            if path is not None:
                quoted = os.path.abspath(path).replace("\\", "\\\\").replace('"', '\\"')
                parts += [text[at:token.start], f'"{quoted}"']
                at = token.end
    return "".join(parts) + text[at:d.end]


def program(version):
    """pbrt, which both versions are called: by PBRT_V3 or PBRT_V4, else from PATH."""
    wanted = os.environ.get(f"PBRT_V{version}", "pbrt")
    found = shutil.which(wanted)
    if found is None:
        raise Refused(None, f"pbrt-v{version} is not found: PBRT_V{version} says where it is, else pbrt is looked for")
    return found


def run(command, **options):
    """pbrt goes on without what it cannot read and says so; then there is no picture of the scene."""
    done = subprocess.run(command, stderr=subprocess.PIPE, text=True, errors="replace", check=False, **options)
    errors = [line.strip() for line in done.stderr.splitlines() if re.search(r"\b(Error|Fatal)\b", line)]
    if errors:
        raise Refused(None, "pbrt: " + errors[0])
    if done.returncode != 0:
        last = (done.stderr.strip().splitlines() or ["no message"])[-1]
        raise Refused(None, f"pbrt ended with status {done.returncode}: {last}")
    return done.stdout or ""


def render(version, args):
    settings = Settings(args.width, args.height, args.spp, args.integrator, args.max_depth)
    pbrt = program(version)
    with tempfile.TemporaryDirectory() as folder:
        text, is_v4 = rewritten(args.scene, settings)
        if is_v4 and version == 3:
            raise Refused(None, f"{args.scene}: is a scene of pbrt-v4")
        scene, picture = os.path.join(folder, "scene.pbrt"), os.path.join(folder, "picture.exr")
        with open(scene, "w", encoding="utf-8", errors="surrogateescape") as f:
            f.write(text)
        command = [pbrt, "--nthreads", str(args.threads), "--outfile", picture]
        if version == 4:
            if not is_v4:
                upgraded = run([pbrt, "--upgrade", scene], stdout=subprocess.PIPE)
                with open(scene, "w", encoding="utf-8", errors="surrogateescape") as f:
                    f.write(upgraded)
            command += ["--spp", str(args.spp), "--seed", str(args.seed)]
        said = run(command + [scene], stdout=subprocess.PIPE)
        if not os.path.isfile(picture):
            raise Refused(None, "pbrt ended well but wrote no picture")
        shutil.move(picture, args.output)
    # The progress bar ends with the seconds of rendering.
    seconds = re.findall(r"\((\d+(?:\.\d+)?)s\)", said)
    if seconds:
        budget.write_timing(args.timing, float(seconds[-1]))


def main(version, about):
    parser = budget.arguments(about)
    parser.add_argument("--integrator", default="path")
    parser.add_argument("--max-depth", type=int, default=100)
    args = parser.parse_args()
    if args.spp is None:
        parser.error("pbrt keeps a number of samples, not seconds")
    render(version, args)
