#include "scene/filter.h"

#include <functional>
#include <vector>

#include "math/distribution.h"
#include "math/sampler.h"

namespace drc {
namespace {

class BoxFilter final : public Filter {
  public:
    explicit BoxFilter(const Vec2& radius) : radius_(radius) {}
    Vec2 radius() const override { return radius_; }
    float eval(const Vec2& p) const override {
        return std::abs(p.x) <= radius_.x && std::abs(p.y) <= radius_.y ? 1.f : 0.f;
    }
    FilterSample sample(const Vec2& u, uint32_t, uint64_t) const override {
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
    FilterSample sample(const Vec2& u, uint32_t, uint64_t) const override {
        return {Vec2(tent(u.x) * radius_.x, tent(u.y) * radius_.y), 1};
    }

  private:
    // Inverse of the cumulative distribution of the tent 1 - |x| on [-1,1].
    static float tent(float u) { return u < 0.5f ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 * (1 - u)); }

    Vec2 radius_;
};

// One axis of a separable filter. Its positive and its negative part are tabulated separately.
class Axis {
  public:
    Axis(float radius, std::function<float(float)> f) : radius_(radius), f_(std::move(f)) {
        constexpr int kCells = 512, kPointsPerCell = 8;
        std::vector<float> values[2] = {std::vector<float>(kCells), std::vector<float>(kCells)};
        for (int i = 0; i < kCells; ++i)
            for (int k = 0; k < kPointsPerCell; ++k) {
                const double x = (i + (k + 0.5) / kPointsPerCell) / kCells;
                const float value = f_(float((2 * x - 1) * double(radius)));
                values[value < 0][size_t(i)] += std::abs(value);
            }
        for (const int part : {0, 1}) parts_[part] = Distribution1D(values[part]);
        const double all = parts_[0].integral() + parts_[1].integral();
        negative_ = all > 0 ? parts_[1].integral() / all : 0;
    }

    float eval(float x) const { return std::abs(x) <= radius_ ? f_(x) : 0.f; }
    // The share of the integral of |f| that comes from where f is negative, or from where it is positive.
    double share(bool negative) const { return negative ? negative_ : 1 - negative_; }
    float sample(float u, bool negative) const { return (2 * parts_[negative].sampleContinuous(u).x - 1) * radius_; }
    float radius() const { return radius_; }

  private:
    float radius_;
    std::function<float(float)> f_;
    Distribution1D parts_[2];  // |f| over [-radius, radius]: [0] where f is positive, [1] where it is negative
    double negative_ = 0;
};

// f(x, y) = fx(x) fy(y): the Gaussian, Mitchell and sinc filters.
class SeparableFilter final : public Filter {
  public:
    SeparableFilter(Axis x, Axis y) : x_(std::move(x)), y_(std::move(y)) {
        const double negative = x_.share(false) * y_.share(true) + x_.share(true) * y_.share(false);
        // A filter whose integral is negative is sampled as -f, so that the mean weight is still 1.
        opposite_ = negative > 0.5;
        minority_ = opposite_ ? 1 - negative : negative;
        weight_ = minority_ < 0.5 ? float(1 / (1 - 2 * minority_)) : 1;
    }
    Vec2 radius() const override { return Vec2(x_.radius(), y_.radius()); }
    float eval(const Vec2& p) const override { return x_.eval(p.x) * y_.eval(p.y); }
    FilterSample sample(const Vec2& u, uint32_t index, uint64_t pixel) const override {
        // phase puts the first two samples of each group into the majority. Among the first K samples of a group, the
        // majority then has at least (K - 2) (1 - 2 minority_) samples more than the minority.
        const double phase = double(hashCombine(pixel, 0)) * 0x1p-64 * (1 - 2 * minority_);
        const auto inMinority = [&](uint32_t number) { return uint64_t(double(number) * minority_ + phase); };
        const uint32_t number = index / kGroups;
        const bool minority = minority_ > 0 && inMinority(number + 1) > inMinority(number);
        // A product is negative where one of its factors is, and positive where both or none are.
        const bool negative = minority != opposite_;
        const double first = x_.share(false) * y_.share(negative), second = x_.share(true) * y_.share(!negative);
        const double bound = second > 0 ? first / (first + second) : 1;
        const bool isFirst = double(u.x) < bound;
        const double rest = isFirst ? double(u.x) / bound : (double(u.x) - bound) / (1 - bound);
        const float x = x_.sample(std::min(float(rest), kBelowOne), !isFirst);
        return {Vec2(x, y_.sample(u.y, isFirst == negative)), minority ? -weight_ : weight_};
    }

  private:
    static constexpr float kBelowOne = 0x1.fffffep-1f;

    Axis x_, y_;
    bool opposite_ = false;
    double minority_ = 0;  // share of the integral of |f| where the sign of f differs from that of its integral
    float weight_ = 1;
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
