// Point light whose intensity by direction is a picture: a goniophotometric diagram (PBR 3e, section 12.3.3). As in
// pbrt the picture's pole is the light's +y: v = theta / pi from +y, u = phi / 2 pi from +x towards +z.
#include "scene/light.h"
#include "scene/turn.h"

namespace drc {
namespace {

class GoniometricLight final : public Light {
  public:
    GoniometricLight(const Transform& lightToWorld, const Rgb& intensity, LightImage image)
        : position_(lightToWorld.point(Vec3(0, 0, 0))),
          worldToLight_(lightToWorld.inverse()),
          intensity_(intensity),
          image_(std::move(image)) {
        if (image_.empty()) image_ = {1, 1, {Rgb(1.f)}};
        image_.mend();
        double sum[3] = {0, 0, 0};
        for (int y = 0; y < image_.height; ++y) {
            const double top = std::numbers::pi * y / image_.height,
                         bottom = std::numbers::pi * (y + 1) / image_.height;
            const double solidAngle = 2 * std::numbers::pi * (std::cos(top) - std::cos(bottom)) / image_.width;
            for (int x = 0; x < image_.width; ++x)
                for (int c = 0; c < 3; ++c) sum[c] += solidAngle * double(image_.at(x, y)[c]);
        }
        power_ = intensity_ * Rgb(float(sum[0]), float(sum[1]), float(sum[2]));
    }

    std::optional<LightSample> sample(const Vec3& p, const Vec2&) const override {
        const Vec3 d = position_ - p;
        const float distance2 = lengthSquared(d);
        if (!(distance2 > 0)) return {};
        const Rgb intensity = intensity_ * towards(worldToLight_(-d));
        if (isBlack(intensity)) return {};
        const float distance = std::sqrt(distance2);
        return LightSample{d / distance, intensity / distance2, 1, distance, true};
    }
    Rgb power(float) const override { return power_; }
    bool isDelta() const override { return true; }
    Bounds bounds() const override { return {position_, position_}; }

  private:
    Rgb towards(const Vec3& w) const {
        float phi = std::atan2(w.z, w.x);
        if (phi < 0) phi += 2 * kPi;
        const float theta = std::atan2(std::sqrt(w.x * w.x + w.z * w.z), w.y);
        return image_.lookup(Vec2(phi * (0.5f * kInvPi), theta * kInvPi), true);
    }

    Vec3 position_;
    Turn worldToLight_;
    Rgb intensity_;  // W / sr, where the picture is one
    LightImage image_;
    Rgb power_;
};

}  // namespace

LightPtr makeGoniometricLight(const Transform& lightToWorld, const Rgb& intensity, LightImage image) {
    return std::make_shared<GoniometricLight>(lightToWorld, intensity, std::move(image));
}

}  // namespace drc
