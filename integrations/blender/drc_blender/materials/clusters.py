"""Groups of rows that are nearly alike, by median cuts (Heckbert 1982)."""

import heapq

import numpy as np

MOST_GROUPS = 64
ALIKE = 1 / 255  # values of a group's rows, each column for itself


def groups_of(rows):
    """Arrays of row numbers: of rows, n x k and all finite, in MOST_GROUPS groups at most, of one row at least."""
    rows = np.asarray(rows, dtype=np.float64)

    def entry(members):
        spread = np.ptp(rows[members], axis=0)
        column = int(spread.argmax())
        # The number tells apart what is equally wide.
        return -float(spread[column]) * len(members) ** 0.5, int(members[0]), column, float(spread[column]), members

    heap, done = [entry(np.arange(len(rows)))], []
    while heap and len(heap) + len(done) < MOST_GROUPS:
        _, _, column, spread, members = heapq.heappop(heap)
        if spread <= ALIKE:
            done.append(members)
            continue
        values = rows[members, column]
        middle = (values.min() + values.max()) / 2
        low = values <= middle if middle < values.max() else values < values.max()
        heapq.heappush(heap, entry(members[low]))
        heapq.heappush(heap, entry(members[~low]))
    return done + [members for *_, members in heap]
