#include "scene/filter.h"

#include <functional>
#include <vector>

#include "math/distribution.h"

namespace drc {
namespace {

class BoxFilter final : public Filter {
  public:
    explicit BoxFilter(const Vec2& radius) : radius_(radius) {}
    Vec2 radius() const override { return radius_; }
    float eval(const Vec2& p) const override {
        return std::abs(p.x) <= radius_.x && std::abs(p.y) <= radius_.y ? 1.f : 0.f;
    }
    FilterSample sample(const Vec2& u) const override {
        return {Vec2((2 * u.x - 1) * radius_.x, (2 * u.y - 1) * radius_.y), 1};
    }

  private:
    Vec2 radius_;
};

class TriangleFilter final : public Filter {
  public:
    explicit TriangleFilter(const Vec2& radius) : radius_(radius) {}
    Vec2 radius() const override { return radius_; }
    float eval(const Vec2& p) const override {
        return std::max(0.f, radius_.x - std::abs(p.x)) * std::max(0.f, radius_.y - std::abs(p.y));
    }
    FilterSample sample(const Vec2& u) const override {
        return {Vec2(tent(u.x) * radius_.x, tent(u.y) * radius_.y), 1};
    }

  private:
    // Inverse of the cumulative distribution of the tent 1 - |x| on [-1,1].
    static float tent(float u) { return u < 0.5f ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 * (1 - u)); }

    Vec2 radius_;
};

// One axis of a separable filter, tabulated. The cells are small enough for f / pdf to be nearly the sign of f.
class Axis {
  public:
    Axis(float radius, std::function<float(float)> f) : radius_(radius), f_(std::move(f)) {
        constexpr int kCells = 512, kPointsPerCell = 8;
        std::vector<float> magnitude(kCells);
        double sum = 0;
        for (int i = 0; i < kCells; ++i) {
            double cell = 0;
            for (int k = 0; k < kPointsPerCell; ++k) {
                const double x = (i + (k + 0.5) / kPointsPerCell) / kCells;
                const double value = f_(static_cast<float>((2 * x - 1) * radius));
                sum += value;
                cell += std::abs(value);
            }
            // The mean of |f| over the cell, so that a cell in which f changes its sign is not missed.
            magnitude[i] = static_cast<float>(cell);
        }
        table_ = Distribution1D(magnitude);
        mean_ = static_cast<float>(sum / (kCells * kPointsPerCell));
    }

    float eval(float x) const { return std::abs(x) <= radius_ ? f_(x) : 0.f; }
    // Offset, and the weight f / pdf divided by the mean of f, so that the mean of the weight is 1.
    std::pair<float, float> sample(float u) const {
        const Sample1D s = table_.sampleContinuous(u);
        const float x = (2 * s.x - 1) * radius_;
        return {x, mean_ != 0 ? f_(x) / (s.pdf * mean_) : 1.f};
    }
    float radius() const { return radius_; }

  private:
    float radius_;
    std::function<float(float)> f_;
    Distribution1D table_;  // |f| over [-radius, radius]
    float mean_ = 1;        // mean of f over the same interval
};

// f(x, y) = fx(x) fy(y), as for all of these filters.
class SeparableFilter final : public Filter {
  public:
    SeparableFilter(Axis x, Axis y) : x_(std::move(x)), y_(std::move(y)) {}
    Vec2 radius() const override { return Vec2(x_.radius(), y_.radius()); }
    float eval(const Vec2& p) const override { return x_.eval(p.x) * y_.eval(p.y); }
    FilterSample sample(const Vec2& u) const override {
        const auto [x, weightX] = x_.sample(u.x);
        const auto [y, weightY] = y_.sample(u.y);
        return {Vec2(x, y), weightX * weightY};
    }

  private:
    Axis x_, y_;
};

// A Gaussian, shifted down to reach zero at the radius (PBR 3e, section 7.8.1).
Axis gaussianAxis(float radius, float alpha) {
    const float edge = std::exp(-alpha * radius * radius);
    return Axis(radius, [=](float x) { return std::max(0.f, std::exp(-alpha * x * x) - edge); });
}

// The Mitchell-Netravali filter, scaled so that its support of two units on each side becomes the radius.
Axis mitchellAxis(float radius, float b, float c) {
    return Axis(radius, [=](float offset) {
        const float x = std::abs(2 * offset / radius);
        if (x >= 2) return 0.f;
        if (x > 1) return ((((-b - 6 * c) * x + (6 * b + 30 * c)) * x + (-12 * b - 48 * c)) * x + (8 * b + 24 * c)) / 6;
        return (((12 - 9 * b - 6 * c) * x + (-18 + 12 * b + 6 * c)) * x * x + (6 - 2 * b)) / 6;
    });
}

float sinc(float x) {
    x = std::abs(x);
    return x < 1e-5f ? 1.f : std::sin(kPi * x) / (kPi * x);
}

// A sinc, windowed by the main lobe of another sinc that is tau times as wide (Lanczos).
Axis sincAxis(float radius, float tau) {
    return Axis(radius, [=](float x) { return sinc(x) * sinc(x / tau); });
}

}  // namespace

FilterPtr makeBoxFilter(const Vec2& radius) { return std::make_shared<BoxFilter>(radius); }

FilterPtr makeTriangleFilter(const Vec2& radius) { return std::make_shared<TriangleFilter>(radius); }

FilterPtr makeGaussianFilter(const Vec2& radius, float alpha) {
    return std::make_shared<SeparableFilter>(gaussianAxis(radius.x, alpha), gaussianAxis(radius.y, alpha));
}

FilterPtr makeMitchellFilter(const Vec2& radius, float b, float c) {
    return std::make_shared<SeparableFilter>(mitchellAxis(radius.x, b, c), mitchellAxis(radius.y, b, c));
}

FilterPtr makeSincFilter(const Vec2& radius, float tau) {
    return std::make_shared<SeparableFilter>(sincAxis(radius.x, tau), sincAxis(radius.y, tau));
}

}  // namespace drc
