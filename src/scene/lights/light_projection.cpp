// Projection light: a point light behind an image, like a slide projector (PBR 3e, section 12.3.2). It emits along its
// own +z. The image is on the plane z = 1, and its shorter side spans the field of view. As in pbrt, row 0 is at the
// lowest y.
#include "scene/lights/light_directed_point.h"

namespace drc {
namespace {

class ProjectionLight final : public DirectedPointLight {
  public:
    ProjectionLight(const Transform& lightToWorld, const Rgb& intensity, float fovDegrees, LightImage image)
        : DirectedPointLight(lightToWorld, intensity), image_(std::move(image)) {
        if (image_.empty()) image_ = {1, 1, {Rgb(1.f)}};
        image_.mend();
        const float aspect = float(image_.width) / float(image_.height);
        const float tangent = std::tan(fovDegrees * kPi / 360);
        half_ = Vec2(tangent * std::max(1.f, aspect), tangent * std::max(1.f, 1 / aspect));
        findPower();
    }

    Rgb power(float) const override { return power_; }
    LightReach reach() const override {
        LightReach r{bounds(), axis_};
        const float corner = std::atan(std::sqrt(half_.x * half_.x + half_.y * half_.y));
        r.intensity = luminance(power_) / (2 * kPi * (1 - std::cos(corner)));
        if (worldToLight_.keepsAngles()) {
            r.spread = corner;
            r.falloff = 0;
        }
        return r;
    }

  private:
    float leastCosine() const override { return 1 / std::sqrt(1 + half_.x * half_.x + half_.y * half_.y); }
    Rgb share(const Vec3& w) const override {
        if (!(w.z > 0)) return Rgb(0.f);
        const float x = w.x / (w.z * half_.x), y = w.y / (w.z * half_.y);
        if (!(std::abs(x) <= 1 && std::abs(y) <= 1)) return Rgb(0.f);
        return image_.lookup(Vec2(0.5f * (1 + x), 0.5f * (1 + y)), false);
    }

    // Sum of texels times their solid angles: area on the plane z = 1 times cos^3.
    void findPower() {
        const double dx = 2.0 * half_.x / image_.width, dy = 2.0 * half_.y / image_.height;
        // Subdivided, because a single texel may cover the whole field of view, over which the cosine varies.
        const int fine = std::max(1, 64 / std::min(image_.width, image_.height));
        double sum[3] = {0, 0, 0};
        for (int y = 0; y < image_.height * fine; ++y)
            for (int x = 0; x < image_.width * fine; ++x) {
                const double px = (x + 0.5) / fine * dx - double(half_.x), py = (y + 0.5) / fine * dy - double(half_.y);
                const double cos2 = 1 / (1 + px * px + py * py);
                const double solidAngle = dx * dy / (double(fine) * fine) * cos2 * std::sqrt(cos2);
                for (int c = 0; c < 3; ++c) sum[c] += solidAngle * double(image_.at(x / fine, y / fine)[c]);
            }
        power_ = intensity_ * Rgb(float(sum[0]), float(sum[1]), float(sum[2]));
    }

    LightImage image_;
    Vec2 half_;  // half the image's sides on the plane z = 1
    Rgb power_;
};

}  // namespace

LightPtr makeProjectionLight(const Transform& lightToWorld, const Rgb& intensity, float fovDegrees, LightImage image) {
    return std::make_shared<ProjectionLight>(lightToWorld, intensity, fovDegrees, std::move(image));
}

}  // namespace drc
