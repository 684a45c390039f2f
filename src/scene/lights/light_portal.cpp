// An environment whose light enters only through a portal (Bitterli et al., "Portal-Masked Environment Map Sampling",
// EGSR 2015; PBR 4e, section 12.5.3): sample() chooses only directions in which the point sees the environment through
// the portal.
#include "scene/lights/light.h"
#include "scene/lights/portal_directions.h"

namespace drc {

namespace {

class PortalLight final : public Light {
  public:
    PortalLight(LightPtr environment, const Portal& portal)
        : environment_(std::move(environment)),
          tables_(std::make_shared<const RectifiedEnvironment>(*environment_, environment_->mapRows(), portal)),
          portal_(portal),
          directions_(portal, tables_) {}

    std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const override {
        const auto s = directions_.sample(p, u);
        if (!s) return {};
        LightSample r;
        r.wi = s->wi;
        r.pdf = s->pdf;
        r.distance = kInfinity;
        return r;
    }

    std::optional<EmittedRay> emit(const Vec2& uOrigin, const Vec2& uLeaving, const SceneSphere& scene) const override {
        const Distribution2D& entering = tables_->entering();
        const Sample2D s = entering.sample(uOrigin);
        const Portal::Direction from = portal_.directionOf(Vec2((float(s.x) + s.local.x) / float(entering.width()),
                                                                (float(s.y) + s.local.y) / float(entering.height())));
        const Vec3 d = -from.w;
        const Rgb radiance = environment_->escaped(scene.center, from.w);
        const EmissionDensity density = emissionDensity({}, d, scene);
        if (isBlack(radiance) || !(density.origin > 0)) return {};
        // The ray starts outside the scene's bounding sphere, because an object outside the portal may block it.
        const Vec3 on = portal_.pointAt(uLeaving);
        const float back = std::max(0.f, dot(on - scene.center, d) + scene.radius);
        return EmittedRay{.p = on - d * back, .d = d, .radiance = radiance, .density = density};
    }
    EmissionDensity emissionDensity(const EmitterHit&, const Vec3& d, const SceneSphere&) const override {
        const Distribution2D& entering = tables_->entering();
        const auto from = portal_.rectifiedOf(-d);
        if (!from || !(from->solidAngle > 0)) return {};
        const auto cell = [](float x, int cells) { return std::clamp(int(x * float(cells)), 0, cells - 1); };
        return {
            entering.pdf(cell(from->at.x, entering.width()), cell(from->at.y, entering.height())) / from->solidAngle,
            1 / (portal_.area() * from->cosine)};
    }

    // The flux that enters through the portal, as if the portal were an area light.
    Rgb power(float) const override { return tables_->fluxPerArea() * portal_.area(); }
    Bounds bounds() const override { return directions_.reach().bounds; }
    LightReach reach() const override { return directions_.reach(); }

    bool isAtInfinity() const override { return true; }
    bool isInfinite() const override { return true; }
    LightAudience audience() const override { return environment_->audience(); }
    Rgb escaped(const Vec3& from, const Vec3& wi) const override {
        return portal_.isPassed(from, wi) ? environment_->escaped(from, wi) : Rgb(0.f);
    }
    float pdfEscaped(const Vec3& from, const Vec3& wi) const override { return directions_.pdf(from, wi); }
    Vec2 inverse(const Vec3& from, const Vec3& wi) const override { return directions_.inverse(from, wi).u; }
    int mapRows() const override { return environment_->mapRows(); }

  private:
    LightPtr environment_;
    std::shared_ptr<const RectifiedEnvironment> tables_;
    Portal portal_;
    PortalDirections directions_;
};

}  // namespace

LightPtr makePortalLight(LightPtr environment, const std::array<Vec3, 4>& corners) {
    return std::make_shared<PortalLight>(std::move(environment), Portal(corners));
}

}  // namespace drc
