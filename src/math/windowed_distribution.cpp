#include "math/windowed_distribution.h"

#include <algorithm>
#include <cmath>

namespace drc {
namespace {

// Inverts a cumulative function: returns the x in [low, high] at which upTo(x) is a fraction u of the way from
// upTo(low) to upTo(high). upTo: linear within cells, whose edges are whole numbers. atLow, atHigh: upTo(low) and
// upTo(high).
template <typename UpTo>
double inverted(const UpTo& upTo, double low, double high, double atLow, double atHigh, float u) {
    const double wanted = atLow + double(u) * (atHigh - atLow);
    // Finds the edges of the cell that contains x: first by linear interpolation, since most functions are nearly
    // constant over a window, then by bisection.
    double from = low, to = high, before = atLow, after = atHigh;
    int first = int(std::floor(low)), last = std::max(first + 1, int(std::ceil(high)));
    bool guess = true;
    while (last - first > 1) {
        const double share = after > before ? (wanted - before) / (after - before) : 0.5;
        const int middle =
            guess ? std::clamp(int(from + (to - from) * share), first + 1, last - 1) : (first + last) / 2;
        const double there = upTo(double(middle));
        const bool isAfter = there > wanted;
        // Interpolation ends when it has discarded no more than a quarter of the range.
        guess = guess && (isAfter ? last - middle : middle - first) > (last - first) / 4;
        (isAfter ? last : first) = middle;
        (isAfter ? to : from) = middle;
        (isAfter ? after : before) = there;
    }
    const double t = after > before ? (wanted - before) / (after - before) : 0.5;
    return from + (to - from) * std::clamp(t, 0.0, 1.0);
}

int cellAt(double x, int cells) { return std::clamp(int(x), 0, cells - 1); }

}  // namespace

WindowedDistribution2D::WindowedDistribution2D(std::span<const float> f, int width, int height)
    : width_(width), height_(height), sums_((size_t(width) + 1) * (size_t(height) + 1)) {
    if (width <= 0 || height <= 0) {
        width_ = height_ = 1;
        sums_.assign(4, 0);
        columns_.assign(2, 0);
        return;
    }
    const size_t stride = size_t(width) + 1;
    columns_.resize(size_t(width) * (size_t(height) + 1));
    for (size_t y = 0; y < size_t(height); ++y) {
        double row = 0;
        for (size_t x = 0; x < size_t(width); ++x) {
            const float given = f[y * size_t(width) + x];
            const double value = given > 0 && std::isfinite(given) ? double(given) : 0;
            row += value;
            double* column = &columns_[x * (size_t(height) + 1)];
            column[y + 1] = column[y] + value;
            sums_[(y + 1) * stride + x + 1] = sums_[y * stride + x + 1] + row;
        }
    }
}

double WindowedDistribution2D::before(double x, double y) const {
    const int i = cellAt(x, width_), j = cellAt(y, height_);
    const double dx = x - i, dy = y - j;
    const double* low = &sums_[size_t(j) * (size_t(width_) + 1) + size_t(i)];
    const double* high = low + width_ + 1;
    return (1 - dy) * ((1 - dx) * low[0] + dx * low[1]) + dy * ((1 - dx) * high[0] + dx * high[1]);
}

double WindowedDistribution2D::inColumn(int column, double y) const {
    const int j = cellAt(y, height_);
    const double* sums = columnAt(column) + j;
    return sums[0] + (y - j) * (sums[1] - sums[0]);
}

WindowedDistribution2D::Cells WindowedDistribution2D::cellsOf(const Window& window) const {
    const auto inside = [](float x) { return double(std::clamp(x, 0.f, 1.f)); };
    return {inside(window.low.x) * width_, inside(window.high.x) * width_, inside(window.low.y) * height_,
            inside(window.high.y) * height_};
}

double WindowedDistribution2D::integral(const Window& window) const {
    return std::max(0.0, integral(cellsOf(window))) / (double(width_) * height_);
}

std::optional<WindowedDistribution2D::Sample> WindowedDistribution2D::sample(const Vec2& u,
                                                                             const Window& window) const {
    const Cells cells = cellsOf(window);
    const auto upToX = [&](double x) { return before(x, cells.y1) - before(x, cells.y0); };
    const double left = upToX(cells.x0), right = upToX(cells.x1), total = right - left;
    if (!(total > 0)) return {};
    const double x = inverted(upToX, cells.x0, cells.x1, left, right, u.x);
    // Within the column of cells that holds x, the density does not depend on x.
    const int column = cellAt(x, width_);
    const auto upToY = [&](double y) { return inColumn(column, y); };
    const double y = inverted(upToY, cells.y0, cells.y1, upToY(cells.y0), upToY(cells.y1), u.y);
    const double here = value(column, cellAt(y, height_));
    if (!(here > 0)) return {};
    return Sample{Vec2(float(x / width_), float(y / height_)), float(here / total * width_ * height_)};
}

float WindowedDistribution2D::pdf(const Vec2& at, const Window& window) const {
    if (!window.contains(at)) return 0;
    const double total = integral(cellsOf(window));
    if (!(total > 0)) return 0;
    const double here = value(cellAt(double(at.x) * width_, width_), cellAt(double(at.y) * height_, height_));
    return std::max(0.f, float(here / total * width_ * height_));
}

Vec2 WindowedDistribution2D::inverse(const Vec2& at, const Window& window) const {
    const Cells cells = cellsOf(window);
    const double x = std::clamp(double(at.x) * width_, cells.x0, cells.x1);
    const double y = std::clamp(double(at.y) * height_, cells.y0, cells.y1);
    const int column = cellAt(x, width_);
    const auto share = [](double part, double whole) {
        return whole > 0 ? std::clamp(float(part / whole), 0.f, kOneMinusEpsilon) : 0;
    };
    const double low = inColumn(column, cells.y0);
    return Vec2(share(integral(Cells{cells.x0, x, cells.y0, cells.y1}), integral(cells)),
                share(inColumn(column, y) - low, inColumn(column, cells.y1) - low));
}

}  // namespace drc
