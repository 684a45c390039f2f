// A tabulated density over the unit square, restricted to any rectangle in it (PBR 4e, section A.5.6; Bitterli, Novak
// and Jarosz, "Portal-Masked Environment Map Sampling", 2015). A summed-area table gives the integral over a rectangle
// in constant time, and a sample in time logarithmic in the table's sides.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "math/vec.h"

namespace drc {

// A rectangle in the unit square.
struct Window {
    Vec2 low{0.f}, high{1.f};
    bool contains(const Vec2& at) const { return at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y; }
};

class WindowedDistribution2D {
  public:
    // f: the function in each cell, row-major; x runs along a row. Negative and non-finite values count as zero.
    WindowedDistribution2D(std::span<const float> f, int width, int height);
    WindowedDistribution2D() : WindowedDistribution2D({}, 0, 0) {}

    struct Sample {
        Vec2 at;
        float pdf = 0;  // per area of the unit square
    };
    // Empty if the function is zero in the window.
    std::optional<Sample> sample(const Vec2& u, const Window& window) const;
    float pdf(const Vec2& at, const Window& window) const;
    // The u that sample() maps to a point of the window.
    Vec2 inverse(const Vec2& at, const Window& window) const;
    // Integral of the function over the window.
    double integral(const Window& window) const;

  private:
    // A rectangle in units of cells.
    struct Cells {
        double x0, x1, y0, y1;
    };
    Cells cellsOf(const Window& window) const;
    double value(int x, int y) const {
        const double* column = columnAt(x);
        return column[y + 1] - column[y];
    }
    // Integral over a rectangle, where a cell has the area 1.
    double integral(const Cells& cells) const {
        return before(cells.x1, cells.y1) - before(cells.x0, cells.y1) - before(cells.x1, cells.y0) +
               before(cells.x0, cells.y0);
    }
    // Integral over all points with smaller x and y: sums_, interpolated bilinearly between the corners of cells.
    double before(double x, double y) const;
    // Integral over one column of cells, from its start up to y.
    double inColumn(int column, double y) const;
    const double* columnAt(int x) const { return &columns_[size_t(x) * (size_t(height_) + 1)]; }

    int width_, height_;
    std::vector<double> sums_;  // at the corners of cells, (width + 1) in a row
    // Prefix sums of each column alone, (height + 1) values: a search along it touches few cache lines.
    std::vector<double> columns_;
};

}  // namespace drc
