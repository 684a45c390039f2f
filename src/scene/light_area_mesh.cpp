// Diffuse area light over a triangle mesh: one light for all its triangles (PBR 3e, sections 12.5 and 14.2.3).
#include "math/distribution.h"
#include "math/warp.h"
#include "scene/light.h"

namespace drc {
namespace {

class MeshAreaLight final : public AreaLight {
  public:
    MeshAreaLight(const TriangleMesh& mesh, const Rgb& radiance, bool twoSided)
        : radiance_(radiance), twoSided_(twoSided) {
        std::vector<float> areas(mesh.triangleCount());
        emitters_.resize(mesh.triangleCount());
        for (uint32_t i = 0; i < mesh.triangleCount(); ++i) {
            areas[i] = mesh.area(i);
            for (uint32_t k = 0; k < 3; ++k) emitters_[i].p[k] = mesh.positions[mesh.indices[3 * size_t(i) + k]];
            emitters_[i].ng = mesh.geometricNormal(i);
        }
        // Not an alias table: the order of u is kept, and with it the stratification of the samples.
        triangles_ = Distribution1D(areas);
        area_ = static_cast<float>(triangles_.integral() * static_cast<double>(areas.size()));
        for (const uint32_t v : mesh.indices) bounds_.extend(mesh.positions[v]);
    }

    std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const override {
        if (!(area_ > 0)) return {};
        const DiscreteSample chosen = triangles_.sampleDiscrete(u.x);
        const Vec2 b = sampleUniformTriangle(Vec2(chosen.uRemapped, u.y));
        const Emitter& emitter = emitters_[size_t(chosen.index)];
        const Vec3 point = emitter.p[0] * b.x + emitter.p[1] * b.y + emitter.p[2] * (1 - b.x - b.y);
        const Vec3 d = point - p;
        const float distance = length(d);
        if (!(distance > 0)) return {};
        EmitterHit hit;
        hit.p = point;
        hit.ng = emitter.ng;
        hit.triangle = static_cast<uint32_t>(chosen.index);
        LightSample s;
        s.wi = d / distance;
        s.radiance = emitted(hit, -s.wi);
        s.pdf = pdf(p, s.wi, hit);
        s.distance = distance;
        if (!(s.pdf > 0) || isBlack(s.radiance)) return {};
        return s;
    }

    Rgb power(float) const override { return radiance_ * ((twoSided_ ? 2 : 1) * area_ * kPi); }
    Bounds bounds() const override { return bounds_; }

    Rgb emitted(const EmitterHit& hit, const Vec3& wo) const override {
        return twoSided_ || dot(hit.ng, wo) > 0 ? radiance_ : Rgb(0.f);
    }

    float pdf(const Vec3& from, const Vec3& wi, const EmitterHit& hit) const override {
        const float r = lengthSquared(hit.p - from) / (absDot(hit.ng, wi) * area_);
        return std::isfinite(r) ? r : 0;
    }

  private:
    // A triangle as sampling reads it, all in one place.
    struct Emitter {
        Vec3 p[3];
        Vec3 ng;
    };
    std::vector<Emitter> emitters_;
    Rgb radiance_;
    bool twoSided_;
    Distribution1D triangles_;  // by area
    float area_ = 0;
    Bounds bounds_;
};

}  // namespace

std::shared_ptr<const AreaLight> makeMeshAreaLight(const TriangleMesh& mesh, const Rgb& radiance, bool twoSided) {
    return std::make_shared<MeshAreaLight>(mesh, radiance, twoSided);
}

}  // namespace drc
