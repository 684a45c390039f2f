"""Estimates how much the noise of two references adds to a cross error, from the two halves that each is the mean of.

The definitions are those of src/image/relative_norm.h, cross_error.h and tile_statistics.h, which say why they are as
they are; a test compares the noise found here with that of `drc compare`.
"""

from __future__ import annotations

import math

import numpy as np

_OFFSET = 0.01  # added to the squared norm
_SIGMA, _RADIUS, _HOLE = 2, 5, 1  # of the Gaussian window around a pixel, and of the pixels left out in its middle


def _convolved(plane: np.ndarray, along_x: np.ndarray, along_y: np.ndarray) -> np.ndarray:
    """With zeros around the plane."""
    height, width = plane.shape
    padded = np.pad(plane, _RADIUS)
    rows = sum(weight * padded[:, i : i + width] for i, weight in enumerate(along_x))
    return sum(weight * rows[i : i + height] for i, weight in enumerate(along_y))


def _ring_sums(plane: np.ndarray) -> np.ndarray:
    distance = np.arange(-_RADIUS, _RADIUS + 1)
    kernel = np.exp(-(distance**2) / (2 * _SIGMA**2))
    kernel /= kernel.sum()
    inside = np.abs(distance) <= _HOLE
    beside, within = np.where(inside, 0, kernel), np.where(inside, kernel, 0)
    # Sums of positive terms: nothing cancels, however bright the pixels in the hole are.
    return _convolved(plane, kernel, beside) + _convolved(plane, beside, within)


def relative_norm(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """The radiance D that errors are relative to: max(S, min(R1, R2) / 2), S the mean of both around the pixel."""
    finite = (np.isfinite(first) & np.isfinite(second)).all(axis=2, keepdims=True)
    a, b = (np.where(finite, np.maximum(image, 0), 0).astype(np.float64) for image in (first, second))
    calm = np.minimum((a + b) / 2, 2 * np.minimum(a, b))  # a firefly counts as twice the darker one
    weights = _ring_sums(finite[:, :, 0].astype(np.float64))
    around = np.stack([_ring_sums(calm[:, :, c]) for c in range(3)], axis=2)
    around = np.divide(around, weights[:, :, None], out=np.zeros_like(around), where=weights[:, :, None] > 0)
    own = np.minimum(first, second) / 2
    return np.where(np.isfinite(own), np.maximum(around, own), around)


def _products(a: np.ndarray, b: np.ndarray, norm: np.ndarray) -> np.ndarray:
    """The mean over the channels of a b / (norm^2 + 0.01) at each pixel."""
    return (a.astype(np.float64) * b / (norm**2 + _OFFSET)).mean(axis=2)


def reference_noise(first: np.ndarray, second: np.ndarray) -> float:
    """The noise of each of two references, in the norm of the errors."""
    difference = first.astype(np.float64) - second
    products = _products(difference, difference, relative_norm(first, second))
    return float(products[np.isfinite(products)].mean()) / 2


def _standard_error_of_zero(values: np.ndarray) -> float:
    """The standard error of a mean whose expectation is zero, by sums of tiles, since neighbours may be dependent."""
    height, width = values.shape
    side = min(32, max(8, int(math.sqrt(width * height / 64))))
    across, down = (max(1, math.floor(pixels / side + 0.5)) for pixels in (width, height))
    tile = (np.arange(height) * down // height)[:, None] * across + np.arange(width) * across // width
    known = np.isfinite(values)
    sums = np.bincount(tile[known], weights=values[known], minlength=across * down)
    count = int(known.sum())
    return math.sqrt(float((sums**2).sum())) / count if count else math.nan


def standard_error(halves: list[np.ndarray]) -> float:
    """halves: two of the first reference, two of the second.

    Half of the difference of two halves has the noise of their mean, so the product of the two references' half
    differences is what their noise adds to a cross error, and has mean zero.
    """
    a, b, c, d = (half.astype(np.float64) for half in halves)
    norm = relative_norm((a + b) / 2, (c + d) / 2)
    return _standard_error_of_zero(_products((a - b) / 2, (c - d) / 2, norm))
