// Tabulated distributions: piecewise constant over [0,1) and over [0,1)^2, and discrete (PBR 3e, sections 13.3.1
// and 13.6.7).
//
// Sampling returns the density or probability of the sample, and pdf() agrees with it exactly, since both are computed
// from the same cumulative table. A table of zeros is sampled uniformly. Negative and non-finite values count as zero.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace drc {

struct Sample1D {
    float x = 0;  // in [0,1)
    float pdf = 0;
    int index = 0;    // of the table's cell that contains x
    float local = 0;  // position within that cell, in [0,1), at the full precision that u leaves
};

struct DiscreteSample {
    int index = 0;
    float probability = 0;
    float uRemapped = 0;  // the unused part of the random number: uniform in [0,1) given index
};

struct Sample2D {
    int x = 0, y = 0;  // the chosen cell of the table
    Vec2 local;        // position within that cell, uniform in [0,1)^2
    float pdf = 0;     // with respect to area on [0,1)^2
};

class Distribution1D {
  public:
    Distribution1D() : Distribution1D(std::span<const float>()) {}
    // f: the value of each cell. An empty table counts as a single cell.
    explicit Distribution1D(std::span<const float> f);

    int size() const { return static_cast<int>(cdf_.size()) - 1; }
    // Integral over [0,1) of the tabulated function, which is the mean of its values.
    double integral() const { return integral_; }
    Sample1D sampleContinuous(float u) const;
    DiscreteSample sampleDiscrete(float u) const;
    float pdf(float x) const { return static_cast<float>(mass(cell(x)) * size()); }
    float probability(int index) const { return static_cast<float>(mass(index)); }

  private:
    double mass(int i) const { return cdf_[i + 1] - cdf_[i]; }
    int cell(float x) const { return std::clamp(static_cast<int>(x * size()), 0, size() - 1); }
    int find(float u) const;

    double integral_ = 0;
    std::vector<double> cdf_;  // size() + 1 values, from 0 to 1
    // guide_[i] is the cell that contains i / size(), where the search for u in [i, i+1) / size() starts (Chen and
    // Asau, "On Generating Random Variates from an Empirical Distribution", 1974).
    std::vector<int> guide_;
};

class Distribution2D {
  public:
    Distribution2D() : Distribution2D({}, 0, 0) {}
    // f: row-major, width x height; x runs along a row. An empty table counts as a single cell.
    Distribution2D(std::span<const float> f, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    double integral() const { return integral_; }
    Sample2D sample(const Vec2& u) const;
    // The u that sample() maps to the position `local` in cell (x, y).
    Vec2 inverse(int x, int y, const Vec2& local) const;
    float pdf(int x, int y) const { return mass(marginal(), y) * mass(row(y), x) * float(width_ * height_); }

  private:
    // A table of n cells has n + 1 entries. The cumulative table and the guide are interleaved, because the cost of a
    // sample is the number of cache lines that it touches.
    struct Entry {
        float cdf;  // a multiple of 2^-24, as random numbers are, so that each cell is chosen exactly as often as its
                    // pdf says
        int guide;
    };
    struct Chosen {
        int cell;
        float mass, local;
    };
    // Appends a table; returns the mean of f.
    double append(std::span<const float> f);
    static Chosen choose(const Entry* table, int cells, float u);
    static float mass(const Entry* table, int cell) { return table[cell + 1].cdf - table[cell].cdf; }
    const Entry* row(int y) const { return &entries_[size_t(y) * size_t(width_ + 1)]; }
    const Entry* marginal() const { return row(height_); }

    int width_ = 1, height_ = 1;
    double integral_ = 0;
    std::vector<Entry> entries_;  // the conditional tables of all rows, followed by the marginal table over rows
};

}  // namespace drc
