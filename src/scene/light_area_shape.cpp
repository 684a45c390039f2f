// Diffuse area light over a shape that is not made of triangles (PBR 3e, sections 12.5 and 14.2.2).
#include "scene/light.h"

namespace drc {
namespace {

class ShapeAreaLight final : public AreaLight {
  public:
    ShapeAreaLight(ShapePtr shape, const Rgb& radiance, bool twoSided)
        : shape_(std::move(shape)), radiance_(radiance), twoSided_(twoSided), area_(shape_->area()) {}

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
        if (isBlack(s.radiance)) return {};
        return s;
    }

    Rgb power(float) const override { return radiance_ * ((twoSided_ ? 2 : 1) * area_ * kPi); }
    Bounds bounds() const override { return shape_->bounds(); }

    Rgb emitted(const EmitterHit& hit, const Vec3& wo) const override {
        return twoSided_ || dot(hit.ng, wo) > 0 ? radiance_ : Rgb(0.f);
    }

    float pdf(const Vec3& from, const Vec3& wi, const EmitterHit& hit) const override {
        return shape_->pdfFrom(from, wi, {hit.p, hit.ng, hit.uv, hit.triangle});
    }

  private:
    ShapePtr shape_;
    Rgb radiance_;
    bool twoSided_;
    float area_;  // curves make a table to find theirs: here, where whoever has too many can still be told which
};

}  // namespace

std::shared_ptr<const AreaLight> makeShapeAreaLight(ShapePtr shape, const Rgb& radiance, bool twoSided) {
    return std::make_shared<ShapeAreaLight>(std::move(shape), radiance, twoSided);
}

}  // namespace drc
