// Point light whose intensity is given by an image of all directions, a goniophotometric diagram (PBR 3e,
// section 12.3.3). As in pbrt, its pole is +y: v = theta / pi from +y, u = phi / 2 pi from +x towards +z.
#include "scene/lights/light_directed_point.h"

namespace drc {
namespace {

class GoniometricLight final : public DirectedPointLight {
  public:
    GoniometricLight(const Transform& lightToWorld, const Rgb& intensity, LightImage image)
        : DirectedPointLight(lightToWorld, intensity), image_(std::move(image)) {
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

    Rgb power(float) const override { return power_; }

  private:
    Rgb share(const Vec3& w) const override {
        float phi = std::atan2(w.z, w.x);
        if (phi < 0) phi += 2 * kPi;
        const float theta = std::atan2(std::sqrt(w.x * w.x + w.z * w.z), w.y);
        return image_.lookup(Vec2(phi * (0.5f * kInvPi), theta * kInvPi), true);
    }

    LightImage image_;
    Rgb power_;
};

}  // namespace

LightPtr makeGoniometricLight(const Transform& lightToWorld, const Rgb& intensity, LightImage image) {
    return std::make_shared<GoniometricLight>(lightToWorld, intensity, std::move(image));
}

}  // namespace drc
