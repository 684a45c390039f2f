// Tabulated distributions to sample from: piecewise constant over [0,1) and [0,1)^2, and discrete (PBR 3e, section
// 13.3.1 and 13.6.7).
//
// Each function below that samples returns the density or probability with which it did so, and pdf() agrees with it
// exactly: both are read off the same cumulative table. A table of zeros is sampled uniformly. Negative and non-finite
// values count as zero.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace drc {

struct Sample1D {
    float x = 0;  // in [0,1)
    float pdf = 0;
    int index = 0;    // of the table's cell that x lies in
    float local = 0;  // x within that cell, in [0,1), with all the precision that u left
};

struct DiscreteSample {
    int index = 0;
    float probability = 0;
    float uRemapped = 0;  // uniform in [0,1) given index: what is left of the random number
};

struct Sample2D {
    int x = 0, y = 0;  // the table's cell that was chosen
    Vec2 local;        // in [0,1)^2, uniform within that cell
    float pdf = 0;     // over [0,1)^2
};

class Distribution1D {
  public:
    Distribution1D() : Distribution1D(std::span<const float>()) {}
    // An empty table is one cell.
    explicit Distribution1D(std::span<const float> f);

    int size() const { return static_cast<int>(cdf_.size()) - 1; }
    // Integral over [0,1) of the tabulated function: the mean of its values.
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
    // For each of size() equal parts of [0,1): the cell that its lower end falls in, where a search can start
    // (Chen and Asau, "On Generating Random Variates from an Empirical Distribution", 1974).
    std::vector<int> guide_;
};

class Distribution2D {
  public:
    Distribution2D() : Distribution2D({}, 0, 0) {}
    // f: row-major, width x height; x runs along a row. An empty table is one cell.
    Distribution2D(std::span<const float> f, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    double integral() const { return integral_; }
    Sample2D sample(const Vec2& u) const;
    // The u that is sampled as this point of this cell.
    Vec2 inverse(int x, int y, const Vec2& local) const;
    float pdf(int x, int y) const { return mass(marginal(), y) * mass(row(y), x) * float(width_ * height_); }

  private:
    // A table of n cells has n + 1 of them. Cumulative table and guide in one, because a sample costs the cache lines
    // that it touches.
    struct Entry {
        float cdf;  // in whole 2^-24, as random numbers are: a cell is chosen exactly as often as its density says
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
    std::vector<Entry> entries_;  // the rows, and after them the table of rows
};

}  // namespace drc
