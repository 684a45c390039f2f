// A distant light with an angular size, as the sun has: a disk of uniform radiance at infinity.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/frame.h"
#include "scene/lights/light.h"

namespace drc {
namespace {

class SunLight final : public Light {
  public:
    SunLight(const Vec3& direction, const Rgb& irradiance, float angle, LightAudience audience)
        : frame_(Frame::fromNormal(normalize(direction))), irradiance_(irradiance), audience_(audience) {
        // In double precision, because 1 - cos(half) is only 1e-5 for the real sun.
        const double half = std::min(double(angle), 180.0) * std::numbers::pi / 360;
        oneMinusCos_ = float(2 * std::pow(std::sin(half / 2), 2));
        radiance_ = irradiance * float(1 / (std::numbers::pi * std::pow(std::sin(half), 2)));
    }

    std::optional<LightSample> sample(const Vec3&, const Vec2& u) const override {
        const float h = u.x * oneMinusCos_, r = safeSqrt(h * (2 - h)), phi = 2 * kPi * u.y;
        LightSample s;
        s.wi = frame_.toWorld(Vec3(r * std::cos(phi), r * std::sin(phi), 1 - h));
        s.pdf = pdf();
        s.distance = kInfinity;
        return s;
    }
    std::optional<EmittedRay> emit(const Vec2& uOrigin, const Vec2& uLeaving, const SceneSphere& scene) const override {
        const Vec3 d = -sample(scene.center, uOrigin)->wi;
        return EmittedRay{
            .p = scene.inFront(d, uLeaving), .d = d, .radiance = radiance_, .density = {pdf(), scene.perFacingArea()}};
    }
    EmissionDensity emissionDensity(const EmitterHit&, const Vec3& d, const SceneSphere& scene) const override {
        return {pdfEscaped(scene.center, -d), scene.perFacingArea()};
    }
    // The flux through the disk that the scene's bounding sphere presents to the light.
    Rgb power(float sceneRadius) const override { return irradiance_ * (kPi * sqr(sceneRadius)); }
    bool isAtInfinity() const override { return true; }
    bool isInfinite() const override { return true; }
    bool surrounds() const override { return false; }
    LightAudience audience() const override { return audience_; }
    Rgb escaped(const Vec3&, const Vec3& wi) const override {
        return heightOf(wi) <= oneMinusCos_ ? radiance_ : Rgb(0.f);
    }
    float pdfEscaped(const Vec3&, const Vec3& wi) const override { return heightOf(wi) <= oneMinusCos_ ? pdf() : 0; }
    Vec2 inverse(const Vec3&, const Vec3& wi) const override {
        const Vec3 w = frame_.toLocal(wi);
        const float turn = std::atan2(w.y, w.x) / (2 * kPi);
        return Vec2(std::min(heightOf(wi) / oneMinusCos_, kOneMinusEpsilon),
                    std::min(turn < 0 ? turn + 1 : turn, kOneMinusEpsilon));
    }

  private:
    // 1 - cos of the angle between wi and the centre of the disk, without cancellation.
    float heightOf(const Vec3& wi) const { return lengthSquared(wi - frame_.n) / 2; }
    float pdf() const { return 1 / (2 * kPi * oneMinusCos_); }

    Frame frame_;  // its normal points to the middle of the disk
    Rgb irradiance_, radiance_;
    float oneMinusCos_;
    LightAudience audience_;
};

}  // namespace

LightPtr makeSunLight(const Vec3& direction, const Rgb& irradiance, float angle, LightAudience audience) {
    return std::make_shared<SunLight>(direction, irradiance, angle, audience);
}

}  // namespace drc
