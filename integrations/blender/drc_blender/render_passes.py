"""The layers of a render as Blender's passes."""

import numpy as np

# Blender's name, its channels, its kind, and the renderer's channels. Direct is what is seen of lamps, the world and emissive
# surfaces, and of their light after one bounce; Indirect is all else. They are not denoised, so their sum is Combined
# where that is not denoised either.
PASSES = (
    ("Combined", "RGBA", "COLOR", ("R", "G", "B")),
    ("Depth", "Z", "VALUE", ("depth.Z",)),
    ("Normal", "XYZ", "VECTOR", ("normal.X", "normal.Y", "normal.Z")),
    ("Denoising Albedo", "RGB", "COLOR", ("albedo.R", "albedo.G", "albedo.B")),
    ("Direct", "RGB", "COLOR", ("direct.R", "direct.G", "direct.B")),
    ("Indirect", "RGB", "COLOR", ("indirect.R", "indirect.G", "indirect.B")),
    ("Variance", "RGB", "COLOR", ("variance.R", "variance.G", "variance.B")),
    ("Sample Count", "X", "VALUE", ("samples.X",)),
)
BUILT_IN = {"Combined"}


def pass_values(picture, name, bounds):
    """Of a Picture of the whole film: the rows of a pass within (x0, x1, y0, y1), from the bottom, flat as Blender's
    passes are; None if the render has no such layer. Where the film is not transparent, alpha is 1."""
    _, kind, _, channels = next(p for p in PASSES if p[0] == name)
    planes = picture.layer(*channels)
    if planes is None:
        return None
    x0, x1, y0, y1 = bounds
    found = np.empty((y1 - y0, x1 - x0, len(kind)), dtype=np.float32)
    for channel, plane in enumerate(planes):
        found[..., channel] = plane[y0:y1, x0:x1][::-1]
    if kind == "RGBA":
        alpha = picture.layer("A")
        found[..., 3] = 1 if alpha is None else alpha[0][y0:y1, x0:x1][::-1]
    return found.reshape(-1)
