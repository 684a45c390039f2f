#include "maps/map_capture.h"

#include "math/morton.h"

namespace drc {
namespace {

// Sums from which the mean and the variance of a channel are estimated.
struct Moments {
    double sum = 0, squares = 0;
    void add(double x) {
        sum += x;
        squares += x * x;
    }
    float deviationOfMean(int samples) const {
        const double n = samples;
        return float(std::sqrt(std::max(0.0, squares - sum * sum / n) / (n * (n - 1))));
    }
};

}  // namespace

Frame mapFrame(const Vec3& n, const Vec3& up) {
    if (std::abs(dot(n, up)) > 0.999f) return Frame::fromNormal(n);
    const Vec3 s = normalize(cross(up, n));
    return Frame(s, cross(n, s), n);
}

std::optional<float> captureTime(const SurfaceInteraction& at) {
    return at.moves ? std::optional(at.time) : std::nullopt;
}

void captureMap(const PathTracer& tracer, const CaptureSettings& settings, const SpawnPoint& from, const Frame& frame,
                uint64_t stream, CapturedMap& result, std::optional<float> time) {
    const MapLayout& layout = settings.layout;
    const int n = layout.size();
    const auto texels = size_t(layout.texels());
    result.origin = from.p;
    result.frame = frame;
    result.radiance.resize(3 * texels);
    result.normal.resize(3 * texels);
    result.distance.resize(texels);
    result.albedo.resize(3 * texels);
    result.direct.resize(3 * texels);
    const bool deviations = settings.deviations && settings.samplesPerTexel > 1;
    result.deviation.resize(deviations ? 3 * texels : 0);

    const float spread = std::sqrt(layout.solidAngle(n / 2));  // cone angle of one texel at the middle row
    const float weight = 1.f / float(settings.samplesPerTexel);
    // Without motion, no random number is used for the time.
    const bool drawTime = !time && tracer.anythingMoves();
    Sampler sampler(stream, 0);
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column) {
            const auto texel = size_t(row * n + column);
            // Neighbouring texels get neighbouring sample indices, so that every dimension of the paths is stratified
            // over each region of the map.
            const uint32_t index = mortonIndex({column, row}) * uint32_t(settings.samplesPerTexel);
            Rgb sum(0.f);
            Moments moments[3];
            for (int s = 0; s < settings.samplesPerTexel; ++s) {
                sampler.start(stream, index + uint32_t(s));
                Ray ray;
                ray.d = frame.toWorld(layout.direction(column, row, sampler.get2D()));
                ray.o = from.towards(ray.d);
                ray.time = drawTime ? settings.shutter.motion(sampler.get1D()) : time.value_or(0);
                ray.coneWidth = from.footprint;
                ray.coneSpread = spread;
                FirstHit first;
                const Rgb sample = tracer.incident(ray, sampler, s == 0 ? &first : nullptr);
                sum += sample;
                if (deviations)
                    for (int c = 0; c < 3; ++c) moments[c].add(double(sample[c]));
                if (s > 0) continue;
                result.distance[texel] = first.distance;
                const Vec3 normal = frame.toLocal(first.normal);
                for (size_t c = 0; c < 3; ++c) {
                    result.normal[c * texels + texel] = normal[int(c)];
                    result.albedo[c * texels + texel] = first.albedo[int(c)];
                    result.direct[c * texels + texel] = first.direct[int(c)];
                }
            }
            for (size_t c = 0; c < 3; ++c) result.radiance[c * texels + texel] = sum[int(c)] * weight;
            if (!deviations) continue;
            for (size_t c = 0; c < 3; ++c)
                result.deviation[c * texels + texel] = moments[c].deviationOfMean(settings.samplesPerTexel);
        }
    }
}

}  // namespace drc
