"""Runs pbrt itself, version 3 or 4, on a scene with our size, samples and integrator.

`drc export --pbrt` writes a copy of the scene into a folder of its own. The user's folder is left as it is.
"""
import os
import re
import shutil
import subprocess
import tempfile

import budget
from drc_export import Refused, find_drc, run_drc


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


def copy_scene(args, path):
    """Whether the scene is of version 4."""
    run_drc(find_drc(args.drc), ["--pbrt", args.scene, "--resolution", f"{args.width}x{args.height}", "--spp",
                                 str(args.spp), "--integrator", args.integrator, "--max-depth", str(args.max_depth),
                                 "-o", path])
    with open(path, "rb") as f:
        return f.readline() == b"# pbrt-v4\n"


def render(version, args):
    pbrt = program(version)
    with tempfile.TemporaryDirectory() as folder:
        scene, picture = os.path.join(folder, "scene.pbrt"), os.path.join(folder, "picture.exr")
        is_v4 = copy_scene(args, scene)
        if is_v4 and version == 3:
            raise Refused(None, f"{args.scene}: is a scene of pbrt-v4")
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
