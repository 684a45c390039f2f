// Diffuse area light over a triangle mesh: one light for all its triangles (PBR 3e, sections 12.5 and 14.2.3). The
// triangles of a small mesh are chosen by their flux, those of a large one by a light tree, and pairs of triangles that
// form a parallelogram in a small mesh are sampled as one. On a triangle or parallelogram, points are uniform by area
// or in proportion to an image.
#include <fmt/core.h>

#include "base/memory.h"
#include "math/distribution.h"
#include "scene/lights/facet_grids.h"
#include "scene/lights/light.h"
#include "scene/lights/light_tree.h"

namespace drc {
namespace {

// Meshes of up to this many triangles are sampled by flux alone, which is cheaper and preserves the stratification of
// samples.
constexpr uint32_t kFewTriangles = 8;

class MeshAreaLight final : public AreaLight {
  public:
    MeshAreaLight(const TriangleMesh& mesh, const Emission& emission, bool twoSided) : AreaLight(emission, twoSided) {
        const uint32_t count = mesh.triangleCount();
        // Measured: the final data plus temporary lists while the tree is built.
        constexpr double kBytesPerTriangle = 450, kBytesOfCoordinates = sizeof(FacetCoordinates);
        const MemoryClaim memory(count * (kBytesPerTriangle + (emission_.image() != nullptr ? kBytesOfCoordinates : 0)),
                                 fmt::format("a light of {} triangles", count));
        const bool hasImage = emission_.image() != nullptr;
        if (count > kFewTriangles) {
            facets_.reserve(count);
            for (uint32_t i = 0; i < count; ++i) facets_.push_back(triangleFacet(mesh, i));
        } else {
            facets_ = joinedFacets(mesh, hasImage, facetOf_);
        }
        if (hasImage)
            for (const Facet& facet : facets_) coordinates_.push_back(coordinatesOn(facet, mesh));
        std::vector<float> weights;
        std::vector<LightReach> reaches;
        weights.reserve(facets_.size());
        reaches.reserve(facets_.size());
        double sum[3] = {};
        for (size_t i = 0; i < facets_.size(); ++i) {
            const FacetEmission shown = emissionOf(i);
            if (shown.grid) grids_.resize(facets_.size());
            if (shown.grid) grids_[i] = shown.grid;
            const Facet& facet = facets_[i];
            weights.push_back(shown.weight * facet.area);
            reaches.push_back(reachOf(facet, weights.back()));
            for (int c = 0; c < 3; ++c) sum[c] += double(shown.mean[c]) * double(facet.area);
        }
        for (uint32_t i = 0; i < count; ++i)
            for (size_t k = 0; k < 3; ++k)
                reaches[facetOf(i)].bounds.extend(mesh.positions[mesh.indices[3 * size_t(i) + k]]);
        radianceTimesArea_ = emission_.scale() * Rgb(float(sum[0]), float(sum[1]), float(sum[2]));
        // Not an alias table, because inverting the cumulative distribution preserves the order of u, and with it the
        // stratification of samples.
        byFlux_ = Distribution1D(weights);
        emits_ = byFlux_.integral() > 0;
        if (count > kFewTriangles) tree_ = LightTree(reaches);
        findReach(reaches);
    }

    std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const override {
        if (!emits_) return {};
        size_t index = 0;
        float probability = 1;
        Vec2 onFacet = u;
        if (!tree_.empty()) {
            const LightTree::Choice chosen = tree_.sample(p, u.x);
            if (chosen.index < 0) return {};
            index = size_t(chosen.index);
            probability = chosen.probability;
            onFacet.x = chosen.uRemapped;
        } else if (facets_.size() > 1) {
            const DiscreteSample chosen = byFlux_.sampleDiscrete(u.x);
            index = size_t(chosen.index);
            probability = chosen.probability;
            onFacet.x = chosen.uRemapped;
        }
        const Point point = pointOn(index, onFacet);
        return sampleOf(p, point.hit, probability * point.pdf);
    }

    std::optional<EmittedRay> emit(const Vec2& uOrigin, const Vec2& uLeaving, const SceneSphere& scene) const override {
        if (!emits_) return {};
        const DiscreteSample chosen = byFlux_.sampleDiscrete(uOrigin.x);
        const Facet& facet = facets_[size_t(chosen.index)];
        auto ray = leave(pointOn(size_t(chosen.index), Vec2(chosen.uRemapped, uOrigin.y)).hit, uLeaving, scene);
        if (!ray) return {};
        ray->error = facet.planeErrorAt(ray->p);
        return ray;
    }

    Bounds bounds() const override { return reach_.bounds; }
    LightReach reach() const override { return reach_; }

    float pdf(const Vec3& from, const Vec3& wi, const EmitterHit& hit) const override {
        const size_t index = facetOf(hit.triangle);
        const float probability = tree_.empty() ? byFlux_.probability(int(index)) : tree_.probability(from, int(index));
        return perSolidAngle(probability * densityOn(index, hit.p), hit.p - from, wi, hit.ng);
    }

  private:
    Rgb radianceTimesArea() const override { return radianceTimesArea_; }
    float originPdf(const EmitterHit& at) const override {
        const size_t index = facetOf(at.triangle);
        return byFlux_.probability(int(index)) * densityOn(index, at.p);
    }

    size_t facetOf(uint32_t triangle) const { return facetOf_.empty() ? triangle : facetOf_[triangle]; }

    // Emission of a facet before multiplication by emission_.scale(). Without an image all facets have the weight 1, so
    // that they are chosen by area.
    FacetEmission emissionOf(size_t facet) const {
        const EmissionImage* image = emission_.image();
        return image ? image->facetGrids().of(*image, coordinates_[facet]) : FacetEmission{Rgb(1.f), 1, nullptr};
    }

    // Directional bounds of the facet. The caller fills in `bounds`.
    LightReach reachOf(const Facet& facet, float weight) const {
        LightReach r;
        r.axis = facet.ng;
        r.spread = 0;
        r.falloff = std::asin(emission_.profile().sinReach());
        r.twoSided = twoSided_;
        r.intensity = luminance(emission_.scale()) * weight * emission_.profile().share(facet.ng, facet.ng);
        return r;
    }

    // A point of a facet with its pdf per area.
    struct Point {
        EmitterHit hit;
        float pdf;
    };
    Point pointOn(size_t index, Vec2 u) const {
        const Facet& facet = facets_[index];
        float pdf = 1 / facet.area;
        if (const EmissionGrid* grid = gridOf(index)) {
            const EmissionGrid::Sample s = grid->sample(u);
            u = s.at;
            pdf *= s.density;
        }
        const Vec2 xy = pointOnFacet(u, facet.half);
        return {{facet.at(xy), facet.ng, facet.triangle, coordinates_.empty() ? Vec2(0.f) : coordinates_[index].at(xy)},
                pdf};
    }
    float densityOn(size_t index, const Vec3& p) const {
        const Facet& facet = facets_[index];
        const EmissionGrid* grid = gridOf(index);
        return (grid ? grid->density(squareOfFacet(facet.coordinatesOf(p), facet.half)) : 1) / facet.area;
    }
    const EmissionGrid* gridOf(size_t facet) const { return grids_.empty() ? nullptr : grids_[facet].get(); }

    // perArea: pdf of the point per area of the emitter.
    std::optional<LightSample> sampleOf(const Vec3& p, const EmitterHit& hit, float perArea) const {
        const Vec3 d = hit.p - p;
        const float distance = length(d);
        if (!(distance > 0)) return {};
        LightSample s;
        s.wi = d / distance;
        s.radiance = emitted(hit, -s.wi);
        s.pdf = perSolidAngle(perArea, d, s.wi, hit.ng);
        s.distance = distance;
        s.ng = hit.ng;
        s.triangle = hit.triangle;
        s.uv = hit.uv;
        if (!(s.pdf > 0) || isBlack(s.radiance)) return {};
        return s;
    }

    // d is the vector to the emitter's point, wi its direction.
    static float perSolidAngle(float perArea, const Vec3& d, const Vec3& wi, const Vec3& ng) {
        const float r = perArea * lengthSquared(d) / absDot(ng, wi);
        return std::isfinite(r) ? r : 0;
    }

    void findReach(const std::vector<LightReach>& reaches) {
        bool any = false;
        for (const LightReach& r : reaches) {
            if (!(r.intensity > 0)) continue;
            reach_ = any ? merged(reach_, r) : r;
            any = true;
        }
        // No direction faces all parts of a closed surface, so each part counts by the cosine of its normal to the
        // axis. The average over all directions is a lower bound.
        const float average = luminance(power(0)) / (4 * kPi);
        reach_.intensity = 0;
        for (const LightReach& r : reaches) {
            const float cosine = dot(r.axis, reach_.axis);
            reach_.intensity += r.intensity * (twoSided_ ? std::abs(cosine) : std::max(0.f, cosine));
        }
        reach_.intensity = std::max(reach_.intensity, average);
    }

    std::vector<Facet> facets_;      // one per triangle in a large mesh
    LightTree tree_;                 // over the facets of a large mesh; empty for a small one
    std::vector<uint32_t> facetOf_;  // index of each triangle's facet in a small mesh; empty for a large one
    Distribution1D byFlux_;          // over the facets
    // With an image: its (u, v) on each facet, and the tables for sampling it.
    std::vector<FacetCoordinates> coordinates_;
    std::vector<std::shared_ptr<const EmissionGrid>> grids_;  // null if a facet is sampled uniformly; empty if all are
    bool emits_ = false;
    Rgb radianceTimesArea_;
    LightReach reach_;
};

}  // namespace

std::shared_ptr<const AreaLight> makeMeshAreaLight(const TriangleMesh& mesh, const Emission& emission, bool twoSided) {
    return std::make_shared<MeshAreaLight>(mesh, emission, twoSided);
}

}  // namespace drc
