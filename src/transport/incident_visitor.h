// The light that arrives at a point on a surface, as radiance maps capture it: a visitor that leaves out light straight
// from an emitter.
#pragma once
#include "transport/radiance_visitor.h"

namespace drc {

// The first surface of a path, as a radiance map records it.
struct FirstHit {
    float distance = -1;   // world units; -1: the path escaped
    Vec3 normal{0, 0, 0};  // geometric, turned towards the origin; zero if the path escaped
    // The albedo of the surface towards the origin (Bsdf::albedo), in [0, 1]. For an emitter without a material, the
    // albedo of the surface behind it; zero if the path escaped.
    Rgb albedo{0.f};
    // The part of the sample's radiance that reaches the first non-specular vertex straight from emitters; the rest was
    // scattered by at least one more non-specular vertex.
    Rgb direct{0.f};
};

// R of the split (path_tracer.h): the ray's origin is a vertex of the path and counts in its depth. Emission that the
// ray meets before its first vertex belongs to direct light and is left out.
class IncidentVisitor : public RadianceVisitor {
  public:
    // first: may be null.
    IncidentVisitor(const PathWalker& walker, FirstHit* first)
        : RadianceVisitor(walker, {.direct = first ? &first->direct : nullptr}), first_(first) {}

    void met(const PathState& path, const SurfaceInteraction& surface) {
        if (!first_ || hasMet_) return;
        hasMet_ = true;
        first_->distance = length(surface.p - path.from);
        first_->normal = faceForward(surface.ng, surface.wo);
    }
    void emitted(const PathState& path, const Rgb& light) {
        if (hasArrived_) RadianceVisitor::emitted(path, light);
    }
    template <class Vertex>
    bool arrived(const PathState& path, const Vertex&) {
        hasArrived_ = true;
        noteArrival(path);
        return path.depth < walker_.settings().maxDepth - 1;
    }
    std::optional<LobeMask> leavesBy(const PathState&, const SurfaceInteraction& at, const Bsdf& bsdf) {
        if (first_ && hasMet_ && !hasAlbedo_) {
            hasAlbedo_ = true;
            // Clamped, because lobes only estimate their albedos.
            const Rgb albedo = bsdf.albedo(at.wo);
            for (int c = 0; c < 3; ++c) first_->albedo[c] = albedo[c] > 0 ? std::min(albedo[c], 1.f) : 0.f;
        }
        return LobeFlags::All;
    }

  private:
    FirstHit* const first_;
    bool hasMet_ = false, hasArrived_ = false, hasAlbedo_ = false;
};

}  // namespace drc
