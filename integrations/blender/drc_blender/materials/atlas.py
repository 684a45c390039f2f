"""Texture coordinates of an exporter's own, for textures that depend on more than those of the mesh: each triangle has
a place of its own in the picture, two in a square cell."""

import numpy as np

from .points import Points

BORDER = 1.5  # texels between a triangle's edge and its neighbour's


class Atlas:
    def __init__(self, triangles, size):
        """triangles: how many; size: texels along the picture's side, at most."""
        self.cells = max(1, int(np.ceil(np.sqrt(np.ceil(triangles / 2)))))
        self.cell = max(4, size // self.cells)  # texels
        self.size = self.cells * self.cell
        self.count = triangles

    def corners(self):
        """n x 3 x 2, in texels from the lower left: the even triangles of a cell lie at its lower left, the odd ones at its upper right."""
        pair, odd = np.divmod(np.arange(self.count), 2)
        origin = np.stack([pair % self.cells, pair // self.cells], axis=1) * self.cell
        near, far = BORDER, self.cell - 2 * BORDER
        lower = np.array([[near, near], [far, near], [near, far]])
        upper = self.cell - lower
        return origin[:, None] + np.where(odd[:, None, None], upper, lower)

    def uvs(self):
        return (self.corners() / self.size).astype(np.float32)

    def texels(self):
        """(triangle, weights) of each texel, row by row from below: whose it is, or -1, and its barycentric coordinates."""
        y, x = np.divmod(np.arange(self.size * self.size), self.size)
        pair = y // self.cell * self.cells + x // self.cell
        local = np.stack([x % self.cell, y % self.cell], axis=1) + 0.5
        odd = local.sum(axis=1) > self.cell
        triangle = 2 * pair + odd
        local = np.where(odd[:, None], self.cell - local, local)
        span = self.cell - 3 * BORDER
        b = (local - BORDER) / span
        weights = np.concatenate([1 - b.sum(axis=1, keepdims=True), b], axis=1).astype(np.float32)
        return np.where(triangle < self.count, triangle, -1), weights


def points_of(mesh, triangles, atlas, to_world, bounds):
    """The Points of the atlas' texels. bounds: (low, high) of the undeformed mesh; to_world: 4 x 4."""
    owner, weights = atlas.texels()
    corners = triangles[np.maximum(owner, 0)]

    def spread(values):  # corners x k
        return np.einsum("nk,nkc->nc", weights, values[corners]).astype(np.float32)

    position = np.einsum("nk,nkc->nc", weights, mesh.positions[mesh.corner_vertex[corners]]).astype(np.float32)
    low, high = (np.asarray(b, dtype=np.float32) for b in bounds)
    to_world = np.asarray(to_world, dtype=np.float32)
    normal = np.einsum("nk,nkc->nc", weights, mesh.corner_normals(triangles)[np.maximum(owner, 0)])
    normal = normal @ np.linalg.inv(to_world[:3, :3])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-30)
    return Points(
        len(owner),
        {name: spread(uv) for name, uv in mesh.uvs.items()},
        (position - low) / np.where(high > low, high - low, 1),
        position,
        position @ to_world[:3, :3].T + to_world[:3, 3],
        normal.astype(np.float32),
        {name: spread(c) for name, c in mesh.colours.items()},
    )
