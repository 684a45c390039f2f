// Diffuse area light over a shape that is not made of triangles (PBR 3e, sections 12.5 and 14.2.2).
#include "scene/light.h"

namespace drc {
namespace {

class ShapeAreaLight final : public AreaLight {
  public:
    ShapeAreaLight(ShapePtr shape, const Rgb& radiance, bool twoSided)
        : AreaLight(radiance, twoSided), shape_(std::move(shape)), area_(shape_->area()) {}

    std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const override {
        const ShapeSample point = shape_->sampleFrom(p, u);
        const Vec3 d = point.p - p;
        const float distance = length(d);
        if (!(distance > 0) || !(point.pdf > 0)) return {};
        EmitterHit hit;
        hit.p = point.p;
        hit.ng = point.ng;
        LightSample s;
        s.wi = d / distance;
        s.radiance = emitted(hit, -s.wi);
        s.pdf = point.pdf;
        s.distance = distance;
        s.ng = hit.ng;
        if (isBlack(s.radiance)) return {};
        return s;
    }

    std::optional<EmittedRay> emit(const Vec2& uOrigin, const Vec2& uLeaving, const SceneSphere& scene) const override {
        if (!(area_ > 0)) return {};
        const ShapeSample point = shape_->sample(uOrigin);
        return leave(point.p, point.ng, uLeaving, scene);
    }

    Bounds bounds() const override { return shape_->bounds(); }

    float pdf(const Vec3& from, const Vec3& wi, const EmitterHit& hit) const override {
        return shape_->pdfFrom(from, wi, {hit.p, hit.ng, hit.uv, hit.triangle});
    }

  private:
    float area() const override { return area_; }

    ShapePtr shape_;
    float area_;  // computed here, because curves allocate a table for it, and an error can still name the place in the
                  // file
};

}  // namespace

std::shared_ptr<const AreaLight> makeShapeAreaLight(ShapePtr shape, const Rgb& radiance, bool twoSided) {
    return std::make_shared<ShapeAreaLight>(std::move(shape), radiance, twoSided);
}

}  // namespace drc
