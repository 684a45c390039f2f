"""drc itself, as the laboratory calls it: what measures and what reads pictures is in C++, and says it as JSON."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from .errors import Error
from .process import last_line

if TYPE_CHECKING:
    import numpy as np

_PREFIX = re.compile(r"^drc: (error: )?")


def find_program(named: str | None) -> str:
    """Finds the program that the user or DRC_PROGRAM names, else that of the build, else drc in PATH."""
    here = Path(__file__).resolve()
    candidates = [named] if named else [os.environ.get("DRC_PROGRAM"), here.parents[2] / "build/release/drc", "drc"]
    for candidate in candidates:
        found = shutil.which(str(candidate)) if candidate else None
        if found:
            return os.path.realpath(found)
    what = f"--drc {named}: is no program" if named else "drc is not found: build it, or name it by --drc"
    raise Error(what)


class Program:
    def __init__(self, path: str) -> None:
        self.path = path

    def _call(self, *arguments: str) -> str:
        try:
            done = subprocess.run(
                [self.path, *arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace",
                process_group=0,
            )  # fmt: skip
        except OSError as error:
            raise Error(f"{self.path}: cannot be started: {error.strerror}") from None
        if done.returncode != 0:
            raise Error(_PREFIX.sub("", last_line(done.stderr)) or f"{self.path}: exit code {done.returncode}")
        return done.stdout

    def version(self) -> str:
        return self._call("--version").split()[-1]

    def compare(self, references: list[str], picture: str) -> dict:
        """The errors of a picture against one reference or two (`drc compare --json`)."""
        return json.loads(self._call("compare", *references, picture, "--json"))

    def info(self, picture: str) -> dict:
        """Size, metadata and channels of a picture."""
        return json.loads(self._call("image", "info", picture, "--json"))[0]

    def metadata(self, picture: str) -> dict[str, str]:
        return self.info(picture).get("metadata") or {}

    def average(self, pictures: list[str], output: Path) -> None:
        """Writes the mean; the file is there whole or not at all."""
        self._call("image", "average", *pictures, "-o", str(output))

    def png(self, picture: str) -> bytes:
        """The picture as it is displayed, as the bytes of a PNG."""
        with tempfile.TemporaryDirectory(prefix="drc-lab-") as folder:
            file = Path(folder, "picture.png")
            self._call("image", "convert", picture, "-o", str(file))
            return file.read_bytes()

    def pixels(self, picture: str) -> np.ndarray:
        """Linear RGB, height x width x 3."""
        import numpy as np

        with tempfile.TemporaryDirectory(prefix="drc-lab-") as folder:
            file = Path(folder, "picture.pfm")
            self._call("image", "convert", picture, "-o", str(file))
            data = file.read_bytes()
        kind, size, scale, values = data.split(b"\n", 3)
        width, height = map(int, size.split())
        channels = 3 if kind == b"PF" else 1
        pixels = np.frombuffer(values, "<f4" if float(scale) < 0 else ">f4", width * height * channels)
        pixels = pixels.reshape(height, width, channels)[::-1]  # PFM has the lowest line first
        return np.repeat(pixels, 3, axis=2) if channels == 1 else pixels
