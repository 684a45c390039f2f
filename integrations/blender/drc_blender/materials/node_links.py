"""Walks node trees: through groups, reroutes and muted nodes, to the socket that gives a value."""

import warnings


def tree_of(owner):
    """The node tree of a material, world or lamp; None if its own colour counts."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # from Blender 6 on there are always nodes
        used = getattr(owner, "use_nodes", True)
    return owner.node_tree if used else None


class Socket:
    """A socket, and the group nodes that lead to its tree from the outside."""

    def __init__(self, socket, groups=()):
        self.socket, self.groups = socket, tuple(groups)

    @property
    def node(self):
        return self.socket.node

    def input(self, name):
        """An input of the same node by its identifier or name, the enabled one if several have it; None without."""
        found = None
        for candidate in self.node.inputs:
            if candidate.identifier == name or candidate.name == name:
                if candidate.enabled and not getattr(candidate, "is_unavailable", False):
                    return Socket(candidate, self.groups)
                found = found or candidate
        return Socket(found, self.groups) if found is not None else None

    def inputs(self):
        return [
            Socket(s, self.groups) for s in self.node.inputs if s.enabled and not getattr(s, "is_unavailable", False)
        ]

    def source(self):
        """The output that an input is linked to, or the input itself if its own value counts."""
        here, passed = self, 0
        while passed < 1000:
            passed += 1
            if not here.socket.is_output:
                links = [link for link in here.socket.links if link.is_valid and not link.is_muted]
                if not here.socket.is_linked or not links:
                    return here
                here = Socket(links[0].from_socket, here.groups)
            node = here.node
            if node.mute:
                inside = [link for link in node.internal_links if link.to_socket == here.socket]
                if not inside:
                    return here
                here = Socket(inside[0].from_socket, here.groups)
            elif node.type == "REROUTE":
                here = Socket(node.inputs[0], here.groups)
            elif node.type == "GROUP" and node.node_tree is not None:
                output = group_output(node.node_tree)
                inner = by_identifier(output.inputs, here.socket.identifier) if output is not None else None
                if inner is None:
                    return here
                here = Socket(inner, here.groups + (node,))
            elif node.type == "GROUP_INPUT" and here.groups:
                outer = by_identifier(here.groups[-1].inputs, here.socket.identifier)
                if outer is None:
                    return here
                here = Socket(outer, here.groups[:-1])
            else:
                return here
        return here


def by_identifier(sockets, identifier):
    return next((s for s in sockets if s.identifier == identifier), None)


def group_output(tree):
    outputs = [n for n in tree.nodes if n.type == "GROUP_OUTPUT"]
    return next((n for n in outputs if n.is_active_output), outputs[0] if outputs else None)


def active_output(tree, kind):
    """The node that counts: kind is OUTPUT_MATERIAL, OUTPUT_WORLD or OUTPUT_LIGHT. One for all renderers is as good as
    one for Cycles."""
    outputs = [n for n in tree.nodes if n.type == kind and not n.mute]
    usable = [n for n in outputs if getattr(n, "target", "ALL") in ("ALL", "CYCLES")] or outputs
    return next((n for n in usable if n.is_active_output), usable[0] if usable else None)
