#include "neural/transforms.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace drc {
namespace {

constexpr float kScale = 10.f;   // the mean maps to ln(1 + 1/kScale)
constexpr float kOffset = 0.1f;  // which this brings near 0
// exp of more than this says only that the network went astray; it must not become infinity.
constexpr float kMaxEncoded = 30.f;

float radianceOrZero(float value) { return std::isfinite(value) && value > 0 ? value : 0.f; }

// 1/(10 m), or 0 for a mean so small that its inverse overflows: the map then counts as black.
float inverseScale(float mean) {
    return mean > std::numeric_limits<float>::min() * kScale && std::isfinite(mean) ? 1 / (kScale * mean) : 0.f;
}

// A texel can exceed the mean by at most the number of texels, but a foreign mean (a target scaled by its input's)
// can be arbitrarily smaller.
float logScale(float value, float inverse) {
    return std::log(1 + std::min(value * inverse, std::numeric_limits<float>::max()));
}

}  // namespace

float meanRadiance(const float* radiance, size_t count) {
    double sum = 0;
    for (size_t i = 0; i < count; ++i) sum += radianceOrZero(radiance[i]);
    return count ? float(sum / double(count)) : 0.f;
}

float encodeInput(const float* radiance, const float* normal, const float* distance, size_t texels, float* planes) {
    const float mean = meanRadiance(radiance, 3 * texels);
    const float inverse = inverseScale(mean);
    for (size_t i = 0; i < 3 * texels; ++i) planes[i] = logScale(radianceOrZero(radiance[i]), inverse) - kOffset;

    float* normals = planes + 3 * texels;
    for (size_t i = 0; i < 3 * texels; ++i)
        normals[i] = std::isfinite(normal[i]) ? std::clamp(normal[i], -1.f, 1.f) : 0.f;

    float* distances = planes + 6 * texels;
    // In units of the mean distance of what was hit: a scene in centimetres is the same scene in metres.
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
    throw Error("an ablation is one of none, normals, distance and both, not '" + name + "'");
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
        const float y = encoded[i] > 0 ? std::min(encoded[i], kMaxEncoded) : 0.f;  // also takes NaN to 0
        radiance[i] = std::min(std::expm1(y) * scale, std::numeric_limits<float>::max());
    }
}

}  // namespace drc
