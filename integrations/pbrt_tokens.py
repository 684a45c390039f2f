"""Tokens, directives and parameters of pbrt scene files, each with its place, for the adapters of this folder."""
import os
import re


class Refused(Exception):
    """What the renderer that the scene is meant for cannot match, or what is no scene at all, and where it stands."""

    def __init__(self, pos, what):
        super().__init__(f"{pos}: {what}" if pos else what)


def refuse(pos, what):
    raise Refused(pos, what)


class Source:
    def __init__(self, path):
        self.path = path
        try:
            with open(path, encoding="utf-8", errors="surrogateescape") as f:
                self.text = f.read()
        except OSError as error:
            raise Refused(None, f"{path}: cannot be read: {error.strerror}") from error


class Pos:
    """A place in a file. The line is counted only when it is printed."""

    def __init__(self, source, offset):
        self.source, self.offset = source, offset

    def __str__(self):
        return f"{self.source.path}:{self.source.text.count(chr(10), 0, self.offset) + 1}"


TOKEN = re.compile(r'(?P<space>\s+|#[^\n]*)|(?P<string>"(?:[^"\\\n]|\\.)*")|(?P<bracket>[\[\]])|(?P<word>[^\s"\[\]#]+)')
ESCAPES = {"b": "\b", "f": "\f", "n": "\n", "r": "\r", "t": "\t"}


class Token:
    __slots__ = ("kind", "text", "source", "start", "end")

    def __init__(self, kind, text, source, start, end):
        self.kind, self.text, self.source, self.start, self.end = kind, text, source, start, end

    @property
    def pos(self):
        return Pos(self.source, self.start)

    def value(self):
        """Of a string, without quotes and escapes."""
        text = self.text[1:-1]
        return re.sub(r"\\(.)", lambda m: ESCAPES.get(m[1], m[1]), text) if "\\" in text else text


def tokens(source):
    at, text = 0, source.text
    while at < len(text):
        match = TOKEN.match(text, at)
        if match is None:
            raise Refused(Pos(source, at), "a string is not closed")
        if match.lastgroup != "space":
            yield Token(match.lastgroup, match[0], source, at, match.end())
        at = match.end()


class Param:
    def __init__(self, kind, name, values, token, tokens_of_values):
        self.kind, self.name, self.values, self.token = kind, name, values, token
        self.value_tokens = tokens_of_values

    @property
    def pos(self):
        return self.token.pos


class Directive:
    """A word of the scene file and what follows it: numbers or strings in a row, then parameters."""

    def __init__(self, token, arguments, params, end):
        self.name, self.token, self.arguments, self.params, self.end = token.text, token, arguments, params, end

    @property
    def pos(self):
        return self.token.pos

    def strings(self, count):
        found = [a.value() for a in self.arguments if a.kind == "string"]
        if len(found) != count or len(self.arguments) != count:
            raise Refused(self.pos, f"{self.name} takes {count} string{'s' if count > 1 else ''}")
        return found

    def numbers(self, count):
        found = [number(a) for a in self.arguments if a.kind == "word"]
        if len(found) != count:
            raise Refused(self.pos, f"{self.name} takes {count} numbers, not {len(found)}")
        return found


def number(token):
    try:
        return float(token.text)
    except ValueError:
        raise Refused(token.pos, f"'{token.text}' stands where a number should") from None


# How many strings follow a directive before its parameters. Those that are not here take none, or numbers.
LEADING_STRINGS = {name: 1 for name in (
    "Accelerator", "AreaLightSource", "Camera", "CoordinateSystem", "CoordSysTransform", "Film", "Filter", "Include",
    "Import", "Integrator", "LightSource", "MakeNamedMaterial", "MakeNamedMedium", "Material", "NamedMaterial",
    "ObjectBegin", "ObjectInstance", "PixelFilter", "Renderer", "Sampler", "Shape", "SurfaceIntegrator",
    "VolumeIntegrator", "Option", "Attribute", "ColorSpace")}
LEADING_STRINGS.update({"Texture": 3, "MediumInterface": 2})


def directives(source):
    stream = list(tokens(source))
    at = 0
    while at < len(stream):
        token = stream[at]
        if token.kind != "word" or not token.text[0].isalpha():
            raise Refused(token.pos, f"'{token.text[:40]}' stands where a directive should")
        at += 1
        leading = LEADING_STRINGS.get(token.text, 0)
        arguments, params = [], []
        while at < len(stream):
            t = stream[at]
            if t.kind == "string" and len(arguments) >= leading:
                param, at = read_param(stream, at)
                params.append(param)
            elif t.kind == "word" and t.text[0].isalpha():
                break
            else:
                if t.kind != "bracket":
                    arguments.append(t)
                at += 1
        yield Directive(token, arguments, params, stream[at - 1].end)


def read_param(stream, at):
    declaration = stream[at]
    words = declaration.value().split()
    if len(words) != 2:
        raise Refused(declaration.pos, f"{declaration.text} is not a parameter's type and name")
    at += 1
    values = []
    if at < len(stream) and stream[at].text == "[":
        at += 1
        while at < len(stream) and stream[at].text != "]":
            values.append(stream[at])
            at += 1
        if at == len(stream):
            raise Refused(declaration.pos, f"the values of {declaration.text} are not closed by ]")
        at += 1
    elif at < len(stream):
        values.append(stream[at])
        at += 1
    read = [v.value() if v.kind == "string" else v.text if v.text in ("true", "false") else number(v) for v in values]
    return Param(words[0], words[1], read, declaration, values), at


class Params:
    """The parameters of one directive. What nobody asks for is refused: it would be left out without a word."""

    def __init__(self, owner, directive):
        self.owner, self.directive = owner, directive
        self.left = {p.name: p for p in directive.params}

    def take(self, name, kinds, default=None, count=None):
        """The values, or the default where the file does not say. kinds: the types that are understood."""
        param = self.left.pop(name, None)
        if param is None:
            return default
        if param.kind not in kinds:
            raise Refused(param.pos, f"{self.named(param)} is not matched, only as {' or '.join(kinds)}")
        if count is not None and len(param.values) != count:
            raise Refused(param.pos, f"{self.named(param)} has {len(param.values)} values, not {count}")
        if param.kind not in ("string", "bool", "texture"):
            for value in param.values:
                if isinstance(value, str):
                    raise Refused(param.pos, f'{self.named(param)} is not matched with the value "{value}"')
        return param.values

    def named(self, param):
        return f'"{param.kind} {param.name}" of {self.owner}'

    def float(self, name, default):
        return self.take(name, ("float",), [default], 1)[0]

    def rgb(self, name, default):
        return tuple(self.take(name, ("rgb", "color"), default, 3))

    def point(self, name, default):
        return tuple(self.take(name, ("point", "point3", "vector", "vector3"), default, 3))

    def string(self, name, default):
        return self.take(name, ("string",), [default], 1)[0]

    def bool(self, name, default):
        return self.take(name, ("bool",), ["true" if default else "false"], 1)[0] == "true"

    def ignore(self, *names):
        for name in names:
            self.left.pop(name, None)

    def place(self, name):
        """Where a parameter stands, for messages; where the directive does, if the file does not give it."""
        return next((p.pos for p in self.directive.params if p.name == name), self.directive.pos)

    def done(self):
        for param in self.left.values():
            raise Refused(param.pos, f"{self.named(param)} is not matched")


def find_file(name, source, main):
    """A file that a scene names: beside the file that names it, else beside the main scene file."""
    for folder in (os.path.dirname(source.path), os.path.dirname(main.path)):
        path = os.path.join(folder, name)
        if os.path.isfile(path):
            return path
    return None
