// Diffuse area light over a triangle mesh: one light for all its triangles (PBR 3e, sections 12.5 and 14.2.3).
#include "math/distribution.h"
#include "math/warp.h"
#include "scene/light.h"

namespace drc {
namespace {

class MeshAreaLight final : public AreaLight {
  public:
    MeshAreaLight(TriangleMeshPtr mesh, const Rgb& radiance, bool twoSided)
        : mesh_(std::move(mesh)), radiance_(radiance), twoSided_(twoSided) {
        std::vector<float> areas(mesh_->triangleCount());
        for (uint32_t i = 0; i < mesh_->triangleCount(); ++i) areas[i] = mesh_->area(i);
        // Not an alias table: the order of u is kept, and with it the stratification of the samples.
        triangles_ = Distribution1D(areas);
        area_ = static_cast<float>(triangles_.integral() * static_cast<double>(areas.size()));
        for (const uint32_t v : mesh_->indices) bounds_.extend(mesh_->positions[v]);
    }

    std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const override {
        if (!(area_ > 0)) return {};
        const DiscreteSample chosen = triangles_.sampleDiscrete(u.x);
        const auto triangle = static_cast<uint32_t>(chosen.index);
        const Vec2 b = sampleUniformTriangle(Vec2(chosen.uRemapped, u.y));
        const uint32_t* v = &mesh_->indices[3 * size_t(triangle)];
        const Vec3 point =
            mesh_->positions[v[0]] * b.x + mesh_->positions[v[1]] * b.y + mesh_->positions[v[2]] * (1 - b.x - b.y);
        const Vec3 d = point - p;
        const float distance = length(d);
        if (!(distance > 0)) return {};
        EmitterHit hit;
        hit.p = point;
        hit.ng = mesh_->geometricNormal(triangle);
        hit.triangle = triangle;
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
    TriangleMeshPtr mesh_;
    Rgb radiance_;
    bool twoSided_;
    Distribution1D triangles_;  // by area
    float area_ = 0;
    Bounds bounds_;
};

}  // namespace

std::shared_ptr<const AreaLight> makeMeshAreaLight(TriangleMeshPtr mesh, const Rgb& radiance, bool twoSided) {
    return std::make_shared<MeshAreaLight>(std::move(mesh), radiance, twoSided);
}

}  // namespace drc
