// Geometry of unit vectors in the shading frame, where the normal is +z (PBR 3e, section 8.0 and 8.2.2).
#pragma once
#include "math/vec.h"

namespace drc {

inline float absCosTheta(const Vec3& w) { return std::abs(w.z); }
inline bool sameHemisphere(const Vec3& a, const Vec3& b) { return a.z * b.z > 0; }

// Mirror image of w about the unit vector n; both point away from the surface.
inline Vec3 reflect(const Vec3& w, const Vec3& n) { return n * (2 * dot(w, n)) - w; }

// Refraction by Snell's law. w and n point away from the surface, to the same side; eta is the index of refraction on
// that side divided by the index on the other side. False for total internal reflection.
inline bool refract(const Vec3& w, const Vec3& n, float eta, Vec3& refracted) {
    const float cosI = dot(w, n);
    const float sin2T = eta * eta * std::max(0.f, 1 - cosI * cosI);
    if (sin2T >= 1) return false;
    refracted = n * (eta * cosI - std::sqrt(1 - sin2T)) - w * eta;
    return true;
}

}  // namespace drc
