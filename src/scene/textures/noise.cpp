#include "scene/textures/noise.h"

#include <array>
#include <cstdint>

namespace drc {
namespace {

// The permutation that Perlin published with his improved noise (SIGGRAPH 2002).
constexpr std::array<uint8_t, 256> kPermutation = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103, 30,  69,  142,
    8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,  197, 62,  94,  252, 219, 203,
    117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174, 20,  125, 136, 171, 168, 68,  175, 74,  165,
    71,  134, 139, 48,  27,  166, 77,  146, 158, 231, 83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,
    55,  46,  245, 40,  244, 102, 143, 54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,
    18,  169, 200, 196, 135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250,
    124, 123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,  182, 189,
    28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101, 155, 167, 43,  172, 9,
    129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185, 112, 104, 218, 246, 97,  228, 251, 34,
    242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,  51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,
    181, 199, 106, 157, 184, 84,  204, 176, 115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114,
    67,  29,  24,  72,  243, 141, 128, 195, 78,  66,  215, 61,  156, 180};

constexpr float kLacunarity = 1.99f;  // not 2, so that the lattice points, where an octave is 0, do not coincide
constexpr float kMeanOfAbsolute = 0.2f;

uint32_t permuted(uint32_t i) { return kPermutation[i & 255]; }

// Dot product of the offset (x, y, z) from a lattice point with the point's gradient, which is one of twelve (some have
// two of the sixteen hashes).
float slope(uint32_t hash, float x, float y, float z) {
    const uint32_t h = hash & 15;
    const bool inXy = h == 12 || h == 13;
    const float u = h < 8 || inXy ? x : y;
    const float v = h < 4 || inXy ? y : z;
    return ((h & 1) != 0 ? -u : u) + ((h & 2) != 0 ? -v : v);
}

// The first and second derivatives are zero at both ends.
float fade(float t) { return t * t * t * (t * (6 * t - 15) + 10); }

float smoothStep(float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.f, 1.f);
    return t * t * (3 - 2 * t);
}

// Number of octaves that the footprint resolves, a real number in [0, octaves].
float resolvedOctaves(const Vec3& dpdx, const Vec3& dpdy, int octaves) {
    const float squaredWidth = std::max(lengthSquared(dpdx), lengthSquared(dpdy));
    return std::clamp(-1 - 0.5f * std::log2(squaredWidth), 0.f, float(std::max(octaves, 0)));
}

// Weight of the octave that is being faded out, given the fractional part of resolvedOctaves().
float fadedIn(float fraction) { return smoothStep(0.3f, 0.7f, fraction); }

}  // namespace

float noise(const Vec3& p) {
    constexpr float kNoFraction = 8388608;  // 2^23
    if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < kNoFraction)) return 0;
    const Vec3 floor(std::floor(p.x), std::floor(p.y), std::floor(p.z));
    const Vec3 d = p - floor;
    const auto ix = static_cast<uint32_t>(static_cast<int>(floor.x));
    const auto iy = static_cast<uint32_t>(static_cast<int>(floor.y));
    const auto iz = static_cast<uint32_t>(static_cast<int>(floor.z));
    const float wx = fade(d.x), wy = fade(d.y), wz = fade(d.z);
    const uint32_t columns[2][2] = {{permuted(permuted(ix) + iy), permuted(permuted(ix) + iy + 1)},
                                    {permuted(permuted(ix + 1) + iy), permuted(permuted(ix + 1) + iy + 1)}};
    const auto layer = [&](uint32_t k) {
        const float z = d.z - float(k);
        const auto at = [&](int i, int j) {
            return slope(permuted(columns[i][j] + iz + k), d.x - float(i), d.y - float(j), z);
        };
        return lerp(wy, lerp(wx, at(0, 0), at(1, 0)), lerp(wx, at(0, 1), at(1, 1)));
    };
    return lerp(wz, layer(0), layer(1));
}

float fbm(const Vec3& p, const Vec3& dpdx, const Vec3& dpdy, const NoiseSum& sum) {
    const float resolved = resolvedOctaves(dpdx, dpdy, sum.octaves);
    const int whole = static_cast<int>(resolved);
    float result = 0, frequency = 1, amplitude = 1;
    for (int i = 0; i < whole; ++i) {
        result += amplitude * noise(p * frequency);
        frequency *= kLacunarity;
        amplitude *= sum.roughness;
    }
    if (const float part = fadedIn(resolved - float(whole)); part > 0)
        result += amplitude * part * noise(p * frequency);
    return result;
}

float turbulence(const Vec3& p, const Vec3& dpdx, const Vec3& dpdy, const NoiseSum& sum) {
    const float resolved = resolvedOctaves(dpdx, dpdy, sum.octaves);
    const int whole = static_cast<int>(resolved);
    float result = 0, frequency = 1, amplitude = 1;
    for (int i = 0; i < sum.octaves; ++i) {
        const float part = i < whole ? 1 : i == whole ? fadedIn(resolved - float(whole)) : 0;
        const float value = part > 0 ? lerp(part, kMeanOfAbsolute, std::abs(noise(p * frequency))) : kMeanOfAbsolute;
        result += amplitude * value;
        frequency *= kLacunarity;
        amplitude *= sum.roughness;
    }
    // Adds the mean of the first octave that is left out, as in pbrt.
    return result + amplitude * kMeanOfAbsolute;
}

}  // namespace drc
