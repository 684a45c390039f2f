// Coarse tables for sampling an image: a cell covers several texels if this hardly increases the variance. Small tables
// fit into the processor's caches.
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

// Side, in texels, of the largest square cells that the function may be sampled by: a power of two of at most 32 that
// divides both sides of the image, and for which the second moment of function / pdf is at most kNoiseAllowed times
// that of cells of one texel. texelSizes: area or solid angle of a texel, for each row.
int coarsestCell(const TexelIntegrals& f, std::span<const double> texelSizes);

// The integrals over cells of cell x cell texels. `cell` must divide both sides of the image.
TexelIntegrals sumsOverCells(const TexelIntegrals& f, int cell);

}  // namespace drc
