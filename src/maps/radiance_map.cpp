#include "maps/radiance_map.h"

#include "math/morton.h"

namespace drc {
namespace {

// Shares of the sampling density that ignore luminance: a texel that is black in the map may be lit for another point
// that gathers from it. The first share is proportional to the cosine; the second is uniform, for pixels whose normal
// differs from the map's.
constexpr float kCosineShare = 0.1f, kUniformShare = 0.1f;
// Size of the guide table, which stores where to start searching the cumulative density (Chen and Asau, "On Generating
// Random Variates from an Empirical Distribution", 1974).
constexpr size_t kGuide = 256;
// Distances with a smaller relative difference count as one surface.
constexpr float kSameSurface = 0.25f;
// Offset from the map's origin, as a share of the harmonic mean distance, below which ray marching is not worth its
// cost.
constexpr float kNegligibleOffset = 0.01f;
// The march covers distances from 0.5 to 64 times the offset. At 64 times, parallax is less than a fifth of a texel.
constexpr int kMarchSteps = 8;

}  // namespace

RadianceMap::RadianceMap(const CapturedMap& captured, const MapLayout& layout)
    : layout_(layout), origin_(captured.origin), frame_(captured.frame) {
    const int n = layout.size();
    const auto texels = size_t(layout.texels());
    radiance_.resize(3 * texels);
    distance_.resize(texels);
    cdf_.resize(texels);

    float maxRadiance = 0, maxDistance = 0;
    for (const float r : captured.radiance) maxRadiance = std::max(maxRadiance, r);
    for (const float d : captured.distance) maxDistance = std::max(maxDistance, d);
    // Half floats have full precision from 2^-14 to 2^15. With the brightest texel at 2^14, most of that range is left
    // for dark texels.
    scale_ = maxRadiance > 0 ? maxRadiance / 16384.f : 1.f;
    distanceScale_ = maxDistance > 0 ? maxDistance / 1024.f : 1.f;

    double irradiance = 0, cosineSum = 0, inverseDistance = 0, weight = 0;
    std::vector<float> cosines(texels);
    for (int row = 0; row < n; ++row) {
        const double solidAngle = layout.solidAngle(row);
        for (int column = 0; column < n; ++column) {
            const auto i = size_t(row * n + column);
            Rgb value;
            for (size_t c = 0; c < 3; ++c) {
                value[int(c)] = captured.radiance[c * texels + i];
                radiance_[3 * i + c] = half(value[int(c)] / scale_);
            }
            const float d = captured.distance[i];
            distance_[i] = half(d < 0 ? -1.f : d / distanceScale_);
            cosines[i] = layout.direction(column, row, Vec2(0.5f, 0.5f)).z;
            irradiance += luminance(value) * cosines[i] * solidAngle;
            cosineSum += cosines[i] * solidAngle;
            weight += solidAngle;
            if (d > 0) inverseDistance += solidAngle / d;
        }
    }
    harmonicMeanDistance_ = inverseDistance > 0 ? float(weight / inverseDistance) : kInfinity;

    // Mean over the texel of the bilinearly interpolated luminance: a dark texel beside a bright one is partly bright.
    const auto luminanceOf = [&](int row, int column) { return luminance(texel(row * n + column)); };
    const auto meanLuminance = [&](int row, int column) {
        const auto line = [&](int r) {
            return luminanceOf(r, std::max(column - 1, 0)) + 6 * luminanceOf(r, column) +
                   luminanceOf(r, std::min(column + 1, n - 1));
        };
        return (line(std::max(row - 1, 0)) + 6 * line(row) + line(std::min(row + 1, n - 1))) / 64;
    };

    const float lit = irradiance > 0 ? 1 - kCosineShare - kUniformShare : 0;
    double sum = 0;
    std::vector<double> cumulative(texels);
    for (size_t k = 0; k < texels; ++k) {
        const auto [column, row] = mortonCell(uint32_t(k));
        const auto i = size_t(row * n + column);
        const double byLight = lit > 0 ? meanLuminance(row, column) * cosines[i] / irradiance : 0;
        const double byCosine = cosines[i] / cosineSum, uniform = 1 / weight;
        sum +=
            (lit * byLight + (1 - kUniformShare - lit) * byCosine + kUniformShare * uniform) * layout.solidAngle(row);
        cumulative[k] = sum;
    }
    for (size_t k = 0; k < texels; ++k) cdf_[k] = float(cumulative[k] / sum);
    cdf_.back() = 1;
    guide_.resize(kGuide);
    for (size_t g = 0, k = 0; g < kGuide; ++g) {
        while (cdf_[k] <= float(g) / kGuide) ++k;
        guide_[g] = uint16_t(k);
    }
}

Rgb RadianceMap::lookup(const Vec3& local) const {
    const int n = layout_.size();
    const Vec2 c = layout_.coordinates(local);
    const float x = std::clamp(c.x - 0.5f, 0.f, float(n - 1)), y = std::clamp(c.y - 0.5f, 0.f, float(n - 1));
    const int x0 = std::min(int(x), n - 2), y0 = std::min(int(y), n - 2);
    const float fx = x - float(x0), fy = y - float(y0);
    const int i = y0 * n + x0;
    return lerp(fy, lerp(fx, texel(i), texel(i + 1)), lerp(fx, texel(i + n), texel(i + n + 1)));
}

Rgb RadianceMap::radiance(const Vec3& d) const { return lookup(frame_.toLocal(d)); }

Rgb RadianceMap::radianceAt(const Vec3& x, const Vec3& d) const {
    const Vec3 offset = frame_.toLocal(x - origin_);
    const Vec3 direction = frame_.toLocal(d);
    const float b = dot(offset, direction), offset2 = lengthSquared(offset);
    // Distance along the ray from x to the sphere of the given radius around the map's origin; 0 if x is outside the
    // sphere.
    const auto meet = [&](float radius) {
        const float c = offset2 - sqr(radius);
        return c < 0 ? std::sqrt(b * b - c) - b : 0.f;
    };
    const auto towards = [&](float t) { return normalize(offset + direction * t); };

    // In most cases x and the origin see the same smooth surface, so the map's distance in direction d gives a good
    // first estimate of the point that x sees.
    const float first = distance(direction);
    float t = meet(first);
    if (t > 0 && first < kInfinity) {
        const float second = distance(towards(t));
        const float refined = meet(second);
        if (refined > 0 && std::abs(second - first) < kSameSurface * first) return lookup(towards(refined));
    }
    if (offset2 < sqr(kNegligibleOffset * harmonicMeanDistance_)) return lookup(direction);
    // Otherwise march along the ray until the surface in the map is closer to the origin than the point on the ray.
    float before = 0;
    t = 0.5f * std::sqrt(offset2);
    for (int i = 0; i < kMarchSteps; ++i, before = t, t *= 2) {
        const float seen = distance(towards(t));
        if (seen * seen > offset2 + t * (2 * b + t)) continue;
        return lookup(towards(std::clamp(meet(seen), before, t)));
    }
    return lookup(direction);
}

RadianceMap::DirectionSample RadianceMap::sample(const Vec2& u) const {
    const float x01 = std::clamp(u.x, 0.f, kOneMinusEpsilon);
    size_t k = guide_[size_t(x01 * float(kGuide))];
    while (cdf_[k] <= x01) ++k;
    const float before = k > 0 ? cdf_[k - 1] : 0;
    const float mass = cdf_[k] - before;
    if (!(mass > 0)) return {};
    const auto [column, row] = mortonCell(uint32_t(k));
    const float x = std::clamp((x01 - before) / mass, 0.f, kOneMinusEpsilon);
    return {frame_.toWorld(layout_.direction(column, row, Vec2(x, u.y))), mass / layout_.solidAngle(row)};
}

float RadianceMap::pdf(const Vec3& d) const {
    const Vec3 local = frame_.toLocal(d);
    if (local.z <= 0) return 0;
    const int i = layout_.texel(local), n = layout_.size();
    const uint32_t k = mortonIndex({i % n, i / n});
    const float before = k > 0 ? cdf_[k - 1] : 0;
    return (cdf_[k] - before) / layout_.solidAngle(i / n);
}

}  // namespace drc
