// Tables over the unit square that are interpolated bilinearly, with the outer entries on the square's edges, and warps
// of the square whose density is such a table. Both form families over two parameters, with linear interpolation
// between the members (Dupuy and Jakob, "An Adaptive Parameterization for Efficient Material Acquisition and
// Rendering", 2018).
#pragma once
#include <array>
#include <span>
#include <vector>

#include "math/vec.h"

namespace drc {

// The four members of a family around a pair of parameters, and their interpolation weights, which sum to one.
struct FamilyWeights {
    std::array<int, 4> member{0, 0, 0, 0};
    std::array<float, 4> weight{1, 0, 0, 0};
};
// The parameters of a family's members: member i * second.size() + j has the parameters first[i], second[j].
class FamilyGrid {
  public:
    // Values of the two parameters, each in ascending order, with at least one value.
    FamilyGrid(std::vector<float> first, std::vector<float> second)
        : first_(std::move(first)), second_(std::move(second)) {}
    int size() const { return int(first_.size() * second_.size()); }
    const std::vector<float>& first() const { return first_; }
    const std::vector<float>& second() const { return second_; }
    // a and b are clamped to the ranges of the parameters.
    FamilyWeights at(float a, float b) const;

  private:
    std::vector<float> first_, second_;
};

// The size of a table over the square, and positions in it.
struct SquareGrid {
    int width = 2, height = 2;  // at least 2
    int size() const { return width * height; }
    struct Place {
        int x, y;      // of the cell's first corner
        float fx, fy;  // within the cell
    };
    Place at(const Vec2& p) const;
};

// Values of any type over the square: one row-major table after another, for each member of the family.
template <typename T>
class SquareTable {
  public:
    SquareTable(const SquareGrid& grid, std::vector<T> values) : grid_(grid), values_(std::move(values)) {}
    T eval(const Vec2& p, const FamilyWeights& family = {}) const {
        const SquareGrid::Place at = grid_.at(p);
        T sum(0.f);
        for (size_t k = 0; k < 4; ++k) {
            if (family.weight[k] == 0) continue;
            const T* v = &values_[size_t(family.member[k]) * size_t(grid_.size()) + size_t(at.y * grid_.width + at.x)];
            const T first = v[0] * (1 - at.fx) + v[1] * at.fx;
            const T second = v[grid_.width] * (1 - at.fx) + v[grid_.width + 1] * at.fx;
            sum += (first * (1 - at.fy) + second * at.fy) * family.weight[k];
        }
        return sum;
    }

  private:
    SquareGrid grid_;
    std::vector<T> values_;
};

// Maps the square to itself so that uniformly distributed points have the density of a table afterwards: y from the
// marginal distribution, then x given y.
class SquareWarp {
  public:
    // values: as for SquareTable, not negative. A member that is zero everywhere counts as constant.
    SquareWarp(const SquareGrid& grid, std::vector<float> values, int members);
    // Memory in bytes of a warp with this number of values.
    static double bytes(double values) { return 2.5 * values * sizeof(float); }

    struct Warped {
        Vec2 p;
        float pdf;  // of the table's point, per unit area of the square
    };
    Warped sample(const Vec2& u, const FamilyWeights& family) const;
    // The u that sample() maps to p, with the pdf of p.
    Warped invert(const Vec2& p, const FamilyWeights& family) const;

  private:
    class View;

    SquareGrid grid_;
    std::vector<float> values_;       // densities; the integral of each member over cells of side 1 is one
    std::vector<float> conditional_;  // integral over each row up to each entry
    std::vector<float> marginal_;     // integral over the rows up to each row
};

}  // namespace drc
