// Vectors and colours: Imath's types under the names that the renderer uses.
#pragma once
#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace drc {

using Vec2 = Imath::V2f;
using Vec3 = Imath::V3f;
// Linear RGB with Rec. 709 primaries. The context says whether it is reflectance, radiance or irradiance.
using Rgb = Imath::Color3<float>;

inline constexpr float kPi = std::numbers::pi_v<float>;
inline constexpr float kInvPi = std::numbers::inv_pi_v<float>;
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
// Largest float below one, to clamp random numbers to [0, 1).
inline constexpr float kOneMinusEpsilon = 0x1.fffffep-1f;

inline float dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline float absDot(const Vec3& a, const Vec3& b) { return std::abs(dot(a, b)); }
inline Vec3 cross(const Vec3& a, const Vec3& b) { return a.cross(b); }
inline float lengthSquared(const Vec3& v) { return dot(v, v); }
inline float length(const Vec3& v) { return std::sqrt(dot(v, v)); }
// Normalises v; a zero vector stays zero.
inline Vec3 normalize(const Vec3& v) {
    const float l = length(v);
    return l > 0 ? v * (1 / l) : v;
}
// v or -v, whichever lies in the hemisphere around n.
inline Vec3 faceForward(const Vec3& v, const Vec3& n) { return dot(v, n) < 0 ? -v : v; }

inline float sqr(float x) { return x * x; }
inline float lerp(float t, float a, float b) { return a + t * (b - a); }
inline Rgb lerp(float t, const Rgb& a, const Rgb& b) { return a + (b - a) * t; }
inline float safeSqrt(float x) { return std::sqrt(std::max(0.f, x)); }

// Luminance of linear Rec. 709 RGB.
inline float luminance(const Rgb& c) { return 0.212671f * c.x + 0.715160f * c.y + 0.072169f * c.z; }
inline bool isBlack(const Rgb& c) { return c.x == 0 && c.y == 0 && c.z == 0; }
inline float maxComponent(const Rgb& c) { return std::max({c.x, c.y, c.z}); }
inline float average(const Rgb& c) { return (c.x + c.y + c.z) * (1 / 3.f); }
inline bool isFinite(const Rgb& c) { return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z); }
inline Rgb clampNonNegative(const Rgb& c) { return Rgb(std::max(0.f, c.x), std::max(0.f, c.y), std::max(0.f, c.z)); }
inline Rgb exp(const Rgb& c) { return Rgb(std::exp(c.x), std::exp(c.y), std::exp(c.z)); }
inline Rgb sqrt(const Rgb& c) { return Rgb(safeSqrt(c.x), safeSqrt(c.y), safeSqrt(c.z)); }

}  // namespace drc
