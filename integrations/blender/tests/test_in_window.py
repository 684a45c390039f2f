#!/usr/bin/env python3
"""The add-on in Blender's window, which is drawn on a display that nobody sees.

    integrations/blender/tests/test_in_window.py --drc build/release/drc [--keep FOLDER]

Needs the programs blender (4.2 or later) and Xvfb in PATH; without them the test is skipped: it ends with status 77. With
xdotool as well, it presses Escape. The add-on is installed as a user would, into a folder of its own. --keep keeps
pictures of the window there.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.abspath(os.path.join(HERE, *[os.pardir] * 3))
PATIENCE = 600


def version_of(blender):
    said = subprocess.run([blender, "--version"], capture_output=True, text=True).stdout
    found = re.search(r"Blender (\d+)\.(\d+)", said)
    return tuple(int(n) for n in found.groups()) if found else (0, 0)


def install(blender, environment, folder):
    package = os.path.join(folder, "drc-blender.zip")
    subprocess.run([sys.executable, os.path.join(ROOT, "scripts", "blender-extension"), package], check=True)
    done = subprocess.run(
        [blender, "--command", "extension", "install-file", "-r", "user_default", "--enable", package],
        env=environment,
        capture_output=True,
        text=True,
    )
    if done.returncode:
        raise SystemExit(f"the add-on could not be installed: {done.stdout}{done.stderr}")


def display(folder):
    """(Xvfb, the name of its display). Its picture is the file Xvfb_screen0 of the folder."""
    read, write = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24", "-fbdir", folder],
        pass_fds=[write],
        stderr=subprocess.DEVNULL,
    )
    os.close(write)
    with os.fdopen(read) as f:
        return server, ":" + f.readline().strip()


def left_behind(mark):
    """Command lines of processes that have this word."""
    found = []
    for pid in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{pid}/cmdline", "rb") as f:
                line = f.read().replace(b"\0", b" ").decode("utf-8", "replace")
        except OSError:  # it has ended meanwhile
            continue
        if mark in line:
            found.append(line)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--drc", required=True, help="the program")
    parser.add_argument("--keep", help="a folder for pictures of the window")
    args = parser.parse_args()
    blender = shutil.which("blender")
    if blender is None or shutil.which("Xvfb") is None:
        print("skipped: blender and Xvfb are not both in PATH")
        return SKIPPED
    if version_of(blender) < (4, 2):
        print("skipped: this Blender is older than 4.2")
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix="drc-window-") as folder:
        environment = {**os.environ, "BLENDER_USER_RESOURCES": os.path.join(folder, "user"), "TMPDIR": folder}
        install(blender, environment, folder)
        server, name = display(folder)
        report = os.path.join(folder, "report.json")
        pictures = os.path.abspath(args.keep or folder)
        os.makedirs(pictures, exist_ok=True)
        try:
            done = subprocess.run(
                [blender, "--python", os.path.join(HERE, "window_steps.py"), "--"]
                + [os.path.abspath(args.drc), report, os.path.join(folder, "Xvfb_screen0"), pictures],
                env={**environment, "DISPLAY": name, "LIBGL_ALWAYS_SOFTWARE": "1"},
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                timeout=PATIENCE,
            )
            seen = []
            if os.path.exists(report):
                with open(report) as f:
                    seen = json.load(f)
            seen.append(("Blender ends", done.returncode == 0, f"status {done.returncode}"))
            seen.append(("no Python error", "Traceback" not in done.stdout, ""))
            left = left_behind(os.path.join(folder, "blender_"))  # Blender's own temporary folder
            seen.append(("nothing is left running", not left, str(left)))
        finally:
            server.terminate()
            server.wait()
    for what, good, detail in seen:
        print(f"{'ok  ' if good else 'FAIL'} {what}" + (f": {detail}" if detail else ""))
    ended = any(what == "quits while it renders" for what, *_ in seen)
    if not (ended and all(good for _, good, _ in seen)):
        print(done.stdout[-4000:])
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
