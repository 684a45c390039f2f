// Transfer functions and colour spaces. RGB is linear with Rec. 709 primaries unless it is called sRGB-encoded.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "math/vec.h"

namespace drc {

// IEC 61966-2-1, exact, and odd about zero, so that negative values (differences, negative filter lobes) are kept.
inline float srgbEncode(float linear) {
    const float a = std::abs(linear);
    const float e = a <= 0.0031308f ? 12.92f * a : 1.055f * std::pow(a, 1 / 2.4f) - 0.055f;
    return std::copysign(e, linear);
}
inline float srgbDecode(float encoded) {
    const float a = std::abs(encoded);
    const float l = a <= 0.04045f ? a / 12.92f : std::pow((a + 0.055f) / 1.055f, 2.4f);
    return std::copysign(l, encoded);
}
inline Rgb srgbEncode(const Rgb& c) { return Rgb(srgbEncode(c.x), srgbEncode(c.y), srgbEncode(c.z)); }
inline Rgb srgbDecode(const Rgb& c) { return Rgb(srgbDecode(c.x), srgbDecode(c.y), srgbDecode(c.z)); }

// Maps [0, 1] to 0..255, rounded to nearest; values outside are clamped, and NaN becomes 0.
inline uint8_t toByte(float x) {
    return x >= 1 ? uint8_t(255) : x > 0 ? static_cast<uint8_t>(x * 255 + 0.5f) : uint8_t(0);
}
// Clamped to [0, 1]; NaN becomes 0.
inline float clamp01(float x) { return x >= 1 ? 1.f : x > 0 ? x : 0.f; }
inline Rgb clamp01(const Rgb& c) { return Rgb(clamp01(c.x), clamp01(c.y), clamp01(c.z)); }

// CIE 1931 XYZ for Rec. 709 primaries with the white point D65, Y = 1 for white. The coefficients are the exact
// rational numbers that follow from the sRGB standard's chromaticities, not the standard's four rounded digits, so that
// white maps to kWhiteXyz exactly.
inline Vec3 rgbToXyz(const Rgb& c) {
    return Vec3(10135552.f / 24577794.f * c.x + 8788810.f / 24577794.f * c.y + 4435075.f / 24577794.f * c.z,
                2613072.f / 12288897.f * c.x + 8788810.f / 12288897.f * c.y + 887015.f / 12288897.f * c.z,
                1425312.f / 73733382.f * c.x + 8788810.f / 73733382.f * c.y + 70074185.f / 73733382.f * c.z);
}
inline Rgb xyzToRgb(const Vec3& v) {
    return Rgb(3.241003275f * v.x - 1.537398934f * v.y - 0.498615861f * v.z,
               -0.969224334f * v.x + 1.875930071f * v.y + 0.041554224f * v.z,
               0.055639423f * v.x - 0.204011202f * v.y + 1.057148933f * v.z);
}
inline const Vec3 kWhiteXyz = rgbToXyz(Rgb(1, 1, 1));

// CIE 1976 L*a*b* relative to D65: L in [0, 100].
inline Vec3 xyzToLab(const Vec3& v) {
    const auto f = [](float t) {
        constexpr float kDelta = 6 / 29.f;
        return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4 / 29.f;
    };
    const float x = f(v.x / kWhiteXyz.x), y = f(v.y / kWhiteXyz.y), z = f(v.z / kWhiteXyz.z);
    return Vec3(116 * y - 16, 500 * (x - y), 200 * (y - z));
}
inline Vec3 rgbToLab(const Rgb& c) { return xyzToLab(rgbToXyz(c)); }

}  // namespace drc
