#include "maps/map_denoiser.h"

#include <cmath>

namespace drc {
namespace {

class IdentityMapDenoiser final : public MapDenoiser {
  public:
    void denoise(std::span<CapturedMap>, const MapLayout&) const override {}
    std::string name() const override { return "none"; }
};

class GaussianMapDenoiser final : public MapDenoiser {
  public:
    explicit GaussianMapDenoiser(float sigma) : radius_(int(std::ceil(3 * sigma))) {
        for (int i = -radius_; i <= radius_; ++i) kernel_.push_back(std::exp(-0.5f * sqr(float(i) / sigma)));
        float sum = 0;
        for (const float k : kernel_) sum += k;
        for (float& k : kernel_) k /= sum;
    }

    void denoise(std::span<CapturedMap> maps, const MapLayout& layout) const override {
        const int n = layout.size();
        const auto texels = size_t(layout.texels());
        std::vector<float> captured, rows(texels);
        for (CapturedMap& map : maps) {
            captured = map.radiance;
            for (size_t c = 0; c < 3; ++c) {
                float* plane = map.radiance.data() + c * texels;
                blur(plane, rows.data(), n, 1, n);
                blur(rows.data(), plane, n, n, 1);
            }
            matchEnergy(captured, layout, map.radiance);
        }
    }
    std::string name() const override { return "gaussian"; }

  private:
    // Blurs along one axis. step: offset between neighbours on a line; stride: offset between lines. Texels at the edge
    // are repeated beyond it.
    void blur(const float* in, float* out, int n, int step, int stride) const {
        for (int line = 0; line < n; ++line)
            for (int i = 0; i < n; ++i) {
                float sum = 0;
                for (int k = -radius_; k <= radius_; ++k)
                    sum += kernel_[size_t(k + radius_)] * in[line * stride + std::clamp(i + k, 0, n - 1) * step];
                out[line * stride + i * step] = sum;
            }
    }

    int radius_;
    std::vector<float> kernel_;
};

}  // namespace

std::unique_ptr<MapDenoiser> makeIdentityMapDenoiser() { return std::make_unique<IdentityMapDenoiser>(); }
std::unique_ptr<MapDenoiser> makeGaussianMapDenoiser(float sigma) {
    return std::make_unique<GaussianMapDenoiser>(sigma);
}

void matchEnergy(std::span<const float> captured, const MapLayout& layout, std::span<float> radiance) {
    const int n = layout.size();
    const auto texels = size_t(layout.texels());
    const auto mean = [&](std::span<const float> channel) {
        double sum = 0, all = 0;
        for (int row = 0; row < n; ++row) {
            const double w = layout.solidAngle(row);
            for (int column = 0; column < n; ++column) sum += w * channel[size_t(row * n + column)];
            all += w * n;
        }
        return sum / all;
    };
    for (size_t c = 0; c < 3; ++c) {
        const std::span<float> channel = radiance.subspan(c * texels, texels);
        const double want = mean(captured.subspan(c * texels, texels)), have = mean(channel);
        // NaN counts as no light: it fails `have > 0`.
        const bool usable = have > 0 && std::isfinite(have);
        if (usable && want <= kMostGain * have) {
            const auto scale = float(want / have);
            for (float& r : channel) r *= scale;
        } else {
            const float gain = usable ? kMostGain : 0.f;
            const auto rest = float(want - (usable ? double(gain) * have : 0.));
            for (float& r : channel) r = (usable ? gain * r : 0.f) + rest;
        }
    }
}

}  // namespace drc
