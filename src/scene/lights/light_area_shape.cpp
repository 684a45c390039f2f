// Diffuse area light over a shape that is not made of triangles (PBR 3e, sections 12.5 and 14.2.2).
//
// An image on the shape is sampled by a table over its (u, v). Spheres are also sampled by solid angle, without regard
// to the image: each technique makes half of the samples, and the pdf is that of the mixture, so that the second moment
// is at most twice that of the better technique.
#include "scene/lights/emission_grid.h"
#include "scene/lights/light.h"
#include "scene/shapes/quadric_space.h"

namespace drc {
namespace {

constexpr float kShareOfDirections = 0.5f;
// Points along each side of the unit square for the mean of an image over a shape without spotAt(), such as curves.
constexpr int kPointsOfMean = 64;

class ShapeAreaLight final : public AreaLight {
  public:
    ShapeAreaLight(ShapePtr shape, const Emission& emission, bool twoSided)
        : AreaLight(emission, twoSided), shape_(std::move(shape)), area_(shape_->area()) {
        if (const EmissionImage* image = emission_.image())
            placeImage(*image);
        else
            radianceTimesArea_ = emission_.scale() * area_;
    }

    std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const override {
        const auto s = grid_ ? sampleImage(p, u) : sampleShape(p, u);
        if (!s || !(s->pdf > 0) || isBlack(s->radiance)) return {};
        return s;
    }

    std::optional<EmittedRay> emit(const Vec2& uOrigin, const Vec2& uLeaving, const SceneSphere& scene) const override {
        if (!(area_ > 0)) return {};
        if (grid_) {
            const Vec2 uv = grid_->sample(uOrigin).at;
            const auto spot = shape_->spotAt(uv);
            return leave({spot->p, spot->ng, 0, uv}, uLeaving, scene);
        }
        const ShapeSample point = shape_->sample(uOrigin);
        auto ray = leave({point.p, point.ng, point.part, point.uv}, uLeaving, scene);
        if (ray && emission_.image() != nullptr)
            ray->radiance = emitted({point.p, point.ng, point.part, shape_->uvSeenFrom(point, ray->d)}, ray->d);
        return ray;
    }

    // emit() samples curves as exact tubes or ribbons. Rays hit something else: flat curves turn towards each ray, and
    // Embree approximates ribbons by facets.
    bool emitsFromWhereRaysMeetIt() const override { return shape_->asCurves() == nullptr; }
    Bounds bounds() const override { return shape_->bounds(); }
    LightReach reach() const override {
        LightReach r = Light::reach();
        if (const auto* spot = emission_.profile().spot()) {
            r.axis = spot->axis;
            r.narrowTo(spot->falloff);
            r.intensity = luminance(radianceTimesArea_) / 4;
        }
        return r;
    }

    float pdf(const Vec3& from, const Vec3& wi, const EmitterHit& hit) const override {
        const ShapePoint point{hit.p, hit.ng, hit.uv, hit.triangle};
        if (!grid_) return shape_->pdfFrom(from, wi, point);
        const float byImage = toSolidAngle(originPdf(hit), from, hit.p, hit.ng);
        if (!shape_->samplesDirections()) return byImage;
        return lerp(kShareOfDirections, byImage, shape_->pdfFrom(from, wi, point));
    }

  private:
    Rgb radianceTimesArea() const override { return radianceTimesArea_; }

    float originPdf(const EmitterHit& at) const override {
        if (!grid_) return shape_->pdf({at.p, at.ng, at.uv, at.triangle});
        const auto spot = shape_->spotAt(at.uv);
        const float pdf = grid_->density(at.uv) / spot->area;
        return std::isfinite(pdf) ? pdf : 0;
    }

    void placeImage(const EmissionImage& image) {
        Rgb sum(0.f);
        if (shape_->spotAt(Vec2(0, 0))) {
            auto grid = std::make_shared<const EmissionGrid>(image, image.width(), image.height(), [&](const Vec2& uv) {
                return PatchPoint{uv, shape_->spotAt(uv)->area};
            });
            sum = grid->integral();
            if (!grid->isUniform()) grid_ = std::move(grid);
        } else {
            for (int i = 0; i < kPointsOfMean; ++i)
                for (int j = 0; j < kPointsOfMean; ++j)
                    sum += image.lookup(
                        shape_->sample(Vec2((float(i) + 0.5f) / kPointsOfMean, (float(j) + 0.5f) / kPointsOfMean)).uv);
            sum *= area_ / (kPointsOfMean * kPointsOfMean);
        }
        radianceTimesArea_ = emission_.scale() * sum;
    }

    std::optional<LightSample> sampleShape(const Vec3& p, const Vec2& u) const {
        const ShapeSample point = shape_->sampleFrom(p, u);
        return sampleOf(p, {point.p, point.ng, point.part, point.uv}, point.pdf);
    }

    std::optional<LightSample> sampleImage(const Vec3& p, Vec2 u) const {
        if (shape_->samplesDirections()) {
            const bool byDirection = u.x < kShareOfDirections;
            u.x =
                std::min(byDirection ? u.x / kShareOfDirections : (u.x - kShareOfDirections) / (1 - kShareOfDirections),
                         kOneMinusEpsilon);
            if (byDirection) {
                auto s = sampleShape(p, u);
                if (s) s->pdf = pdf(p, s->wi, {p + s->wi * s->distance, s->ng, s->triangle, s->uv});
                return s;
            }
        }
        const EmissionGrid::Sample at = grid_->sample(u);
        const auto spot = shape_->spotAt(at.at);
        const EmitterHit hit{spot->p, spot->ng, 0, at.at};
        auto s = sampleOf(p, hit, 0);
        if (s) s->pdf = pdf(p, s->wi, hit);
        return s;
    }

    std::optional<LightSample> sampleOf(const Vec3& p, const EmitterHit& hit, float pdf) const {
        const Vec3 d = hit.p - p;
        const float distance = length(d);
        if (!(distance > 0)) return {};
        LightSample s;
        s.wi = d / distance;
        s.radiance = emitted(hit, -s.wi);
        s.pdf = pdf;
        s.distance = distance;
        s.ng = hit.ng;
        s.triangle = hit.triangle;
        s.uv = hit.uv;
        return s;
    }

    ShapePtr shape_;
    // Computed by the constructor: curves allocate a table for it, and an error can still name the place in the file.
    float area_;
    std::shared_ptr<const EmissionGrid> grid_;  // over (u, v); null if no image guides the sampling
    Rgb radianceTimesArea_;
};

}  // namespace

std::shared_ptr<const AreaLight> makeShapeAreaLight(ShapePtr shape, const Emission& emission, bool twoSided) {
    return std::make_shared<ShapeAreaLight>(std::move(shape), emission, twoSided);
}

}  // namespace drc
