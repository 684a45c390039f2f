#include "math/distribution.h"

namespace drc {
namespace {

double usable(float f) { return f > 0 && std::isfinite(f) ? static_cast<double>(f) : 0.0; }

float belowOne(double x) { return std::min(static_cast<float>(x), kOneMinusEpsilon); }

// Sets `integral` to the integral of f over [0,1) and returns its normalised cumulative table: 0, ..., 1.
std::vector<double> cumulative(std::span<const float> f, double& integral) {
    const size_t n = std::max<size_t>(1, f.size());
    std::vector<double> cdf(n + 1, 0.0);
    for (size_t i = 0; i < f.size(); ++i) cdf[i + 1] = cdf[i] + usable(f[i]);
    const double total = cdf.back();
    integral = total / static_cast<double>(n);
    for (size_t i = 1; i <= n; ++i)
        cdf[i] = total > 0 ? cdf[i] / total : static_cast<double>(i) / static_cast<double>(n);
    return cdf;
}

}  // namespace

Distribution1D::Distribution1D(std::span<const float> f) : cdf_(cumulative(f, integral_)) {
    const auto n = static_cast<size_t>(size());
    guide_.resize(n);
    for (size_t k = 0, i = 0; k < n; ++k) {
        while (cdf_[i + 1] <= static_cast<double>(k) / static_cast<double>(n)) ++i;
        guide_[k] = static_cast<int>(i);
    }
}

int Distribution1D::find(float u) const {
    // The first cell whose upper bound exceeds u has positive width, so that cells of zero weight are never chosen.
    const double x = std::clamp(u, 0.f, kOneMinusEpsilon);
    int i = guide_[static_cast<size_t>(x * size())];
    while (cdf_[i + 1] <= x) ++i;
    return i;
}

Sample1D Distribution1D::sampleContinuous(float u) const {
    const DiscreteSample s = sampleDiscrete(u);
    Sample1D r;
    r.index = s.index;
    r.local = s.uRemapped;
    r.pdf = static_cast<float>(mass(s.index) * size());
    r.x = belowOne((s.index + static_cast<double>(s.uRemapped)) / size());
    // Rounding to float may move x into the next cell, whose density may differ or even be zero.
    while (r.x > 0 && cell(r.x) > s.index) r.x = std::nextafter(r.x, 0.f);
    while (cell(r.x) < s.index) r.x = std::nextafter(r.x, 1.f);
    return r;
}

DiscreteSample Distribution1D::sampleDiscrete(float u) const {
    DiscreteSample s;
    s.index = find(u);
    const double m = mass(s.index);
    s.probability = static_cast<float>(m);
    s.uRemapped = belowOne(std::max(0.0, (static_cast<double>(u) - cdf_[s.index]) / m));
    return s;
}

Distribution2D::Distribution2D(std::span<const float> f, int width, int height) {
    static constexpr float kNothing[] = {0};
    if (width <= 0 || height <= 0) {
        width = height = 1;
        f = kNothing;
    }
    width_ = width;
    height_ = height;
    const auto n = static_cast<size_t>(width);
    entries_.reserve((n + 2) * static_cast<size_t>(height) + 1);
    std::vector<float> means;
    for (int y = 0; y < height; ++y) means.push_back(float(append(f.subspan(static_cast<size_t>(y) * n, n))));
    integral_ = append(means);
}

double Distribution2D::append(std::span<const float> f) {
    double mean = 0;
    const size_t first = entries_.size();
    for (const double c : cumulative(f, mean))
        entries_.push_back({static_cast<float>(std::round(c * 0x1p24) * 0x1p-24), 0});
    Entry* const table = entries_.data() + first;
    const int cells = static_cast<int>(f.size());
    for (int k = 0, i = 0; k < cells; ++k) {
        while (table[i + 1].cdf <= static_cast<float>(k) / static_cast<float>(cells)) ++i;
        table[k].guide = i;
    }
    return mean;
}

Distribution2D::Chosen Distribution2D::choose(const Entry* table, int cells, float u) {
    const float x = std::clamp(u, 0.f, kOneMinusEpsilon);
    int i = table[std::min(static_cast<int>(x * static_cast<float>(cells)), cells - 1)].guide;
    // Because of rounding, the guide's entry may lie just above x.
    while (i > 0 && table[i].cdf > x) --i;
    while (table[i + 1].cdf <= x) ++i;
    const float m = mass(table, i);
    return {i, m, std::min((x - table[i].cdf) / m, kOneMinusEpsilon)};
}

Sample2D Distribution2D::sample(const Vec2& u) const {
    const Chosen y = choose(marginal(), height_, u.y);
    const Chosen x = choose(row(y.cell), width_, u.x);
    return {x.cell, y.cell, Vec2(x.local, y.local), y.mass * x.mass * float(width_ * height_)};
}

Vec2 Distribution2D::inverse(int x, int y, const Vec2& local) const {
    return Vec2(row(y)[x].cdf + local.x * mass(row(y), x), marginal()[y].cdf + local.y * mass(marginal(), y));
}

}  // namespace drc
