// A function of the cosine between a direction and the normal, as a table: what a layer of a material reflects or lets
// pass. Tables of layers multiply node by node, and their mean over the hemisphere is exact, so that sums of layers
// conserve energy to rounding.
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

    // cosTheta: its sign is ignored; between the nodes the curve is linear in the square root of its magnitude.
    float at(float cosTheta) const {
        const float x = std::sqrt(std::min(1.f, std::abs(cosTheta))) * (kNodes - 1);
        const size_t i = std::min(size_t(x), size_t(kNodes - 2));
        return lerp(x - float(i), values_[i], values_[i + 1]);
    }
    // The mean over the hemisphere, weighted by the cosine.
    float mean() const;

  private:
    std::array<float, kNodes> values_;
};

}  // namespace drc
