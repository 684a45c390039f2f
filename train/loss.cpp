#include "loss.h"

#include <algorithm>
#include <numbers>

#include "neural/transforms.h"

namespace drc {
namespace {

constexpr int kNormalsAside = 8;
// Added to squared irradiances in the denominator: where the target is dark, errors are relative to a tenth of its
// mean.
constexpr double kEpsilon = 0.01;

}  // namespace

Loss::Loss(const MapLayout& layout, double irradianceWeight)
    : irradianceWeight_(irradianceWeight),
      solidAngles_(torch::empty({layout.texels()})),
      cosines_(torch::empty({layout.texels(), kNormalsAside * kNormalsAside})) {
    const MapLayout normals(Projection::EqualArea, kNormalsAside);
    const Vec2 centre(0.5f, 0.5f);
    for (int i = 0; i < layout.texels(); ++i) {
        const float omega = layout.solidAngle(i / layout.size());
        const Vec3 d = layout.direction(i % layout.size(), i / layout.size(), centre);
        solidAngles_[i] = omega;
        for (int k = 0; k < kNormalsAside * kNormalsAside; ++k) {
            const Vec3 n = normals.direction(k % kNormalsAside, k / kNormalsAside, centre);
            cosines_[i][k] = std::max(0.f, dot(d, n)) * omega / std::numbers::pi_v<float>;
        }
    }
    solidAngles_ /= solidAngles_.sum();
}

torch::Tensor Loss::irradianceErrors(const torch::Tensor& output, const torch::Tensor& target,
                                     const torch::Tensor& factor) const {
    const auto radiance = [&](const torch::Tensor& encoded) {
        return (torch::expm1(encoded.clamp(0, kMaxEncoded)) * factor)
            .contiguous()
            .flatten(2);  // in units of ten times the mean
    };
    const auto mean = [&](const torch::Tensor& maps) { return torch::matmul(maps, solidAngles_).unsqueeze(2); };
    const torch::Tensor t = radiance(target), meanOfTarget = mean(t);
    torch::Tensor r = radiance(output);
    r = r * (meanOfTarget / mean(r).clamp_min(1e-6));
    const torch::Tensor unit = meanOfTarget.mean(1, true).clamp_min(1e-6);
    const torch::Tensor e = torch::matmul(t / unit, cosines_);
    return (torch::matmul(r / unit, cosines_) - e) / torch::sqrt(e.square() + kEpsilon);
}

torch::Tensor Loss::operator()(const torch::Tensor& output, const torch::Tensor& target,
                               const torch::Tensor& factor) const {
    // Relative to the map's own mean factor, so that rooms with dark and with bright surfaces have equal weight.
    const torch::Tensor weight = factor / factor.mean({1, 2, 3}, true);
    const torch::Tensor l1 = ((output - target).abs() * weight).mean();
    if (irradianceWeight_ == 0) return l1;
    return l1 + irradianceWeight_ * irradianceErrors(output, target, factor).abs().mean();
}

}  // namespace drc
