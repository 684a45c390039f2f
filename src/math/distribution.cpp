#include "math/distribution.h"

namespace drc {
namespace {

double usable(float f) { return f > 0 && std::isfinite(f) ? static_cast<double>(f) : 0.0; }

float belowOne(double x) { return std::min(static_cast<float>(x), kOneMinusEpsilon); }

}  // namespace

Distribution1D::Distribution1D(std::span<const float> f) {
    const size_t n = std::max<size_t>(1, f.size());
    cdf_.resize(n + 1, 0.0);
    for (size_t i = 0; i < f.size(); ++i) cdf_[i + 1] = cdf_[i] + usable(f[i]);
    const double total = cdf_.back();
    integral_ = total / static_cast<double>(n);
    for (size_t i = 1; i <= n; ++i)
        cdf_[i] = total > 0 ? cdf_[i] / total : static_cast<double>(i) / static_cast<double>(n);
    guide_.resize(n);
    for (size_t k = 0, i = 0; k < n; ++k) {
        while (cdf_[i + 1] <= static_cast<double>(k) / static_cast<double>(n)) ++i;
        guide_[k] = static_cast<int>(i);
    }
}

int Distribution1D::find(float u) const {
    // The cell whose upper end is the first beyond u has a positive width, so that empty cells are never chosen.
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
    // Rounding to float may leave the cell; the next one can have another density, even zero.
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
    if (width <= 0 || height <= 0) width = height = 0;
    std::vector<float> integrals;
    rows_.reserve(std::max(1, height));
    for (int y = 0; y < height; ++y) {
        rows_.emplace_back(f.subspan(static_cast<size_t>(y) * width, width));
        integrals.push_back(static_cast<float>(rows_.back().integral()));
    }
    if (rows_.empty()) rows_.emplace_back();
    marginal_ = Distribution1D(integrals);
}

Sample2D Distribution2D::sample(const Vec2& u) const {
    const Sample1D y = marginal_.sampleContinuous(u.y);
    const Sample1D x = rows_[y.index].sampleContinuous(u.x);
    return {Vec2(x.x, y.x), x.pdf * y.pdf, x.index, y.index, Vec2(x.local, y.local)};
}

float Distribution2D::pdf(const Vec2& p) const {
    const int y = std::clamp(static_cast<int>(p.y * height()), 0, height() - 1);
    return rows_[y].pdf(p.x) * marginal_.pdf(p.y);
}

}  // namespace drc
