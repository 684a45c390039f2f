// Bidirectional path tracing (Lafortune and Willems 1993; Veach and Guibas 1994; PBR 3e, section 16.3): paths from the
// camera and from the lights, connected in every possible way, weighted by multiple importance sampling with the power
// heuristic (Veach 1997, section 10.2).
//
// A strategy (s, t) makes a path of s vertices from the light and t from the camera, counting the points on light and
// lens. s = 0 hits an emitter with a camera path; s = 1 samples a light for the camera path's last vertex; t = 1
// connects a light path to the lens and contributes anywhere on the film. Lights that the camera sees directly are left
// to s = 0, so s = t = 1 is not used.
#pragma once
#include <span>
#include <unordered_map>

#include "math/distribution.h"
#include "transport/path_tracer.h"

namespace drc {

// A contribution of the strategies with t = 1, at a film position in pixels. It is already divided by the number of
// light paths that are traced while each pixel gets one sample.
struct Splat {
    Vec2 film;
    Rgb radiance;
};

class BidirectionalTracer {
  public:
    // All arguments except settings must outlive the tracer. lightPaths: number of calls of radiance() in which each
    // pixel gets one sample.
    BidirectionalTracer(const Scene& scene, const Camera& camera, const Accel& accel, const LightSampler& lights,
                        const PathSettings& settings, double lightPaths);

    // Radiance along a camera ray from all strategies except t = 1. Also traces one light path, and appends its
    // connections to the lens (t = 1) to `splats`. gBuffer, if not null, receives the surfaces that the camera sees.
    Rgb radiance(const Ray& cameraRay, Sampler& sampler, std::vector<Splat>& splats,
                 GBufferSample* gBuffer = nullptr) const;

    // A vertex of a complete path, for the MIS weights: its pdf per area when sampled from the camera and from the
    // light.
    struct Node {
        float fromCamera = 0, fromLight = 0;
        bool specular = false;
        bool lightEndsBefore = false;  // whether light paths end before or at this vertex
    };
    // Properties of a path's ends that the weights depend on.
    struct Ends {
        // Pdf of the light's point by light sampling at the adjacent vertex (s = 1), divided by its Node::fromLight.
        float chosen = 0;
        bool lightCanBeMet = true;
        bool lensCanBeJoined = true;
        double lightPaths = 1;
        bool lightStartsPaths = true;
    };
    // MIS weight of the strategy that samples the last `s` nodes from the light, among all strategies that can sample
    // the path. nodes: from the vertex next to the lens to the point on the light.
    static float weight(std::span<const Node> nodes, size_t s, const Ends& ends);

  private:
    struct Vertex;
    struct Paths;
    struct LightEnd;
    struct Step;

    // The start of a light path that emits along d. chosen: pdf with which light sampling at `from` finds this point,
    // per solid angle, including the choice of the light (for delta lights, the probability of that choice alone).
    LightEnd lightEnd(const Light& light, const EmitterHit& at, const Vec3& d, const Vec3& from, float chosen) const;
    LightEnd lightEnd(const Light& light, const EmitterHit& at, const Vec3& d, const Vec3& from) const;

    Rgb traceCamera(const Ray& cameraRay, Sampler& sampler, Paths& paths, GBufferSample* gBuffer) const;
    void traceLight(float time, Sampler& sampler, Paths& paths, std::vector<Splat>& splats) const;
    // Strategy s = 1 for the last vertex of the camera path.
    Rgb sampleLight(Paths& paths, float uLight, const Vec2& u) const;
    // Strategy t = 1 for the last vertex of the light path.
    void joinLens(Paths& paths, float time, const Vec2& uLens, std::vector<Splat>& splats) const;
    Rgb join(Paths& paths, size_t camera, size_t light) const;

    // MIS weights of the contributions of the functions above. Pdfs are per area unless stated otherwise.
    float weightOfMet(Paths& paths, const LightEnd& end, float fromCamera) const;
    float weightOfSampled(Paths& paths, const LightEnd& end, const Vec3& wi, float pdf) const;
    float weightOfJoined(Paths& paths, size_t camera, size_t light, const Vec3& d) const;
    float weightAtLens(Paths& paths, const Vec3& d, float fromCamera) const;
    float weight(const Paths& paths, size_t s) const;
    // Appends the light path's vertices, from index `first` back to the light, to the scratch memory of `paths`.
    // fromCamera, nextFromCamera: Node::fromCamera of the first and of the second node appended.
    void appendLight(Paths& paths, size_t first, float fromCamera, float nextFromCamera) const;

    const Camera& camera_;
    const Accel& accel_;
    DirectLighting lighting_;
    PathSettings settings_;
    double lightPaths_;
    SceneSphere sphere_;
    std::vector<const Light*> emitting_;
    Distribution1D byPower_;                               // over emitting_, by power
    std::unordered_map<const Light*, float> probability_;  // of each light in byPower_
};

}  // namespace drc
