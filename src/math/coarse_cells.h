// Tables for sampling that are smaller than the image that they are made of: several texels share a cell, where that
// costs next to nothing. Small tables fit into the processor's caches.
#pragma once
#include <span>
#include <vector>

namespace drc {

constexpr double kNoiseAllowed = 1.05;

// Integrals of a function over the texels of an image, row-major.
struct TexelIntegrals {
    int width = 0, height = 0;
    std::vector<float> values;
};

// The largest cell, in texels along a side, by which the function may be sampled. A power of two of at most 32 that
// divides both sides of the image, for which the second moment of the samples (function over density) is at most
// kNoiseAllowed times that of cells of one texel. texelSizes: area or solid angle of a texel, for each row.
int coarsestCell(const TexelIntegrals& f, std::span<const double> texelSizes);

// The integrals over cells of cell x cell texels. `cell` must divide both sides.
TexelIntegrals sumsOverCells(const TexelIntegrals& f, int cell);

}  // namespace drc
