// The phase function of Henyey and Greenstein, "Diffuse radiation in the galaxy", 1941: the distribution of scattered
// light over directions in a medium (PBR 3e, section 11.3.1). Its value equals the pdf, per solid angle, with which
// sampleHenyeyGreenstein() samples it.
#pragma once
#include "math/vec.h"

namespace drc {

// g: mean cosine of the scattering angle, in (-1, 1). wo, wi: unit and pointing away from the point, as in a BSDF: wo
// in the direction in which the light leaves, wi towards its source.
float phaseHenyeyGreenstein(float g, const Vec3& wo, const Vec3& wi);
// A direction wi with the pdf phaseHenyeyGreenstein(). u: in the unit square.
Vec3 sampleHenyeyGreenstein(float g, const Vec3& wo, const Vec2& u);

}  // namespace drc
