#include "neural/transforms.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace drc {
namespace {

constexpr float kScale = 10.f;   // radiance equal to the mean is encoded as ln(1 + 1/kScale) - kOffset,
constexpr float kOffset = 0.1f;  // which is about 0

float radianceOrZero(float value) { return std::isfinite(value) && value > 0 ? value : 0.f; }

constexpr float kAlbedoOffset = 0.05f;
float unitOrZero(float value) { return value > 0 ? std::min(value, 1.f) : 0.f; }  // also maps NaN to 0
float offAlbedo(float albedo) { return unitOrZero(albedo) + kAlbedoOffset; }

// 1/(10 m), or 0 if m is so small that the inverse would overflow; such a map counts as black.
float inverseScale(float mean) {
    return mean > std::numeric_limits<float>::min() * kScale && std::isfinite(mean) ? 1 / (kScale * mean) : 0.f;
}

// Clamped because the ratio may overflow: a texel exceeds the mean of its own map at most by the number of texels, but
// a target is scaled by the mean of its input map, which may be arbitrarily smaller.
float logScale(float value, float inverse) {
    return std::log(1 + std::min(value * inverse, std::numeric_limits<float>::max()));
}

void encodeLight(float* values, size_t count, float inverse) {
    for (size_t i = 0; i < count; ++i) values[i] = logScale(radianceOrZero(values[i]), inverse) - kOffset;
}

}  // namespace

float meanRadiance(const float* radiance, size_t count) {
    double sum = 0;
    for (size_t i = 0; i < count; ++i) sum += radianceOrZero(radiance[i]);
    return count ? float(sum / double(count)) : 0.f;
}

void divideByAlbedo(const float* radiance, const float* albedo, size_t count, float* result) {
    for (size_t i = 0; i < count; ++i) result[i] = radiance[i] / offAlbedo(albedo[i]);
}

void multiplyByAlbedo(const float* radiance, const float* albedo, size_t count, float* result) {
    for (size_t i = 0; i < count; ++i)
        result[i] = std::min(radiance[i] * offAlbedo(albedo[i]), std::numeric_limits<float>::max());
}

float encodeInput(const MapView& map, float* planes) {
    const size_t texels = map.texels;
    const float *normal = map.normal, *distance = map.distance;
    if (map.albedo)
        divideByAlbedo(map.radiance, map.albedo, 3 * texels, planes);
    else
        std::copy_n(map.radiance, 3 * texels, planes);
    const float mean = meanRadiance(planes, 3 * texels);
    const float inverse = inverseScale(mean);
    encodeLight(planes, 3 * texels, inverse);
    if (map.albedo) {
        float *albedos = planes + kPlainPlanes * texels, *direct = albedos + 3 * texels;
        for (size_t i = 0; i < 3 * texels; ++i) albedos[i] = unitOrZero(map.albedo[i]);
        divideByAlbedo(map.direct, map.albedo, 3 * texels, direct);
        encodeLight(direct, 3 * texels, inverse);
    }

    float* normals = planes + 3 * texels;
    for (size_t i = 0; i < 3 * texels; ++i)
        normals[i] = std::isfinite(normal[i]) ? std::clamp(normal[i], -1.f, 1.f) : 0.f;

    float* distances = planes + 6 * texels;
    // Distances are divided by the mean distance of the hits, so that the scene's units do not matter.
    double hitSum = 0;
    size_t hits = 0;
    for (size_t i = 0; i < texels; ++i)
        if (std::isfinite(distance[i]) && distance[i] > 0) hitSum += distance[i], ++hits;
    const float unit = hits > 0 ? float(hitSum / double(hits)) : 1.f;
    const auto shifted = [unit](float z) { return std::isfinite(z) && z >= 0 ? z / unit + 1 : 0.f; };
    double sum = 0;
    for (size_t i = 0; i < texels; ++i) sum += shifted(distance[i]);
    const float inverseDistance = inverseScale(texels ? float(sum / double(texels)) : 0.f);
    for (size_t i = 0; i < texels; ++i) distances[i] = logScale(shifted(distance[i]), inverseDistance) - kOffset;
    return mean;
}

Ablation parseAblation(const std::string& name) {
    for (const Ablation a : {Ablation::None, Ablation::Normals, Ablation::Distance, Ablation::Both})
        if (name == ablationName(a)) return a;
    throw Error("the ablation must be none, normals, distance or both, not '" + name + "'");
}

std::string ablationName(Ablation ablation) {
    constexpr const char* kNames[] = {"none", "normals", "distance", "both"};
    return kNames[size_t(ablation)];
}

void ablate(Ablation ablation, size_t texels, float* planes) {
    if (ablation == Ablation::Normals || ablation == Ablation::Both) std::fill_n(planes + 3 * texels, 3 * texels, 0.f);
    if (ablation == Ablation::Distance || ablation == Ablation::Both) std::fill_n(planes + 6 * texels, texels, 0.f);
}

void encodeTarget(const float* radiance, size_t count, float mean, float* encoded) {
    const float inverse = inverseScale(mean);
    for (size_t i = 0; i < count; ++i) encoded[i] = logScale(radianceOrZero(radiance[i]), inverse);
}

void decodeOutput(const float* encoded, size_t count, float mean, float* radiance) {
    const float scale = kScale * radianceOrZero(mean);
    for (size_t i = 0; i < count; ++i) {
        const float y = encoded[i] > 0 ? std::min(encoded[i], kMaxEncoded) : 0.f;  // also maps NaN to 0
        radiance[i] = std::min(std::expm1(y) * scale, std::numeric_limits<float>::max());
    }
}

}  // namespace drc
