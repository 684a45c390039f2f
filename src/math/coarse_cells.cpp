#include "math/coarse_cells.h"

namespace drc {
namespace {

constexpr int kLargestCell = 32;

// Second moment of function / pdf for cells of cell x cell texels, up to a constant factor.
double noise(const TexelIntegrals& f, std::span<const double> texelSizes, int cell) {
    double sum = 0;
    for (int y0 = 0; y0 < f.height; y0 += cell)
        for (int x0 = 0; x0 < f.width; x0 += cell) {
            double integral = 0, squares = 0, size = 0;
            for (int y = y0; y < y0 + cell; ++y) {
                const double texel = texelSizes[size_t(y)];
                size += cell * texel;
                for (int x = x0; x < x0 + cell; ++x) {
                    const double value = double(f.values[size_t(y) * size_t(f.width) + size_t(x)]);
                    integral += value;
                    squares += value * value / texel;
                }
            }
            if (integral > 0) sum += squares * size / integral;
        }
    return sum;
}

}  // namespace

int coarsestCell(const TexelIntegrals& f, std::span<const double> texelSizes) {
    const double least = noise(f, texelSizes, 1);
    int cell = kLargestCell;
    while (cell > 1 &&
           (f.width % cell != 0 || f.height % cell != 0 || noise(f, texelSizes, cell) > kNoiseAllowed * least))
        cell /= 2;
    return cell;
}

TexelIntegrals sumsOverCells(const TexelIntegrals& f, int cell) {
    TexelIntegrals sums{f.width / cell, f.height / cell, {}};
    sums.values.resize(size_t(sums.width) * size_t(sums.height));
    for (int y = 0; y < f.height; ++y)
        for (int x = 0; x < f.width; ++x)
            sums.values[size_t(y / cell) * size_t(sums.width) + size_t(x / cell)] +=
                f.values[size_t(y) * size_t(f.width) + size_t(x)];
    return sums;
}

}  // namespace drc
