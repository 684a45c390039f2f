// Traces radiance maps: the indirect light arriving at a point from each direction of a hemisphere, and the distance
// and normal of the surface seen in that direction (Jiang and Kainz, section 3).
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
    Frame frame;                  // world space; n: normal of the surface, on the side of the captured hemisphere
    std::vector<float> radiance;  // [3][N*N], W / (sr m^2)
    std::vector<float> normal;    // [3][N*N], in the map's frame, facing the origin; zero where a ray escaped
    std::vector<float> distance;  // [N*N], world units; -1 where a ray escaped
    std::vector<float> albedo;    // [3][N*N], of the surface seen (FirstHit), in [0, 1]; empty in data without albedo
    // [3][N*N]: the part of `radiance` that reached the surface seen directly from emitters (FirstHit::direct). Sharper
    // and less noisy than the rest. Empty in data without direct light.
    std::vector<float> direct;
    // [3][N*N]: estimated standard deviation of each value of `radiance`; empty unless requested. An overestimate,
    // because it treats a texel's samples as independent although they are stratified.
    std::vector<float> deviation;
};

struct CaptureSettings {
    MapLayout layout{Projection::EqualArea, 32};
    int samplesPerTexel = 1;
    bool deviations = false;  // fill CapturedMap::deviation; needs at least two samples per texel
    Shutter shutter{};        // exposure over which the times of rays are spread, if captureMap() gets no time
};

// A map's frame about the unit normal n, world space. The s axis is horizontal with respect to the scene's up
// direction, so that the frame turns smoothly along a wall. Within 2.5 degrees of up or down, the frame is arbitrary.
Frame mapFrame(const Vec3& n, const Vec3& up);

// stream: seed of this map's random numbers. time: the time of all rays; if none, each ray has its own, uniform over
// the camera's exposure, so that the map is the mean over the exposure (see captureTime). A texel's radiance is the
// mean of its samples; its distance, normal, albedo and direct light come from its first sample. Reuses the buffers of
// `result`.
void captureMap(const PathTracer& tracer, const CaptureSettings& settings, const SpawnPoint& from, const Frame& frame,
                uint64_t stream, CapturedMap& result, std::optional<float> time = std::nullopt);

// The time at which to capture a map on this surface: none unless the surface moves. A moving surface is elsewhere at
// times other than the hit's, where the map would see its inside or float above it.
std::optional<float> captureTime(const SurfaceInteraction& at);

}  // namespace drc
