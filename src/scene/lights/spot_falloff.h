// How the light of a spot fades towards the edge of its cone.
#pragma once
#include <cmath>

#include "math/vec.h"

namespace drc {

// If x in [0, 1] is the position of the cosine between the edge and full intensity, the falloff is x^4 (Steep: PBR 3e,
// section 12.3.1) or 3 x^2 - 2 x^3 (Smooth: PBR 4e, section 12.2.1).
enum class SpotEdge { Steep, Smooth };

struct SpotFalloff {
    SpotFalloff(float coneDegrees, float fadeDegrees, SpotEdge shape = SpotEdge::Steep)
        : edge(shape),
          cosEdge(std::cos(coneDegrees * kPi / 180)),
          cosFull(std::cos(std::max(0.f, coneDegrees - fadeDegrees) * kPi / 180)),
          cone(coneDegrees * kPi / 180) {}

    float at(float cosTheta) const {
        if (cosTheta <= cosEdge) return 0;
        if (cosTheta >= cosFull) return 1;
        const float x = (cosTheta - cosEdge) / (cosFull - cosEdge);
        return edge == SpotEdge::Steep ? sqr(sqr(x)) : sqr(x) * (3 - 2 * x);
    }
    // Integral of the falloff over all directions. x is linear in the cosine, so the soft edge contributes its solid
    // angle times the integral of the falloff over x: 1/5 (Steep) or 1/2 (Smooth).
    float solidAngle() const {
        const float share = edge == SpotEdge::Steep ? 0.2f : 0.5f;
        return 2 * kPi * ((1 - cosFull) + (cosFull - cosEdge) * share);
    }

    SpotEdge edge;
    float cosEdge, cosFull;
    float cone;  // radians from the axis to the edge
};

}  // namespace drc
