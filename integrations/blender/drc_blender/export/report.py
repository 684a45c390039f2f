"""What the exporter has to tell: what has no equal in DRC, and what was rendered in its place."""


class Report:
    """Messages, each once, with the places that they concern."""

    def __init__(self):
        self._places = {}

    def add(self, what, *place):
        """place: names, from the outside to the inside, as of an object, its material and a node; in one line, whatever
        is in them."""
        names = (" ".join(str(p).split()) for p in place if p)
        self._places.setdefault(what, {})[" > ".join(names)] = None

    def __bool__(self):
        return bool(self._places)

    def lines(self, places=3):
        """One line a message, with its first places."""
        result = []
        for what, found in self._places.items():
            names = [p for p in found if p]
            more = f" and {len(names) - places} more" if len(names) > places else ""
            result.append((", ".join(names[:places]) + more + ": " if names else "") + what)
        return result
