// Diffuse area light over a triangle mesh: one light for all its triangles (PBR 3e, sections 12.5 and 14.2.3). A few
// triangles are chosen by area; of many a tree finds those that matter to the lit point.
#include <fmt/core.h>

#include "base/memory.h"
#include "math/distribution.h"
#include "math/warp.h"
#include "scene/light.h"
#include "scene/light_tree.h"

namespace drc {
namespace {

// Up to this many triangles are chosen by area, which costs less and keeps samples better spread.
constexpr uint32_t kFewTriangles = 8;

class MeshAreaLight final : public AreaLight {
  public:
    MeshAreaLight(const TriangleMesh& mesh, const Rgb& radiance, bool twoSided) : AreaLight(radiance, twoSided) {
        const uint32_t count = mesh.triangleCount();
        // As measured: what is kept, and while the tree is built its lists, each of which grows by copies.
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
        // Not an alias table: the order of u is kept, and with it the stratification of the samples.
        triangles_ = Distribution1D(areas);
        area_ = static_cast<float>(triangles_.integral() * static_cast<double>(areas.size()));
        if (count > kFewTriangles) tree_ = LightTree(reaches);
        findReach(reaches);
    }

    std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const override {
        if (!(area_ > 0)) return {};
        int index;
        float probability, uLeft;
        if (tree_.empty()) {
            const DiscreteSample chosen = triangles_.sampleDiscrete(u.x);
            index = chosen.index;
            probability = chosen.probability;
            uLeft = chosen.uRemapped;
        } else {
            const LightTree::Choice chosen = tree_.sample(p, u.x);
            if (chosen.index < 0) return {};
            index = chosen.index;
            probability = chosen.probability;
            uLeft = chosen.uRemapped;
        }
        const Vec2 b = sampleUniformTriangle(Vec2(uLeft, u.y));
        const Emitter& emitter = emitters_[size_t(index)];
        const Vec3 point = emitter.p[0] * b.x + emitter.p[1] * b.y + emitter.p[2] * (1 - b.x - b.y);
        const Vec3 d = point - p;
        const float distance = length(d);
        if (!(distance > 0)) return {};
        EmitterHit hit;
        hit.p = point;
        hit.ng = emitter.ng;
        hit.triangle = static_cast<uint32_t>(index);
        LightSample s;
        s.wi = d / distance;
        s.radiance = emitted(hit, -s.wi);
        s.pdf = density(probability, p, s.wi, hit);
        s.distance = distance;
        s.ng = hit.ng;
        if (!(s.pdf > 0) || isBlack(s.radiance)) return {};
        return s;
    }

    std::optional<EmittedRay> emit(const Vec2& uOrigin, const Vec2& uLeaving, const SceneSphere& scene) const override {
        if (!(area_ > 0)) return {};
        const DiscreteSample chosen = triangles_.sampleDiscrete(uOrigin.x);
        const Emitter& emitter = emitters_[size_t(chosen.index)];
        const Vec2 b = sampleUniformTriangle(Vec2(chosen.uRemapped, uOrigin.y));
        const Vec3 p = emitter.p[0] * b.x + emitter.p[1] * b.y + emitter.p[2] * (1 - b.x - b.y);
        auto ray = leave(p, emitter.ng, uLeaving, scene);
        if (ray) ray->triangle = static_cast<uint32_t>(chosen.index);
        return ray;
    }

    Bounds bounds() const override { return reach_.bounds; }
    LightReach reach() const override { return reach_; }

    float pdf(const Vec3& from, const Vec3& wi, const EmitterHit& hit) const override {
        const int index = static_cast<int>(hit.triangle);
        return density(tree_.empty() ? triangles_.probability(index) : tree_.probability(from, index), from, wi, hit);
    }

  private:
    float area() const override { return area_; }

    // A triangle as sampling reads it, all in one place.
    struct Emitter {
        Vec3 p[3];
        Vec3 ng;
        float area;
    };

    // Per solid angle, of a triangle that is chosen with the given probability.
    float density(float probability, const Vec3& from, const Vec3& wi, const EmitterHit& hit) const {
        const float r = probability * lengthSquared(hit.p - from) / (absDot(hit.ng, wi) * emitters_[hit.triangle].area);
        return std::isfinite(r) ? r : 0;
    }

    void findReach(const std::vector<LightReach>& reaches) {
        bool any = false;
        for (const LightReach& r : reaches) {
            if (!(r.intensity > 0)) continue;
            reach_ = any ? merged(reach_, r) : r;
            any = true;
        }
        // A closed surface is not as bright as all its parts would be if they faced one way: at least as on average
        // over all directions.
        const float average = luminance(power(0)) / (4 * kPi);
        reach_.intensity = 0;
        for (const LightReach& r : reaches) {
            const float cosine = dot(r.axis, reach_.axis);
            reach_.intensity += r.intensity * (twoSided_ ? std::abs(cosine) : std::max(0.f, cosine));
        }
        reach_.intensity = std::max(reach_.intensity, average);
    }

    std::vector<Emitter> emitters_;
    Distribution1D triangles_;  // by area
    LightTree tree_;            // over the triangles; empty where they are few
    float area_ = 0;
    LightReach reach_;
};

}  // namespace

std::shared_ptr<const AreaLight> makeMeshAreaLight(const TriangleMesh& mesh, const Rgb& radiance, bool twoSided) {
    return std::make_shared<MeshAreaLight>(mesh, radiance, twoSided);
}

}  // namespace drc
