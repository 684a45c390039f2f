"""Arrays of points: patterns are computed for blocks of them that stay in a core's cache, which also bounds their memory."""

import numpy as np

BLOCK = 1 << 14


def in_blocks(function, points):
    """function of all rows of points, an array of as many rows."""
    pieces = [function(points[begin : begin + BLOCK]) for begin in range(0, len(points), BLOCK)]
    return pieces[0] if len(pieces) == 1 else np.concatenate(pieces)


def beside(*arrays):
    """The columns of all arrays, of 1 or n rows each; numbers are columns of that number."""
    arrays = [np.float32(a).reshape(-1, 1) if np.ndim(a) == 0 else a for a in arrays]
    rows = max(len(a) for a in arrays)
    return np.concatenate([np.broadcast_to(a, (rows, a.shape[1])) for a in arrays], axis=1)
