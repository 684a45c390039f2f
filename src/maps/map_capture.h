// Traces radiance maps: the indirect light that arrives at a point from each direction of a hemisphere, with the
// distance and the normal of the surface seen there (Jiang and Kainz, section 3).
#pragma once
#include <optional>
#include <vector>

#include "maps/projection.h"
#include "math/frame.h"
#include "transport/path_tracer.h"

namespace drc {

// Planar arrays of N x N texels, row-major, index row * N + column.
struct CapturedMap {
    Vec3 origin{0.f};             // world space, on the surface
    Frame frame;                  // n: normal of the surface on the side that the map looks at
    std::vector<float> radiance;  // [3][N*N], W / (sr m^2)
    std::vector<float> normal;    // [3][N*N], in the map's frame, towards the origin; zero where a ray escaped
    std::vector<float> distance;  // [N*N], world units; -1 where a ray escaped
    std::vector<float> albedo;    // [3][N*N], of the surface seen (FirstHit), in [0, 1]; empty in data without it
    // [3][N*N]: the part of `radiance` that came to the surface seen straight from emitters (FirstHit::direct): less
    // noisy than the rest, and sharper. Empty in data without it.
    std::vector<float> direct;
    // [3][N*N]: the standard deviation of each value of `radiance`, estimated; empty unless it was asked for.
    // Overestimates that of stratified samples, because it takes a texel's samples for independent.
    std::vector<float> deviation;
};

struct CaptureSettings {
    MapLayout layout{Projection::EqualArea, 32};
    int samplesPerTexel = 1;
    bool deviations = false;  // fill CapturedMap::deviation; needs at least two samples a texel
    Shutter shutter{};        // over which rays without a time of their own are spread
};

// The frame of a map about the unit normal n: the s axis is horizontal with respect to the scene's up direction, so
// that the frame turns smoothly over a wall; where n is within 2.5 degrees of up or down, any frame serves.
Frame mapFrame(const Vec3& n, const Vec3& up);

// stream: seed of this map's random numbers. The buffers of `result` are reused. Each texel is the mean of its samples;
// distance, normal, albedo and direct light are those of its first sample.
// time: of all rays. None: each ray has its own, uniform over the camera's exposure, so that the map is the mean over
// it; see captureTime.
void captureMap(const PathTracer& tracer, const CaptureSettings& settings, const SpawnPoint& from, const Frame& frame,
                uint64_t stream, CapturedMap& result, std::optional<float> time = std::nullopt);

// The time for a map on this surface: none unless the surface moves. At other times than that of the hit a moving
// surface is elsewhere, and the map would see its inside, or float above it.
std::optional<float> captureTime(const SurfaceInteraction& at);

}  // namespace drc
