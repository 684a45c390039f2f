"""Reads values of node trees as expressions, and reports the nodes that have no equal."""

import subprocess

from . import colour_nodes, coordinate_nodes, light_profile, number_nodes, pattern_nodes, texture_nodes
from .expressions import as_colour, as_number, constant
from .image_lookup import Images

NODES = {
    **coordinate_nodes.NODES,
    **light_profile.NODES,
    **texture_nodes.NODES,
    **pattern_nodes.NODES,
    **number_nodes.NODES,
    **colour_nodes.NODES,
}


class Reader:
    """place: names for the report, from the outside to the inside."""

    def __init__(self, report, images=None, place=()):
        self.report, self.images, self.place = report, images or Images(), place
        self.skies = []  # the export.sky.Sky of each Sky Texture that was read
        self.suns_shown = False  # whether Sky Textures show their sun in every direction, to learn what it becomes
        self.ray = None  # the kind of ray, of ray_kinds.TOLD, that nodes are told of; None: they are the same for all
        self.rays_matter = False  # whether a node has asked

    def at(self, *place):
        return Reader(self.report, self.images, place)

    def for_ray(self, ray, report=None):
        """What a kind of ray meets. report: instead of this reader's."""
        made = Reader(report or self.report, self.images, self.place)
        made.ray = ray
        return made

    def sky(self, node):
        """The rendered sky of a Sky Texture, or why there is none."""
        from ..export.sky import bake

        try:
            self.skies.append(bake(node))
        except (OSError, RuntimeError, subprocess.SubprocessError) as error:
            return str(error)
        return self.skies[-1]

    def unsupported(self, at, what, instead=None):
        groups = [g.name for g in at.groups]
        self.report.add(what, *self.place, *groups, at.node.label or at.node.name)
        return instead

    def value(self, socket):
        """The expression of an input: of one column for numbers, of three for colours and vectors."""
        source = socket.source()
        if not source.socket.is_output:
            made = self._own_value(source.socket)
        else:
            function = NODES.get(source.node.type)
            if function is not None:
                made = function(self, source)
            else:
                made = self.unsupported(
                    source,
                    f"the node {source.node.bl_label} has no equal; the socket's own value is used",
                    self._own_value(socket.socket),
                )
        if socket.socket.type in ("VALUE", "INT", "BOOLEAN"):
            return as_number(made)
        return as_colour(made) if socket.socket.type in ("RGBA", "VECTOR") else made

    @staticmethod
    def _own_value(socket):
        value = getattr(socket, "default_value", 0.0)
        return constant(*tuple(value)[:3]) if hasattr(value, "__len__") else constant(float(value))
