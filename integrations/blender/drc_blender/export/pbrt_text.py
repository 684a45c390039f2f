"""The words of a pbrt-v4 scene file."""

import math


def number(value):
    """Shortest text that gives the same 32-bit float; pbrt has no words for infinities."""
    value = float(value)
    if not math.isfinite(value):
        raise ValueError(f"{value}, which a scene file cannot have")
    return f"{value:.9g}"


def quoted(text):
    """A string of a scene file, which has no way to write a quotation mark or a line's end."""
    return '"' + "".join("_" if c in '"\\' or ord(c) < 32 else c for c in str(text)) + '"'


def _values(kind, value):
    if kind == "bool":
        return "true" if value else "false"
    if kind in ("string", "texture", "spectrum"):
        return " ".join(quoted(v) for v in ([value] if isinstance(value, str) else value))
    values = value if hasattr(value, "__len__") else [value]
    return " ".join(str(int(v)) for v in values) if kind == "integer" else " ".join(number(v) for v in values)


def statement(word, *names, **options):
    """A directive, its names and its parameters.

    statement("Shape", "sphere", params={"float radius": 2}) is: Shape "sphere" "float radius" [2]
    """
    parts = [word] + [quoted(name) for name in names]
    for declared, value in (options.get("params") or {}).items():
        kind, name = declared.split()
        try:
            parts.append(f'"{declared}" [{_values(kind, value)}]')
        except ValueError as error:
            raise ValueError(f"{name} is {error}") from error
    return " ".join(parts)


def transform(matrix, word="Transform"):
    """A matrix of rows, which acts on columns, as pbrt writes it: column by column."""
    return f"{word} [" + " ".join(number(matrix[row][column]) for column in range(4) for row in range(4)) + "]"


class Names:
    """Names for what has names in Blender: readable, and no two alike."""

    def __init__(self):
        self._taken = set()

    def of(self, name):
        base = "".join(c if c.isalnum() or c in "._-" else "_" for c in str(name)) or "unnamed"
        found, i = base, 1
        while found in self._taken:
            i += 1
            found = f"{base}.{i}"
        self._taken.add(found)
        return found
