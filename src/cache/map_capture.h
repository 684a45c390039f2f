// Tracing of a radiance map: the indirect light that arrives at a point from each direction of a hemisphere, with the
// distance to and the normal of what is seen there (Jiang and Kainz, section 3).
#pragma once
#include <optional>
#include <vector>

#include "cache/projection.h"
#include "integrators/path_tracer.h"
#include "math/frame.h"

namespace drc {

// Planar arrays of N x N texels, row-major, index row * N + column.
struct CapturedMap {
    Vec3 origin{0.f};             // world space, on the surface
    Frame frame;                  // n: normal of the surface on the side that the map looks at
    std::vector<float> radiance;  // [3][N*N], W / (sr m^2)
    std::vector<float> normal;    // [3][N*N], in the map's frame, towards the origin; zero where a ray escaped
    std::vector<float> distance;  // [N*N], world units; -1 where a ray escaped
    std::vector<float> albedo;    // [3][N*N], of what is seen (FirstHit), in [0, 1]. Empty in data that have none
    // [3][N*N]: what of `radiance` came to the surface seen straight from emitters (FirstHit::direct): less noisy than
    // the rest, and sharper. Empty in data that have none
    std::vector<float> direct;
    // [3][N*N]: square root of the estimated variance of each value of `radiance`. Empty unless asked for. Too large
    // rather than too small: it takes a texel's samples for independent, and they are stratified.
    std::vector<float> deviation;
};

struct CaptureSettings {
    MapLayout layout{Projection::EqualArea, 32};
    int samplesPerTexel = 1;
    bool deviations = false;  // fill CapturedMap::deviation; needs two samples a texel
};

// The frame of a map about the unit normal n: the s axis is horizontal for the scene's up, so that the frame turns
// smoothly over a wall; where n is within 2.5 degrees of up or down, any frame serves.
Frame mapFrame(const Vec3& n, const Vec3& up);

// stream: seed of this map's random numbers. `result`'s buffers are reused. Each texel is the mean of its samples;
// distance, normal, albedo and direct light are those of the first.
// time: of the map's rays. None: each has its own, uniformly while the camera's shutter is open, so that the map is the
// mean over the exposure. See captureTime.
void captureMap(const PathTracer& tracer, const CaptureSettings& settings, const SpawnPoint& from, const Frame& frame,
                uint64_t stream, CapturedMap& result, std::optional<float> time = std::nullopt);

// The time of a map that stands on this surface: none, but where the surface moves. At other times than that of the hit
// it is elsewhere, and the map would look out of its inside, or stand off it.
std::optional<float> captureTime(const SurfaceInteraction& at);

}  // namespace drc
