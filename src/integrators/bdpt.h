// Bidirectional path tracing (Lafortune and Willems 1993; Veach and Guibas 1994; PBR 3e, section 16.3): paths from the
// camera and paths from the lights, joined in every way. Each way to make a path counts by the power heuristic (Veach
// 1997, section 10.2).
//
// With s vertices of a path made from the light and t from the camera, the points on light and lens included: s = 0
// meets an emitter by chance, s = 1 samples one for the point, t = 1 joins light to the lens and lands anywhere on the
// film. A light that the camera sees itself (s = t = 1) is left to s = 0.
#pragma once
#include <span>
#include <unordered_map>

#include "integrators/path_tracer.h"
#include "math/distribution.h"

namespace drc {

// Light that reached the film by t = 1, at a position in pixels. Already divided by the number of light paths that go
// with a sample of each pixel.
struct Splat {
    Vec2 film;
    Rgb radiance;
};

class BidirectionalTracer {
  public:
    // All but settings must outlive the tracer. lightPaths: calls of radiance() that make one sample of each pixel.
    BidirectionalTracer(const Scene& scene, const Accel& accel, const LightSampler& lights,
                        const PathSettings& settings, double lightPaths);

    // All light that arrives along a ray of the scene's camera, but for what t = 1 finds. One light path is made for
    // it; where that reaches the film is appended to splats. gBuffer, if not null, receives what the camera sees.
    Rgb radiance(const Ray& cameraRay, Sampler& sampler, std::vector<Splat>& splats,
                 GBufferSample* gBuffer = nullptr) const;

    // One vertex of a whole path, for the weights: the densities, per area, with which it is made from either side.
    struct Node {
        float fromCamera = 0, fromLight = 0;
        bool specular = false;
    };
    // What the weights need to know of a path's ends.
    struct Ends {
        // Density of the light's point if it is sampled for the vertex next to it, over its fromLight.
        float chosen = 0;
        bool lightCanBeMet = true;
        bool lensCanBeJoined = true;
        double lightPaths = 1;
    };
    // Share of the way that makes `s` of the nodes from the light in all ways that can make the path. nodes: from the
    // one next to the lens to the light.
    static float weight(std::span<const Node> nodes, size_t s, const Ends& ends);

  private:
    struct Vertex;
    struct Paths;
    struct LightEnd;
    struct Step;

    // Light that goes along d, and what samples at `from` choose it with: per solid angle, 1 for delta lights.
    LightEnd lightEnd(const Light& light, const EmitterHit& at, const Vec3& d, const Vec3& from, float chosen) const;
    LightEnd lightEnd(const Light& light, const EmitterHit& at, const Vec3& d, const Vec3& from) const;

    Rgb traceCamera(const Ray& cameraRay, Sampler& sampler, Paths& paths, GBufferSample* gBuffer) const;
    void traceLight(float time, Sampler& sampler, Paths& paths, std::vector<Splat>& splats) const;
    // s = 1, for the last of the camera's vertices.
    Rgb sampleLight(Paths& paths, float uLight, const Vec2& u) const;
    // t = 1, for the last of the light's.
    void joinLens(Paths& paths, float time, const Vec2& uLens, std::vector<Splat>& splats) const;
    Rgb join(Paths& paths, size_t camera, size_t light) const;

    // Weights of what the functions above find: densities per area where nothing else is said.
    float weightOfMet(Paths& paths, const LightEnd& end, float fromCamera) const;
    float weightOfSampled(Paths& paths, const LightEnd& end, const Vec3& wi, float pdf) const;
    float weightOfJoined(Paths& paths, size_t camera, size_t light, const Vec3& d) const;
    float weightAtLens(Paths& paths, const Vec3& d, float fromCamera) const;
    float weight(const Paths& paths, size_t s) const;
    // To the scratch of `paths`: the light's vertices from the given one to the light.
    void appendLight(Paths& paths, size_t first, float fromCamera, float nextFromCamera) const;

    const Scene& scene_;
    const Accel& accel_;
    DirectLighting lighting_;
    PathSettings settings_;
    double lightPaths_;
    SceneSphere sphere_;
    std::vector<const Light*> emitting_;
    Distribution1D byPower_;                               // over emitting_
    std::unordered_map<const Light*, float> probability_;  // by byPower_
};

}  // namespace drc
