// Diffuse area light over a triangle mesh: one light for all its triangles (PBR 3e, sections 12.5 and 14.2.3). Small
// meshes are sampled by area, pairs of triangles as parallelograms if they form one. Large meshes have a light tree
// over their triangles.
#include <fmt/core.h>

#include "base/memory.h"
#include "math/distribution.h"
#include "math/warp.h"
#include "scene/light.h"
#include "scene/light_tree.h"
#include "scene/parallelogram.h"

namespace drc {
namespace {

// Meshes of up to this many triangles are sampled by area, which is cheaper and preserves the stratification of
// samples.
constexpr uint32_t kFewTriangles = 8;

class MeshAreaLight final : public AreaLight {
  public:
    MeshAreaLight(const TriangleMesh& mesh, const Rgb& radiance, bool twoSided) : AreaLight(radiance, twoSided) {
        const uint32_t count = mesh.triangleCount();
        // Measured: the final data, and temporary lists while the tree is built.
        constexpr double kBytesPerTriangle = 450;
        const MemoryClaim memory(count * kBytesPerTriangle, fmt::format("a light of {} triangles", count));
        std::vector<float> areas(count);
        std::vector<LightReach> reaches(count);
        emitters_.resize(count);
        const float brightness = luminance(radiance);
        for (uint32_t i = 0; i < count; ++i) {
            Emitter& e = emitters_[i];
            LightReach& r = reaches[i];
            for (uint32_t k = 0; k < 3; ++k) {
                e.p[k] = mesh.positions[mesh.indices[3 * size_t(i) + k]];
                r.bounds.extend(e.p[k]);
            }
            e.ng = mesh.geometricNormal(i);
            e.area = areas[i] = mesh.area(i);
            r.axis = e.ng;
            r.spread = 0;
            r.twoSided = twoSided;
            r.intensity = brightness * e.area;
        }
        // Not an alias table, because inverting the cumulative distribution preserves the order of u, and with it the
        // stratification of samples.
        triangles_ = Distribution1D(areas);
        area_ = static_cast<float>(triangles_.integral() * static_cast<double>(areas.size()));
        if (count > kFewTriangles)
            tree_ = LightTree(reaches);
        else
            findFacets();
        findReach(reaches);
    }

    std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const override {
        if (!(area_ > 0)) return {};
        if (tree_.empty()) return sampleFacets(p, u);
        const LightTree::Choice chosen = tree_.sample(p, u.x);
        if (chosen.index < 0) return {};
        const Emitter& emitter = emitters_[size_t(chosen.index)];
        const Vec2 b = sampleUniformTriangle(Vec2(chosen.uRemapped, u.y));
        return sampleOf(p, emitter.at(b), emitter.ng, chosen.probability / emitter.area);
    }

    std::optional<EmittedRay> emit(const Vec2& uOrigin, const Vec2& uLeaving, const SceneSphere& scene) const override {
        if (!(area_ > 0)) return {};
        const DiscreteSample chosen = triangles_.sampleDiscrete(uOrigin.x);
        const Emitter& emitter = emitters_[size_t(chosen.index)];
        const Vec2 b = sampleUniformTriangle(Vec2(chosen.uRemapped, uOrigin.y));
        auto ray = leave(emitter.at(b), emitter.ng, uLeaving, scene);
        if (!ray) return {};
        ray->triangle = static_cast<uint32_t>(chosen.index);
        ray->error = planeError(emitter.p[1] - emitter.p[0], emitter.p[2] - emitter.p[0], ray->p - emitter.p[0]);
        return ray;
    }

    Bounds bounds() const override { return reach_.bounds; }
    LightReach reach() const override { return reach_; }

    float pdf(const Vec3& from, const Vec3& wi, const EmitterHit& hit) const override {
        float perArea = 1 / area_;
        if (!tree_.empty())
            perArea = tree_.probability(from, static_cast<int>(hit.triangle)) / emitters_[hit.triangle].area;
        return perSolidAngle(perArea, hit.p - from, wi, hit.ng);
    }

  private:
    float area() const override { return area_; }

    // A triangle's data for sampling, in one place.
    struct Emitter {
        Vec3 p[3];
        Vec3 ng;
        float area;
        Vec3 at(const Vec2& b) const { return p[0] * b.x + p[1] * b.y + p[2] * (1 - b.x - b.y); }
    };
    // A parallelogram, or the half of it at its corner: a triangle.
    struct Facet {
        Parallelogram shape;
        Vec3 ng;
        bool half;
    };

    void findFacets() {
        std::vector<bool> taken(emitters_.size());
        std::vector<float> areas;
        for (size_t i = 0; i < emitters_.size(); ++i) {
            if (taken[i]) continue;
            const Emitter& e = emitters_[i];
            const std::array<Vec3, 3> corners = std::to_array(e.p);
            Facet facet{{e.p[0], e.p[1] - e.p[0], e.p[2] - e.p[0]}, e.ng, true};
            float area = e.area;
            for (size_t j = i + 1; j < emitters_.size() && facet.half; ++j) {
                const Emitter& other = emitters_[j];
                // Shading normals may have flipped the geometric normal of one of the two.
                if (taken[j] || !(dot(e.ng, other.ng) > 0)) continue;
                if (const auto whole = parallelogramOf(corners, std::to_array(other.p))) {
                    facet.shape = *whole;
                    facet.half = false;
                    area += other.area;
                    taken[j] = true;
                }
            }
            facets_.push_back(facet);
            areas.push_back(area);
        }
        byArea_ = Distribution1D(areas);
    }

    std::optional<LightSample> sampleFacets(const Vec3& p, Vec2 u) const {
        size_t index = 0;
        if (facets_.size() > 1) {
            const DiscreteSample chosen = byArea_.sampleDiscrete(u.x);
            index = size_t(chosen.index);
            u.x = chosen.uRemapped;
        }
        const Facet& facet = facets_[index];
        if (facet.half) {
            const Vec2 b = sampleUniformTriangle(u);
            u = Vec2(b.y, 1 - b.x - b.y);
        }
        const Vec3 point = facet.shape.corner + facet.shape.side0 * u.x + facet.shape.side1 * u.y;
        return sampleOf(p, point, facet.ng, 1 / area_);
    }

    // perArea: pdf of the point per area of the emitter.
    std::optional<LightSample> sampleOf(const Vec3& p, const Vec3& point, const Vec3& ng, float perArea) const {
        const Vec3 d = point - p;
        const float distance = length(d);
        if (!(distance > 0)) return {};
        EmitterHit hit;
        hit.p = point;
        hit.ng = ng;
        LightSample s;
        s.wi = d / distance;
        s.radiance = emitted(hit, -s.wi);
        s.pdf = perSolidAngle(perArea, d, s.wi, ng);
        s.distance = distance;
        s.ng = ng;
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
        // A closed surface is not as bright in any direction as all its parts would be if they faced it, but at least
        // as bright as its average over all directions.
        const float average = luminance(power(0)) / (4 * kPi);
        reach_.intensity = 0;
        for (const LightReach& r : reaches) {
            const float cosine = dot(r.axis, reach_.axis);
            reach_.intensity += r.intensity * (twoSided_ ? std::abs(cosine) : std::max(0.f, cosine));
        }
        reach_.intensity = std::max(reach_.intensity, average);
    }

    std::vector<Emitter> emitters_;
    Distribution1D triangles_;   // over the triangles, by area
    LightTree tree_;             // over the triangles of a large mesh; empty for a small one, for which
    std::vector<Facet> facets_;  // these are sampled,
    Distribution1D byArea_;      // by area
    float area_ = 0;
    LightReach reach_;
};

}  // namespace

std::shared_ptr<const AreaLight> makeMeshAreaLight(const TriangleMesh& mesh, const Rgb& radiance, bool twoSided) {
    return std::make_shared<MeshAreaLight>(mesh, radiance, twoSided);
}

}  // namespace drc
