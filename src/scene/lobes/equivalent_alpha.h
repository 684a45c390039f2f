// An equivalent roughness for tabulated lobes, which have none of their own.
#pragma once
#include "scene/lobes/lobe.h"

namespace drc {

// The alpha, as used by LobeMask, of a lobe viewed at the given cosine. largest: maximum over wi of the density of its
// scattered light per solid angle, which integrates to one. diffuse: share of the light that is scattered diffusely, pi
// times the smallest ratio of the density to |cos theta_i|.
//
// Radiance maps and caches blur directions, so what matters to them is only how much of the light comes from how small
// a solid angle. The largest density of a Trowbridge-Reitz lobe is 1 / (4 pi alpha^2 cos theta). The function solves
// this for alpha, leaving out the density of the diffuse part, which no blur changes. A diffuse base under a faint
// gloss then counts as broad. Under a sharp gloss it counts as glossy even if the gloss carries little light, because
// its missing reflections would be visible.
inline float equivalentAlpha(float cosTheta, float largest, float diffuse) {
    const float excess = 4 * (kPi * largest * cosTheta - diffuse);
    return excess > 0 ? 1 / std::sqrt(excess) : kDiffuseAlpha;
}

// Views at smaller cosines do not count for a lobe's alpha: every surface is shiny at grazing angles.
inline constexpr float kLeastCosineOfAlpha = 0.5f;

}  // namespace drc
