// A tabulated function of the cosine between a direction and the normal, such as the albedo or the transmittance of a
// layer. Curves of stacked layers are multiplied node by node, and the mean of a curve over the hemisphere is exact, so
// that the layers together conserve energy to rounding.
#pragma once
#include <array>
#include <cstddef>

#include "math/vec.h"

namespace drc {

class CosineCurve {
  public:
    // Nodes are evenly spaced in the square root of the cosine, because layers change fastest near the horizon.
    static constexpr int kNodes = 32;
    static constexpr float cosineOf(int node) {
        const float t = float(node) / (kNodes - 1);
        return t * t;
    }

    constexpr explicit CosineCurve(float everywhere = 1) { values_.fill(everywhere); }
    constexpr float& operator[](int node) { return values_[size_t(node)]; }
    constexpr float operator[](int node) const { return values_[size_t(node)]; }

    // The value at |cosTheta|. Between the nodes the curve is linear in sqrt(|cosTheta|).
    float at(float cosTheta) const {
        const float x = std::sqrt(std::min(1.f, std::abs(cosTheta))) * (kNodes - 1);
        const size_t i = std::min(size_t(x), size_t(kNodes - 2));
        return lerp(x - float(i), values_[i], values_[i + 1]);
    }
    // The cosine-weighted mean over the hemisphere: the integral of 2 c at(c) over c in [0, 1].
    float mean() const;

  private:
    std::array<float, kNodes> values_;
};

}  // namespace drc
