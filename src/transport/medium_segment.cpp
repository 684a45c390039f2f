#include "transport/medium_segment.h"

#include <algorithm>

namespace drc {
namespace {

// Each channel is chosen with at least this probability, so that no weight becomes large.
constexpr float kLeastShare = 0.05f;

// Probabilities of choosing each channel, in proportion to `wanted`, the light that it could scatter.
Rgb sharesOf(const Rgb& wanted) {
    const float sum = wanted.x + wanted.y + wanted.z;
    if (!(sum > 0) || !std::isfinite(sum)) return Rgb(1.f / 3);
    return wanted * ((1 - 3 * kLeastShare) / sum) + Rgb(kLeastShare);
}

}  // namespace

Ray MediumVertex::spawnRay(const Vec3& d, float spread) const {
    Ray ray;
    ray.o = p;
    ray.d = d;
    ray.time = time;
    ray.coneWidth = footprint;
    ray.coneSpread = std::max(spread, coneSpread);
    ray.medium = medium;
    return ray;
}

// Each channel has a free path length of its own. The path chooses one channel at random and samples the distance with
// that channel's length. The pdf is the mean of the pdfs of all channels, which keeps the weights of the other channels
// bounded (the balance heuristic for one sample: Veach 1997, section 9.2.4; PBR 3e, section 15.2.1).
MediumSegment sampleSegment(const Medium& medium, float length, const Rgb& throughput, const Vec2& u) {
    MediumSegment segment;
    if (!medium.scatters()) {
        segment.weight = medium.transmittance(length);
        return segment;
    }
    const Rgb sigma = medium.sigmaT();
    const Rgb shares = sharesOf(throughput * medium.albedo());
    const int channel = u.x < shares.x ? 0 : u.x < shares.x + shares.y ? 1 : 2;
    const float distance = sigma[channel] > 0 ? -std::log1p(-u.y) / sigma[channel] : kInfinity;
    const bool scattered = distance < length;
    const Rgb passes = medium.transmittance(scattered ? distance : length);
    segment.passing = dot(shares, medium.transmittance(length));
    const Rgb density = scattered ? sigma * passes : passes;
    const float pdf = dot(shares, density);
    if (scattered) segment.scattered = distance;
    segment.weight = pdf > 0 ? (scattered ? medium.sigmaS * passes : passes) * (1 / pdf) : Rgb(0.f);
    return segment;
}

}  // namespace drc
