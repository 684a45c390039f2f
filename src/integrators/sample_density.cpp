#include "integrators/sample_density.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "image/relative_norm.h"

namespace drc {
namespace {

// The guided filter: its radius in cells, and the standard deviations of its Gaussian weights on differences of albedo
// and normal.
constexpr int kRadius = 2;
constexpr float kAlbedoDeviation = 0.03f, kNormalDeviation = 0.1f;
// The density is (noise * contrast^kPowerOfContrast)^kPower. If error falls with the number of samples n as 1 / n, the
// sum of the errors is least where n is proportional to the square root of the error; a smaller power is better,
// because the estimates are inaccurate. The powers, the radius and the deviations gave the least error of several that
// were tried (docs/decisions/radiance-cells.md).
constexpr double kPower = 0.35, kPowerOfContrast = 0.5, kLeastContrast = 1e-6;
// Upper bound on the squared difference of a cell's halves, relative to the squared radiance around it: a few more
// samples do not average a firefly away.
constexpr float kMostDifference = 4;
// Rows of cells that a thread sums at a time.
constexpr int kRowsAtATime = 4;

float square(float v) { return v * v; }

// Denominator of squared differences of displayed radiance: mean^2 + offset, as in the error measure of pictures.
float relativeTo(float mean) { return square(mean) + float(kRelativeNormOffset); }

}  // namespace

void SampleDensity::Sums::add(const Sums& other) {
    for (const int half : {0, 1}) {
        value[half] += other.value[half];
        samples[half] += other.samples[half];
    }
    albedo += other.albedo;
    normal += other.normal;
}

SampleDensity::SampleDensity(const PixelRegion& region, float displayScale)
    : region_(region), scale_(displayScale > 0 ? displayScale : 1) {
    cells_.resize(size_t(cellRows()) * size_t(cellColumns()));
    rows_.resize(size_t(region.height()) * size_t(cellColumns()));
    densities_.resize(size_t((region.height() + kBlock - 1) / kBlock) * size_t(columns()), 1);
}

void SampleDensity::add(int x, int y, int half, float value, const GBufferSample& surface) {
    Sums& sums = rows_[size_t(y - region_.y0) * size_t(cellColumns()) + size_t((x - region_.x0) / kCell)];
    sums.value[half] += value;
    ++sums.samples[half];
    sums.albedo += surface.albedo;
    sums.normal += surface.normal;
}

void SampleDensity::addRows() {
    const auto width = size_t(cellColumns());
    parallelFor(0, cellRows(), kRowsAtATime, [&](int begin, int end) {
        for (int row = begin * kCell; row < std::min(end * kCell, region_.height()); ++row)
            for (size_t column = 0; column < width; ++column) {
                Sums& sums = rows_[size_t(row) * width + column];
                cells_[size_t(row / kCell) * width + column].add(sums);
                sums = {};
            }
    });
}

void SampleDensity::update(int samples) {
    addRows();
    if (samples < nextUpdate_) return;
    // Updates after every sample at first, later whenever the number of samples has grown by a quarter.
    nextUpdate_ = samples + 1 + samples / 4;
    const std::vector<Estimate> cells = estimates();
    std::vector<double> errors(densities_.size());
    constexpr int kCells = kBlock / kCell;
    parallelFor(0, int(errors.size()), columns(), [&](int begin, int end) {
        for (int block = begin; block < end; ++block) {
            const int row0 = block / columns() * kCells, column0 = block % columns() * kCells;
            Estimate sum;
            double count = 0;
            for (int row = row0; row < std::min(row0 + kCells, cellRows()); ++row)
                for (int column = column0; column < std::min(column0 + kCells, cellColumns()); ++column) {
                    const Estimate& cell = cells[size_t(row) * size_t(cellColumns()) + size_t(column)];
                    sum.noise += cell.noise;
                    sum.contrast += cell.contrast;
                    ++count;
                }
            const double noise = sum.noise / count, contrast = sum.contrast / count;
            errors[size_t(block)] = std::pow(noise * std::pow(contrast + kLeastContrast, kPowerOfContrast), kPower);
        }
    });
    decide(errors);
}

std::vector<SampleDensity::Estimate> SampleDensity::estimates() const {
    // The means of a cell, which the filter reads, and the filter's results.
    struct Cell {
        Rgb albedo{0.f};
        Vec3 normal{0.f};
        float samples = 0;  // per pixel, mean over the cell
        float mean = 0, difference = 0, filtered = 0;
        float noise = 0;  // the variance of `filtered` if every pixel had one sample
        bool valid = false;
    };
    const int width = cellColumns(), height = cellRows();
    std::vector<Cell> cells(cells_.size());
    parallelFor(0, int(cells.size()), width, [&](int begin, int end) {
        for (auto i = size_t(begin); i < size_t(end); ++i) {
            const Sums& sums = cells_[i];
            Cell& cell = cells[i];
            cell.valid = sums.samples[0] > 0 && sums.samples[1] > 0;
            if (!cell.valid) continue;
            cell.samples = sums.count() / (kCell * kCell);
            cell.albedo = sums.albedo * (1 / sums.count());
            cell.normal = sums.normal * (1 / sums.count());
            const float halves[] = {scale_ * sums.value[0] / sums.samples[0], scale_ * sums.value[1] / sums.samples[1]};
            cell.mean = 0.5f * (halves[0] + halves[1]);
            cell.difference = 0.5f * (halves[0] - halves[1]);
        }
    });
    // Calls f(other) for each valid cell within `radius` cells of the given one.
    const auto around = [&](int row, int column, int radius, const auto& f) {
        for (int y = std::max(0, row - radius); y <= std::min(height - 1, row + radius); ++y)
            for (int x = std::max(0, column - radius); x <= std::min(width - 1, column + radius); ++x)
                if (const Cell& cell = cells[size_t(y) * size_t(width) + size_t(x)]; cell.valid) f(cell);
    };
    parallelFor(0, height, 1, [&](int row, int) {
        for (int column = 0; column < width; ++column) {
            Cell& cell = cells[size_t(row) * size_t(width) + size_t(column)];
            if (!cell.valid) continue;
            std::array<std::pair<float, const Cell*>, (2 * kRadius + 1) * (2 * kRadius + 1)> weighted;
            size_t count = 0;
            float weights = 0, sum = 0;
            around(row, column, kRadius, [&](const Cell& other) {
                const Rgb albedo = other.albedo - cell.albedo;
                const Vec3 normal = other.normal - cell.normal;
                const float weight = std::exp(-0.5f * (dot(albedo, albedo) / square(kAlbedoDeviation) +
                                                       dot(normal, normal) / square(kNormalDeviation)));
                weights += weight;
                sum += weight * other.mean;
                weighted[count++] = {weight, &other};
            });
            cell.filtered = sum / weights;
            const float most = kMostDifference * relativeTo(cell.filtered);
            for (size_t i = 0; i < count; ++i) {
                const auto& [weight, other] = weighted[i];
                cell.noise += square(weight / weights) * std::min(square(other->difference), most) * other->samples;
            }
        }
    });
    std::vector<Estimate> estimates(cells.size());
    parallelFor(0, height, 1, [&](int row, int) {
        for (int column = 0; column < width; ++column) {
            const size_t i = size_t(row) * size_t(width) + size_t(column);
            const Cell& cell = cells[i];
            if (!cell.valid) continue;
            float sum = 0, count = 0;
            around(row, column, 1, [&](const Cell& other) {
                sum += other.filtered;
                ++count;
            });
            const float mean = sum / count;
            estimates[i].noise = double(cell.noise / relativeTo(mean));
            estimates[i].contrast = double(square(cell.filtered - mean) / relativeTo(mean));
        }
    });
    return estimates;
}

// Sets the densities in proportion to `errors` (one per block, in arbitrary units), within the bounds and with a mean
// of 1.
void SampleDensity::decide(const std::vector<double>& errors) {
    std::vector<double> pixels;
    double sum = 0;
    for (size_t i = 0; i < errors.size(); ++i) {
        const int column = int(i) % columns(), row = int(i) / columns();
        pixels.push_back(double(std::min(kBlock, region_.width() - column * kBlock)) *
                         double(std::min(kBlock, region_.height() - row * kBlock)));
        sum += errors[i] * pixels[i];
    }
    if (!(sum > 0)) return;
    // Sets the densities for a scale and returns their mean over all pixels; bisection finds the scale with mean 1.
    const auto meanAt = [&](double scale) {
        double bounded = 0;
        for (size_t i = 0; i < errors.size(); ++i) {
            densities_[i] = std::clamp(scale * errors[i], kLeast, kMost);
            bounded += densities_[i] * pixels[i];
        }
        return bounded / double(region_.count());
    };
    double low = 0, high = double(region_.count()) / sum;
    constexpr int kSteps = 60;
    for (int i = 0; i < kSteps && meanAt(high) < 1; ++i) low = high, high *= 2;
    for (int i = 0; i < kSteps; ++i) {
        const double middle = 0.5 * (low + high);
        (meanAt(middle) < 1 ? low : high) = middle;
    }
    meanAt(high);
}

void SampleDensity::save(StateWriter& to) const {
    const auto used = [](const Sums& sums) { return sums.count() > 0; };
    // Between passes, rows_ contains no samples.
    for (const std::vector<Sums>* list : {&cells_, &rows_}) {
        to.value(uint64_t(std::ranges::count_if(*list, used)));
        for (size_t i = 0; i < list->size(); ++i) {
            const Sums& sums = (*list)[i];
            if (!used(sums)) continue;
            to.value(uint64_t(i));
            to.values(std::span(sums.value));
            to.values(std::span(sums.samples));
            for (int c = 0; c < 3; ++c) to.value(sums.albedo[c]);
            for (int c = 0; c < 3; ++c) to.value(sums.normal[c]);
        }
    }
    to.values(std::span(densities_));
    to.value(int32_t(nextUpdate_));
}

void SampleDensity::load(StateReader& from) {
    for (std::vector<Sums>* list : {&cells_, &rows_}) {
        std::ranges::fill(*list, Sums{});
        for (auto left = from.value<uint64_t>(); left > 0; --left) {
            const auto i = from.value<uint64_t>();
            if (i >= list->size()) from.fail("there cannot be so many cells of pixels");
            Sums& sums = (*list)[i];
            from.values(std::span(sums.value));
            from.values(std::span(sums.samples));
            for (int c = 0; c < 3; ++c) sums.albedo[c] = from.value<float>();
            for (int c = 0; c < 3; ++c) sums.normal[c] = from.value<float>();
        }
    }
    from.values(std::span(densities_));
    for (const double density : densities_)
        if (!(density >= kLeast && density <= kMost)) from.fail("there cannot be such a density of samples");
    nextUpdate_ = from.value<int32_t>();
}

}  // namespace drc
