"""What the comparison scripts share: running drc, and tables. Needs only Python's standard library."""
import json
import os
import subprocess
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DRC = os.environ.get("DRC", os.path.join(ROOT, "build/release/drc"))


def render(scene, output, *options):
    """Renders, and returns the wall-clock seconds of the whole process."""
    start = time.monotonic()
    subprocess.run([DRC, "render", scene, "-o", output, "--quiet", *map(str, options)], check=True)
    return time.monotonic() - start


def compare(reference, test, *options):
    out = subprocess.run([DRC, "compare", reference, test, "--json", *options], check=True, capture_output=True, text=True)
    return json.loads(out.stdout)


def resolution(reference):
    """Width and height of an EXR, from its header's data window."""
    import struct
    with open(reference, "rb") as f:
        header = f.read(65536)
    at = header.index(b"dataWindow\0box2i\0") + len(b"dataWindow\0box2i\0") + 4
    x0, y0, x1, y1 = struct.unpack("<4i", header[at:at + 16])
    return f"{x1 - x0 + 1}x{y1 - y0 + 1}"


def table(head, rows):
    """A Markdown table with aligned columns."""
    cells = [head] + [[str(c) for c in row] for row in rows]
    widths = [max(len(row[i]) for row in cells) for i in range(len(head))]
    lines = ["| " + " | ".join(c.ljust(w) for c, w in zip(row, widths)) + " |" for row in cells]
    lines.insert(1, "|" + "|".join("-" * (w + 2) for w in widths) + "|")
    return "\n".join(lines)
