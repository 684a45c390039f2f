"""What `drc export` says of a scene, for the adapters of this folder: docs/scene-export.md describes the format."""
import json
import os
import re
import shutil
import subprocess

VERSION = 1


class Refused(Exception):
    """What the renderer that the scene is meant for cannot match, or what is no scene at all, and where it stands."""

    def __init__(self, place, what):
        super().__init__(f"{place}: {what}" if place else what)


def refuse(place, what):
    raise Refused(place, what)


def find_drc(named):
    """The drc that an argument or DRC_PROGRAM names, else that of the build, else drc in PATH."""
    build = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "build", "release", "drc")
    for program in [named] if named else [os.environ.get("DRC_PROGRAM"), build, "drc"]:
        found = shutil.which(program) if program else None
        if found:
            return found
    raise Refused(None, f"--drc {named}: is no program" if named else
                  "drc is not found: build it, or name it by --drc or DRC_PROGRAM")


def run_drc(program, arguments):
    """Runs `drc export`. Its error is refused, and all its warnings are returned, without the program's name."""
    try:
        done = subprocess.run([program, "export", *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, encoding="utf-8", errors="replace", check=False)
    except OSError as error:
        raise Refused(None, f"{program}: cannot be started: {error.strerror}") from error
    said = [line[len("drc: "):] for line in done.stderr.splitlines() if line.startswith("drc: ")]
    if done.returncode != 0:
        errors = [line[len("error: "):] for line in said if line.startswith("error: ")]
        raise Refused(None, errors[-1] if errors else f"{program} export ended with status {done.returncode}")
    return [line for line in said if re.search(r"\bwarning: ", line)]


class Params:
    """The parameters of one directive. What nobody asks for is refused: it would be left out without a word."""

    def __init__(self, owner, directive):
        self.owner, self.directive = owner, directive
        self.left = {p["name"]: p for p in directive["parameters"]}

    def take(self, name, kinds, default=None, count=None):
        """The values, or the default where the file does not say. kinds: the types that are understood."""
        param = self.left.pop(name, None)
        if param is None:
            return default
        if param["type"] not in kinds:
            refuse(param["at"], f"{self.named(param)} is not matched, only as {' or '.join(kinds)}")
        if count is not None and len(param["values"]) != count:
            refuse(param["at"], f"{self.named(param)} has {len(param['values'])} values, not {count}")
        return param["values"]

    def named(self, param):
        return f'"{param["type"]} {param["name"]}" of {self.owner}'

    def float(self, name, default):
        return self.take(name, ("float",), [default], 1)[0]

    def rgb(self, name, default):
        return tuple(self.take(name, ("rgb", "color"), default, 3))

    def point(self, name, default):
        return tuple(self.take(name, ("point", "point3", "vector", "vector3"), default, 3))

    def string(self, name, default):
        return self.take(name, ("string",), [default], 1)[0]

    def bool(self, name, default):
        return self.take(name, ("bool",), [default], 1)[0]

    def ignore(self, *names):
        for name in names:
            self.left.pop(name, None)

    def place(self, name):
        """Where a parameter stands, for messages; where the directive does, if the file does not give it."""
        return next((p["at"] for p in self.directive["parameters"] if p["name"] == name), self.directive["at"])

    def done(self):
        for param in self.left.values():
            refuse(param["at"], f"{self.named(param)} is not matched")


def read_document(program, scene, folder):
    """The scene as `drc export --json` has it, with "file:line:column" in place of every "at", and drc's warnings. Its
    meshes are written to the folder."""
    path = os.path.join(folder, "scene.json")
    warnings = run_drc(program, ["--json", scene, "--meshes", os.path.join(folder, "meshes"), "-o", path])
    with open(path, encoding="utf-8") as f:
        document = json.load(f)
    if document.get("format") != "drc-scene" or document.get("version") != VERSION:
        raise Refused(None, f"{program} writes scenes in another version than {VERSION}, which these adapters read")
    name_places(document, document["files"])
    return document, warnings


def name_places(value, files):
    if isinstance(value, list):
        if value and isinstance(value[0], (dict, list)):
            for item in value:
                name_places(item, files)
        return
    for key, item in value.items():
        if key in ("at", "dialect_at") and item is not None:
            file, line, column = item
            value[key] = f"{files[file]}:{line}:{column}"
        elif isinstance(item, (dict, list)):
            name_places(item, files)
