// The roughness of lobes that are tables and have no roughness of their own.
#pragma once
#include "scene/lobes/lobe.h"

namespace drc {

// The alpha that LobeMask asks for, of a lobe seen at the given cosine. largest: the largest density of its scattered
// light per solid angle. diffuse: the share of the light that is scattered diffusely, pi times the smallest ratio of
// that density to the cosine.
//
// What matters for maps and caches is how much of the light comes from how small a solid angle: they blur that, and
// nothing else. A Trowbridge-Reitz lobe has the largest density 1 / (4 pi alpha^2 cos theta); this is its alpha, with
// the density of the diffuse part, which no blur changes, left out. So a diffuse base under a faint gloss is broad, and
// under a sharp one it is glossy although little light is in it: its reflections would be seen to be missing.
inline float equivalentAlpha(float cosTheta, float largest, float diffuse) {
    const float excess = 4 * (kPi * largest * cosTheta - diffuse);
    return excess > 0 ? 1 / std::sqrt(excess) : kDiffuseAlpha;
}

// Steeper views are left out: every surface is shiny there.
inline constexpr float kLeastCosineOfAlpha = 0.5f;

}  // namespace drc
