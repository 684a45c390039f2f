#include "scene/lights/rectified_environment.h"

#include "base/parallel.h"
#include "math/coarse_cells.h"

namespace drc {
namespace {

// Least number of cells along a side. Even a constant environment needs several cells, because the solid angle of a
// cell varies.
constexpr int kFewestCells = 64;
constexpr int kMostPointsPerCell = 8;  // lookups of the environment along each side of a cell
// Share of the mean over a cell and its eight neighbours in the cell's weight, for light that falls between the lookup
// points, such as the edge of the sun.
constexpr float kShareOfNeighbours = 1 / 8.f;

// Means over a cell, per unit of rectified coordinates.
struct Cell {
    float seen = 0, entering = 0;
    Rgb flux{0.f};
};

Cell cellOf(const Light& environment, const Portal& portal, int x, int y, int side, int points) {
    Cell cell;
    for (int j = 0; j < points; ++j)
        for (int i = 0; i < points; ++i) {
            const float step = 1 / float(points * side);
            const Portal::Direction at =
                portal.directionOf(Vec2((float(x * points + i) + 0.5f) * step, (float(y * points + j) + 0.5f) * step));
            const Rgb light = environment.escaped(Vec3(0.f), at.w) * (at.solidAngle / float(points * points));
            cell.seen += luminance(light);
            cell.entering += luminance(light) * at.cosine;
            cell.flux += light * at.cosine;
        }
    return cell;
}

std::vector<float> spread(const std::vector<float>& weights, int side) {
    std::vector<float> result(weights.size());
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            float sum = 0;
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    sum += weights[size_t(std::clamp(y + j, 0, side - 1)) * size_t(side) +
                                   size_t(std::clamp(x + i, 0, side - 1))];
            const size_t at = size_t(y) * size_t(side) + size_t(x);
            result[at] = lerp(kShareOfNeighbours, weights[at], sum / 9);
        }
    return result;
}

}  // namespace

RectifiedEnvironment::RectifiedEnvironment(const Light& environment, int rows, const Portal& portal, int mostCells) {
    // Rounded up to a multiple of the largest cell that coarsestCell() may return.
    constexpr int kMultiple = 32;
    const int side = (std::clamp(rows, kFewestCells, mostCells) + kMultiple - 1) / kMultiple * kMultiple;
    // The lookup points are at most two rows of the map apart: maps are interpolated bilinearly, so that every texel
    // contributes to some lookup.
    const int points = std::clamp((rows + 2 * side - 1) / (2 * side), 2, kMostPointsPerCell);
    std::vector<float> seen(size_t(side) * size_t(side)), entering(seen.size());
    std::vector<Rgb> fluxes(size_t(side), Rgb(0.f));
    parallelFor(0, side, 8, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < side; ++x) {
                const Cell cell = cellOf(environment, portal, x, y, side, points);
                seen[size_t(y) * size_t(side) + size_t(x)] = cell.seen;
                entering[size_t(y) * size_t(side) + size_t(x)] = cell.entering;
                fluxes[size_t(y)] += cell.flux;
            }
    });
    for (const Rgb& row : fluxes) flux_ += row / (float(side) * float(side));
    const std::vector<double> sizes(size_t(side), 1.0);
    const auto coarse = [&](const std::vector<float>& weights) {
        const TexelIntegrals cells{side, side, spread(weights, side)};
        return sumsOverCells(cells, coarsestCell(cells, sizes));
    };
    const TexelIntegrals ofSeen = coarse(seen), ofEntering = coarse(entering);
    seen_ = WindowedDistribution2D(ofSeen.values, ofSeen.width, ofSeen.height);
    entering_ = Distribution2D(ofEntering.values, ofEntering.width, ofEntering.height);
}

}  // namespace drc
