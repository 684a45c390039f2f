#include "cache/radiance_map.h"

namespace drc {
namespace {

// Share of the sampling density that ignores luminance: a texel that the map holds for black may be lit where another
// point looks through it.
constexpr float kUniformShare = 0.1f;
// Fixed-point steps of the distance correction. Two bring the error below a texel for points within a third of the
// distance that is seen.
constexpr int kParallaxSteps = 2;

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
    // Half floats are precise within 2^-14 ... 2^15: the brightest texel is put high, so that dark ones keep theirs.
    scale_ = maxRadiance > 0 ? maxRadiance / 16384.f : 1.f;
    distanceScale_ = maxDistance > 0 ? maxDistance / 1024.f : 1.f;

    double meanLuminance = 0, inverseDistance = 0, weight = 0;
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
            meanLuminance += luminance(value) * solidAngle;
            weight += solidAngle;
            if (d > 0) inverseDistance += solidAngle / d;
        }
    }
    meanLuminance /= weight;
    harmonicMeanDistance_ = inverseDistance > 0 ? float(weight / inverseDistance) : kInfinity;

    double sum = 0;
    std::vector<double> cumulative(texels);
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const auto i = size_t(row * n + column);
            const double l = luminance(texel(int(i)));
            const double p = meanLuminance > 0 ? (1 - kUniformShare) * l / meanLuminance + kUniformShare : 1;
            sum += p * layout.solidAngle(row);
            cumulative[i] = sum;
        }
    for (size_t i = 0; i < texels; ++i) cdf_[i] = float(cumulative[i] / sum);
    cdf_.back() = 1;
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
    Vec3 seen = direction;  // from the origin towards what x sees
    float t = 0;            // distance from x to it
    for (int i = 0; i < kParallaxSteps; ++i) {
        const float fromOrigin = distance_[size_t(layout_.texel(seen))] * distanceScale_;
        if (!(fromOrigin > 0)) return lookup(seen);  // the environment is equally far from both
        // The sphere of that radius about the origin, met from x: |offset + t d| = fromOrigin.
        const float b = dot(offset, direction), c = lengthSquared(offset) - sqr(fromOrigin);
        if (c >= 0) break;  // x lies beyond what the map sees there: no correction can be trusted
        t = -b + std::sqrt(b * b - c);
        seen = normalize(offset + direction * t);
    }
    return lookup(seen);
}

RadianceMap::DirectionSample RadianceMap::sample(const Vec2& u) const {
    const auto it = std::upper_bound(cdf_.begin(), cdf_.end(), u.x);
    const auto i = size_t(std::min(it - cdf_.begin(), std::ptrdiff_t(cdf_.size()) - 1));
    const float before = i > 0 ? cdf_[i - 1] : 0;
    const float mass = cdf_[i] - before;
    if (!(mass > 0)) return {};
    const int n = layout_.size();
    const int row = int(i) / n, column = int(i) % n;
    const float x = std::clamp((u.x - before) / mass, 0.f, kOneMinusEpsilon);
    return {frame_.toWorld(layout_.direction(column, row, Vec2(x, u.y))), mass / layout_.solidAngle(row)};
}

float RadianceMap::pdf(const Vec3& d) const {
    const Vec3 local = frame_.toLocal(d);
    if (local.z <= 0) return 0;
    const auto i = size_t(layout_.texel(local));
    const float before = i > 0 ? cdf_[i - 1] : 0;
    return (cdf_[i] - before) / layout_.solidAngle(int(i) / layout_.size());
}

}  // namespace drc
