#include "scene/lights/emission_grid.h"

#include "base/parallel.h"
#include "math/coarse_cells.h"

namespace drc {
namespace {

// Lookups of the image along each side of a cell. Two per texel integrate a cell of one texel exactly, because the
// interpolation is bilinear over each quarter of a texel.
constexpr int kPointsPerTexel = 2, kMostPoints = 8;
// A cell that covers at least this many texels along a side would need more than kMostPoints lookups. Its weight is the
// mean luminance of its texels instead.
constexpr float kTexelsSeen = float(kMostPoints) / kPointsPerTexel;
// Share of the texels' mean in the weight of smaller cells, so that every cell with light has a positive weight.
constexpr double kShareOfMean = 1 / 64.0;
constexpr int kCellsPerPiece = 4096;  // grain size of the parallel loop

}  // namespace

EmissionGrid::EmissionGrid(const EmissionImage& image, int columns, int rows, const Patch& patch, int mostCells) {
    columns = std::max(1, columns);
    rows = std::max(1, rows);
    while (double(columns) * rows > std::max(1, mostCells)) {
        columns = (columns + 1) / 2;
        rows = (rows + 1) / 2;
    }
    TexelIntegrals weights{columns, rows, std::vector<float>(size_t(columns) * size_t(rows))};
    struct Row {
        Cell sum;
        double squares = 0;  // integral of squared luminance over area: the second moment of uniform sampling
    };
    std::vector<Row> all(static_cast<size_t>(rows));
    parallelFor(0, rows, std::max(1, kCellsPerPiece / columns), [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            auto& [sum, squares] = all[size_t(y)];
            for (int x = 0; x < columns; ++x) {
                const Cell cell = cellOf(image, patch, Vec2(float(x) / float(columns), float(y) / float(rows)),
                                         Vec2(float(x + 1) / float(columns), float(y + 1) / float(rows)));
                weights.values[size_t(y) * size_t(columns) + size_t(x)] = float(cell.weight);
                sum.weight += cell.weight;
                sum.area += cell.area;
                if (cell.area > 0) squares += cell.weight * cell.weight / cell.area;
                for (int c = 0; c < 3; ++c) sum.flux[c] += cell.flux[c];
            }
        }
    });
    Row whole;
    for (const auto& [sum, squares] : all) {
        whole.squares += squares;
        whole.sum.weight += sum.weight;
        whole.sum.area += sum.area;
        for (int c = 0; c < 3; ++c) whole.sum.flux[c] += sum.flux[c];
    }
    const double cellSize = 1 / (double(columns) * rows);
    weight_ = whole.sum.weight * cellSize;
    for (int c = 0; c < 3; ++c) integral_[c] = float(whole.sum.flux[c] * cellSize);
    uniform_ = whole.squares * whole.sum.area <= kNoiseAllowed * whole.sum.weight * whole.sum.weight;
    if (uniform_) return;
    const std::vector<double> sizes(size_t(rows), 1.0);
    const TexelIntegrals cells = sumsOverCells(weights, coarsestCell(weights, sizes));
    distribution_ = Distribution2D(cells.values, cells.width, cells.height);
}

EmissionGrid::Cell EmissionGrid::cellOf(const EmissionImage& image, const Patch& patch, const Vec2& low,
                                        const Vec2& high) {
    Vec2 uvLow(kInfinity), uvHigh(-kInfinity);
    for (int i = 0; i < 4; ++i) {
        const Vec2 uv = patch(Vec2(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y)).uv;
        for (int k = 0; k < 2; ++k) {
            // Padded for the rounding of (u, v) inside the cell.
            const float pad = 0x1p-20f * (1 + std::abs(uv[k]));
            uvLow[k] = std::min(uvLow[k], uv[k] - pad);
            uvHigh[k] = std::max(uvHigh[k], uv[k] + pad);
        }
    }
    const float texels =
        std::max((uvHigh.x - uvLow.x) * float(image.width()), (uvHigh.y - uvLow.y) * float(image.height()));
    const int points =
        texels < kTexelsSeen ? std::max(kPointsPerTexel, int(std::ceil(kPointsPerTexel * texels))) : kMostPoints;
    Cell cell;
    for (int j = 0; j < points; ++j)
        for (int i = 0; i < points; ++i) {
            const PatchPoint at = patch(Vec2(lerp((float(i) + 0.5f) / float(points), low.x, high.x),
                                             lerp((float(j) + 0.5f) / float(points), low.y, high.y)));
            const Rgb radiance = image.lookup(at.uv);
            cell.area += double(at.area);
            cell.weight += double(at.area) * double(luminance(radiance));
            for (int c = 0; c < 3; ++c) cell.flux[c] += double(at.area) * double(radiance[c]);
        }
    const double perPoint = 1.0 / (points * points);
    for (double& flux : cell.flux) flux *= perPoint;
    cell.area *= perPoint;
    const double ofMean = cell.area * image.meanLuminance(uvLow, uvHigh);
    cell.weight = texels < kTexelsSeen ? (1 - kShareOfMean) * cell.weight * perPoint + kShareOfMean * ofMean : ofMean;
    return cell;
}

EmissionGrid::Sample EmissionGrid::sample(const Vec2& u) const {
    const Sample2D s = distribution_.sample(u);
    return {Vec2((float(s.x) + s.local.x) / float(distribution_.width()),
                 (float(s.y) + s.local.y) / float(distribution_.height())),
            s.pdf};
}

float EmissionGrid::density(const Vec2& at) const {
    const int columns = distribution_.width(), rows = distribution_.height();
    return distribution_.pdf(std::clamp(int(at.x * float(columns)), 0, columns - 1),
                             std::clamp(int(at.y * float(rows)), 0, rows - 1));
}

}  // namespace drc
