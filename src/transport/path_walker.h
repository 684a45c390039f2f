// The walk over the vertices of a path: the one loop of all light transport from the camera, except bidirectional path
// tracing. Visitors decide what becomes of the light: pictures (RadianceVisitor), final gather, radiance maps, the
// split into direct and indirect light.
#pragma once
#include <optional>

#include "transport/path_state.h"
#include "transport/to_surface.h"

namespace drc {

// A part of a path that leads through a medium.
struct MediumPassage {
    const Ray& ray;     // starts where the part begins
    float length;       // length of the part if the path is not scattered in it, world units
    MediumSegment end;  // where the path is scattered, and the factor on its throughput
};

// The result of light sampling at a vertex.
struct LitVertex {
    Rgb throughput;  // of the path up to the vertex
    int depth;       // PathState::depth before the vertex
    Rgb light;  // Le times BSDF and cosine, or phase function, over the pdf, times the weight against BSDF sampling
    Vec3 wi;    // direction from the vertex towards the light, unit
};

// Interface of a visitor, with defaults that ignore all light and follow the path to its end. For each vertex, the
// functions are called in the order given here, except that light from a medium is reported before passed() of that
// medium.
struct PathVisitor {
    // The path crosses a medium, whose effect is not yet in the path's throughput.
    void passed(const PathState&, const MediumPassage&) {}
    // The ray meets a surface: the next vertex's, or an emitter without a material before it.
    void met(const PathState&, const SurfaceInteraction&) {}
    // Light arrives along the ray at the latest vertex, from an emitter or a medium: Le times its MIS weight against
    // light sampling, without the path's throughput.
    void emitted(const PathState&, const Rgb&) {}
    // The path has reached its next vertex, in a medium or on a surface. False: the path ends there.
    bool arrived(PathState&, const MediumVertex&) { return true; }
    bool arrived(PathState&, const SurfaceInteraction&) { return true; }
    // Returns the lobes by which the path leaves the surface; none: the path ends there. Surface and BSDF stay valid
    // until scattered() has returned.
    std::optional<LobeMask> leavesBy(PathState&, const SurfaceInteraction&, const Bsdf&) { return LobeFlags::All; }
    // The result of light sampling at the vertex, possibly black.
    void lit(const LitVertex&) {}
    // The path leaves the vertex in a new direction.
    void scattered(PathState&) {}
};

class PathWalker {
  public:
    // lighting must outlive the walker.
    PathWalker(const DirectLighting& lighting, const PathSettings& settings)
        : lighting_(lighting), settings_(settings) {}

    // Walks a path, beginning with its ray.
    template <class Visitor>
    void walk(PathState path, Sampler& sampler, Visitor& visitor) const {
        Place next(*this, path);
        go(path, sampler, visitor, next);
    }
    // Walks on from the vertex `at`, which the path has reached and leaves by these lobes.
    template <class Visitor>
    void walkFrom(const SurfaceInteraction& at, const Bsdf& bsdf, const LobeMask& lobes, PathState path,
                  Sampler& sampler, Visitor& visitor) const {
        Place next;
        if (leave(path, at, BsdfView(bsdf, at.wo, lobes), sampler, visitor, next)) go(path, sampler, visitor, next);
    }

    const DirectLighting& lighting() const { return lighting_; }
    const PathSettings& settings() const { return settings_; }

  private:
    // The first surface along the path's ray.
    struct Place {
        Place() = default;
        Place(const PathWalker& walker, const PathState& path) { find(walker, path); }
        void find(const PathWalker& walker, const PathState& path) {
            any = walker.lighting_.accel().find(path.ray, found);
        }
        bool any = false;
        Accel::Found found;
    };

    template <class Visitor>
    void go(PathState& path, Sampler& sampler, Visitor& visitor, Place& next) const {
        SurfaceInteraction hit;
        MediumVertex inMedium;
        for (;;) {
            // Follow the ray to the next vertex, past emitters and through media.
            switch (advance(path, hit, inMedium, sampler, visitor, next)) {
                case Arrival::Surface: {
                    if (!visitor.arrived(path, hit)) return;
                    const Bsdf bsdf = hit.bsdf();
                    if (bsdf.size() == 0) return;
                    path.group = lighting_.groupOf(hit, bsdf);
                    const std::optional<LobeMask> lobes = visitor.leavesBy(path, hit, bsdf);
                    if (!lobes) return;
                    // Sample a light and the next direction.
                    if (!leave(path, hit, BsdfView(bsdf, hit.wo, *lobes), sampler, visitor, next)) return;
                    break;
                }
                case Arrival::Scattered:
                    if (!visitor.arrived(path, inMedium)) return;
                    if (!leave(path, inMedium, sampler, visitor, next)) return;
                    break;
                case Arrival::Escaped:
                    visitor.emitted(path, lighting_.emissionAtInfinity(path.ray, path.from, path.pdf, path.group));
                    return;
                case Arrival::Lost:
                    return;
            }
        }
    }

    // Follows the path to its next vertex, which is `hit`, or `inMedium` if the path is scattered in a medium on the
    // way.
    template <class Visitor>
    Arrival advance(PathState& path, SurfaceInteraction& hit, MediumVertex& inMedium, Sampler& sampler,
                    Visitor& visitor, Place& next) const {
        const auto met = [&](const SurfaceInteraction& surface) {
            path.distance += surface.t;
            visitor.met(path, surface);
            visitor.emitted(path, lighting_.emissionAtHit(surface, path.from, path.pdf));
        };
        const auto goesOn = [&](const Ray& ray, float length) {
            if (ray.medium == nullptr) return true;
            const float reach = lighting_.accel().lengthInMedium(length);
            const Vec2 u = ray.medium->scatters() ? sampler.get2D() : Vec2(0.f);
            const MediumSegment end = sampleSegment(*ray.medium, reach, path.throughput, u);
            visitor.emitted(path, ray.medium->emitted(reach));
            visitor.passed(path, {ray, reach, end});
            path.passing *= end.passing;
            path.throughput *= end.weight;
            if (!end.scattered) return true;
            path.distance += *end.scattered;
            inMedium = MediumVertex(ray, *end.scattered);
            return false;
        };
        return toSurface(lighting_.accel(), path.ray, next.found, next.any, hit, met, goesOn);
    }

    // Samples a light and the next direction at a vertex. False: the path ends.
    template <class Visitor>
    bool leave(PathState& path, const SurfaceInteraction& at, const BsdfView& view, Sampler& sampler, Visitor& visitor,
               Place& next) const {
        const VertexNumbers u(sampler);
        DirectLighting::Proposal light;
        if (view.hasNonSpecular()) light = lighting_.propose(at, view, path.group, u.light, u.onLight);
        const LitVertex before{path.throughput, path.depth, Rgb(0.f), Vec3(0.f)};
        return leave(before, path, at, light, scatter(path, at, view, u), visitor, next);
    }
    template <class Visitor>
    bool leave(PathState& path, const MediumVertex& at, Sampler& sampler, Visitor& visitor, Place& next) const {
        const VertexNumbers u(sampler);
        DirectLighting::Proposal light = lighting_.propose(at, u.light, u.onLight);
        const LitVertex before{path.throughput, path.depth, Rgb(0.f), Vec3(0.f)};
        return leave(before, path, at, light, scatter(path, at, u), visitor, next);
    }
    template <class Vertex, class Visitor>
    bool leave(LitVertex lit, PathState& path, const Vertex& at, DirectLighting::Proposal& light, bool goesOn,
               Visitor& visitor, Place& next) const {
        // The path's own ray is traced before the shadow ray, which then hides the latency of loading the surface's
        // data.
        if (goesOn) next.find(*this, path);
        lit.light = lighting_.weighted(at, light);
        lit.wi = light.sample.wi;
        visitor.lit(lit);
        if (goesOn) visitor.scattered(path);
        return goesOn;
    }

    // Samples the next direction at a vertex. False: the path ends.
    bool scatter(PathState& path, const SurfaceInteraction& hit, const BsdfView& view, const VertexNumbers& u) const;
    bool scatter(PathState& path, const MediumVertex& at, const VertexNumbers& u) const;
    // Russian roulette, the same for all kinds of vertices. False: the path ends.
    bool survives(PathState& path, float u) const;

    const DirectLighting& lighting_;
    PathSettings settings_;
};

}  // namespace drc
