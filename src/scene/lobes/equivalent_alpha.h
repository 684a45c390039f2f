// The roughness of lobes that are tables and have no roughness of their own.
#pragma once
#include "scene/lobes/lobe.h"

namespace drc {

// The alpha that LobeMask asks for, of a lobe seen at the given cosine. largest: the largest density of its scattered
// light per solid angle. diffuse: the share of the light that is scattered diffusely, pi times the smallest ratio of
// that density to the cosine.
//
// Maps and caches blur directions: all that matters to them is how much of the light comes from how small a solid
// angle. A Trowbridge-Reitz lobe has the largest density 1 / (4 pi alpha^2 cos theta). The function solves this for
// alpha, leaving out the density of the diffuse part, which no blur changes. A diffuse base under a faint gloss then
// counts as broad. Under a sharp gloss it counts as glossy, although the gloss carries little light: one would see that
// its reflections are missing.
inline float equivalentAlpha(float cosTheta, float largest, float diffuse) {
    const float excess = 4 * (kPi * largest * cosTheta - diffuse);
    return excess > 0 ? 1 / std::sqrt(excess) : kDiffuseAlpha;
}

// Steeper views are left out: every surface is shiny there.
inline constexpr float kLeastCosineOfAlpha = 0.5f;

}  // namespace drc
