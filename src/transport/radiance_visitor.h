// The path tracer, as a visitor of its walk: sums all light of a camera path.
#pragma once
#include "transport/g_buffer_sample.h"
#include "transport/path_walker.h"

namespace drc {

// Parts of a camera sample that are recorded beside its radiance; each may be null.
struct SampleParts {
    GBufferSample* gBuffer = nullptr;
    // The part of the sample's radiance that comes straight from emitters to the camera or to the first non-specular
    // vertex; the rest was scattered by at least one more non-specular vertex.
    Rgb* direct = nullptr;
};

class RadianceVisitor : public PathVisitor {
  public:
    RadianceVisitor(const PathWalker& walker, const SampleParts& parts) : walker_(walker), parts_(parts) {}

    void passed(const PathState& path, const MediumPassage& passage) {
        if (parts_.gBuffer && path.depth == 0) parts_.gBuffer->recordMedium(walker_.lighting().accel(), path, passage);
    }
    void met(const PathState& path, const SurfaceInteraction& surface) {
        if (parts_.gBuffer && path.depth == 0) parts_.gBuffer->meet(surface);
    }
    void emitted(const PathState& path, const Rgb& light) { sum_ += path.throughput * light; }
    template <class Vertex>
    bool arrived(const PathState& path, const Vertex&) {
        noteArrival(path);
        return path.depth < walker_.settings().maxDepth;
    }
    std::optional<LobeMask> leavesBy(const PathState& path, const SurfaceInteraction& at, const Bsdf& bsdf) {
        noteSurface(path, at, bsdf);
        return LobeFlags::All;
    }
    void lit(const LitVertex& vertex) { sum_ += vertex.throughput * vertex.light; }

    // The radiance after the walk, and its direct part, both clamped.
    Rgb finish() const {
        const float clamp = walker_.settings().clamp;
        // The direct part is scaled together with the whole.
        if (parts_.direct) *parts_.direct = partOfClamped(direct_.value_or(sum_), sum_, clamp);
        return clampedSample(sum_, clamp);
    }

  protected:
    void add(const Rgb& light) { sum_ += light; }
    void noteArrival(const PathState& path) {
        // All light found before the second vertex is direct light.
        if (path.depth > 0 && !direct_) direct_ = sum_;
        if (parts_.gBuffer) parts_.gBuffer->covered = true;
    }
    void noteSurface(const PathState& path, const SurfaceInteraction& at, const Bsdf& bsdf) {
        if (parts_.gBuffer && path.depth == 0)
            parts_.gBuffer->record(path.throughput * path.passing, at, bsdf, path.distance);
    }
    const PathWalker& walker_;

  private:
    const SampleParts parts_;
    Rgb sum_{0.f};
    std::optional<Rgb> direct_;  // none before the second vertex
};

}  // namespace drc
