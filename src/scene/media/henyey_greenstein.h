// The phase function of Henyey and Greenstein, "Diffuse radiation in the galaxy", 1941: how scattering in a medium
// distributes light over directions (PBR 3e, section 11.3.1). It has the density per solid angle that it is sampled
// with.
#pragma once
#include "math/vec.h"

namespace drc {

// g: the mean cosine of the deflection, in (-1, 1). wo: unit, from where the light goes on, as in a BSDF. wi: unit,
// towards where it comes from.
float phaseHenyeyGreenstein(float g, const Vec3& wo, const Vec3& wi);
// A direction wi, with density phaseHenyeyGreenstein(). u: in the unit square.
Vec3 sampleHenyeyGreenstein(float g, const Vec3& wo, const Vec2& u);

}  // namespace drc
