// Mappings from the unit square to disks, hemispheres, spheres, cones and triangles, with their densities (PBR 3e,
// sections 13.5 and 13.6), and the equal-area mapping between square and hemisphere that radiance maps use.
//
// Directions are unit vectors around +z. Square coordinates lie in [0,1]^2. Densities are per solid angle.
#pragma once
#include <cmath>

#include "math/vec.h"

namespace drc {

struct SinCos {
    float sin, cos;
};

// Sine and cosine of (pi / 4) x for x in [-1, 1], within 1e-7. These are Chebyshev fits, since a call to the math
// library would cost more than the rest of the mapping.
inline SinCos sinCosInOctants(float x) {
    const float z = x * x;
    const float s = x * (0.785398161f + z * (-0.0807454348f + z * (0.00249000696f + z * -3.59543993e-05f)));
    const float c = 1 + z * (-0.308425135f + z * (0.0158543252f + z * (-0.0003259386f + z * 3.52980423e-06f)));
    return {s, c};
}

// Sine and cosine of 2 pi x for x in [0, 1].
inline SinCos sinCosOfTurn(float x) {
    const int quarter = static_cast<int>(4 * x + 0.5f);
    const SinCos r = sinCosInOctants(2 * (4 * x - static_cast<float>(quarter)));
    const bool swap = quarter & 1;
    const float s = swap ? r.cos : r.sin, c = swap ? r.sin : r.cos;
    return {quarter & 2 ? -s : s, (quarter + 1) & 2 ? -c : c};
}

// Concentric mapping, area-preserving up to a constant factor: concentric squares become concentric circles (Shirley
// and Chiu 1997; PBR 13.6.2). Both wedges are computed by the same expressions, so that the symmetries of the square
// hold bit for bit on the disk, and without a branch, which would often be mispredicted.
inline Vec2 squareToDisk(const Vec2& u) {
    const float a = 2 * u.x - 1, b = 2 * u.y - 1;
    const bool wide = std::abs(a) > std::abs(b);
    const float r = wide ? a : b, other = wide ? b : a;
    const SinCos phi = sinCosInOctants(r == 0 ? 0 : other / r);
    const float along = r * phi.cos, across = r * phi.sin;
    return wide ? Vec2(along, across) : Vec2(across, along);
}

// (4 / pi) atan(x) for x in [-1, 1], within 3e-7. A Chebyshev fit of the even function atan(x) / x, which takes a third
// of the time of std::atan.
inline float atanInOctants(float x) {
    const float z = x * x;
    float p = -0.0059444668f;
    for (const float c :
         {0.0307693481f, -0.0755885404f, 0.126128343f, -0.178464704f, 0.254256202f, -0.424395692f, 1.27323941f})
        p = p * z + c;
    return p * x;
}

// The point of the square at distance r from the centre in the maximum norm (1 at the edge), in the direction of (x,
// y). Shared by the inverse mappings below.
inline Vec2 radiusAndDirectionToSquare(float r, float x, float y) {
    if (r == 0 || (x == 0 && y == 0)) return Vec2(0.5f, 0.5f);
    float a, b;
    if (std::abs(x) > std::abs(y)) {
        a = std::copysign(r, x);
        b = a * atanInOctants(y / x);
    } else {
        b = std::copysign(r, y);
        a = b * atanInOctants(x / y);
    }
    return Vec2(std::clamp(0.5f * (a + 1), 0.f, 1.f), std::clamp(0.5f * (b + 1), 0.f, 1.f));
}

// Inverse of squareToDisk. Points outside the disk are clamped to the square's edge.
inline Vec2 diskToSquare(const Vec2& p) {
    return radiusAndDirectionToSquare(std::min(1.f, std::sqrt(p.x * p.x + p.y * p.y)), p.x, p.y);
}

// Equal-area mapping to the hemisphere z >= 0: the concentric mapping to the disk, lifted by z = 1 - r^2. A region of
// area A in the square covers the solid angle 2 pi A. u increases with x and v with y, and each of the eight symmetries
// of the square becomes the corresponding symmetry of the hemisphere.
inline Vec3 squareToHemisphere(const Vec2& uv) {
    const Vec2 d = squareToDisk(uv);
    // r is known exactly on the square, which keeps z accurate near the horizon.
    const float r = std::max(std::abs(2 * uv.x - 1), std::abs(2 * uv.y - 1));
    const float lift = safeSqrt(2 - r * r);
    return Vec3(d.x * lift, d.y * lift, (1 - r) * (1 + r));
}

// Inverse of squareToHemisphere; w must be unit. Directions below the horizon are clamped to the square's edge.
inline Vec2 hemisphereToSquare(const Vec3& w) {
    // Equals sqrt(1 - z), without its cancellation near the pole.
    const float r = std::sqrt((w.x * w.x + w.y * w.y) / (1 + std::max(0.f, w.z)));
    return radiusAndDirectionToSquare(w.z <= 0 ? 1.f : std::min(1.f, r), w.x, w.y);
}

// Uniform on the unit disk.
inline Vec2 sampleConcentricDisk(const Vec2& u) { return squareToDisk(u); }

// Direction with a pdf proportional to cos theta (Malley's method, PBR 13.6.3), within a cone around +z. sine: of the
// cone's half-angle; 1: the hemisphere.
inline Vec3 sampleCosineCone(const Vec2& u, float sine) {
    const Vec2 d = squareToDisk(u);
    // z = sqrt(1 - |d|^2), with |d| taken from the square as in squareToHemisphere, so that it stays accurate near the
    // horizon.
    const float r = std::max(std::abs(2 * u.x - 1), std::abs(2 * u.y - 1)) * sine;
    return Vec3(d.x * sine, d.y * sine, safeSqrt((1 - r) * (1 + r)));
}
inline Vec3 sampleCosineHemisphere(const Vec2& u) { return sampleCosineCone(u, 1); }
inline float cosineHemispherePdf(float cosTheta) { return std::max(0.f, cosTheta) * kInvPi; }

inline Vec3 sampleUniformHemisphere(const Vec2& u) {
    const float z = u.x, r = safeSqrt(1 - z * z);
    const SinCos phi = sinCosOfTurn(u.y);
    return Vec3(r * phi.cos, r * phi.sin, z);
}
inline constexpr float uniformHemispherePdf() { return 0.5f * kInvPi; }

inline Vec3 sampleUniformSphere(const Vec2& u) {
    // sin theta = sqrt(1 - z^2) = 2 sqrt(u (1 - u)), which does not cancel at the poles.
    const float z = 1 - 2 * u.x, r = 2 * safeSqrt(u.x * (1 - u.x));
    const SinCos phi = sinCosOfTurn(u.y);
    return Vec3(r * phi.cos, r * phi.sin, z);
}
inline constexpr float uniformSpherePdf() { return 0.25f * kInvPi; }

// Uniform over the cone of directions with z >= cosThetaMax.
inline Vec3 sampleUniformCone(const Vec2& u, float cosThetaMax) {
    const float h = u.x * (1 - cosThetaMax);  // 1 - cos theta
    const float r = safeSqrt(h * (2 - h)), phi = 2 * kPi * u.y;
    return Vec3(r * std::cos(phi), r * std::sin(phi), 1 - h);
}
inline float uniformConePdf(float cosThetaMax) { return 1 / (2 * kPi * (1 - cosThetaMax)); }

// Barycentric coordinates (b0, b1) of a point uniformly distributed on a triangle; b2 = 1 - b0 - b1 (PBR 13.6.5).
inline Vec2 sampleUniformTriangle(const Vec2& u) {
    const float s = std::sqrt(u.x);
    return Vec2(1 - s, u.y * s);
}

}  // namespace drc
