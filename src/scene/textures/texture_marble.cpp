#include "scene/textures/texture_marble.h"

#include <array>

namespace drc {
namespace {

// The colours across the layers: white stone with a grey and a blue vein (values from PBR 3e).
const std::array<Rgb, 9> kColors = {Rgb(0.58f, 0.58f, 0.6f), Rgb(0.58f, 0.58f, 0.6f), Rgb(0.58f, 0.58f, 0.6f),
                                    Rgb(0.5f, 0.5f, 0.5f),   Rgb(0.6f, 0.59f, 0.58f), Rgb(0.58f, 0.58f, 0.6f),
                                    Rgb(0.58f, 0.58f, 0.6f), Rgb(0.2f, 0.2f, 0.33f),  Rgb(0.58f, 0.58f, 0.6f)};
constexpr int kSegments = int(kColors.size()) - 3;
constexpr float kContrast = 1.5f;

// Piecewise cubic Bezier curves over four consecutive colours each, by de Casteljau's algorithm. t in [0, 1].
Rgb colorAt(float t) {
    // The book's program clamps the index of the segment to at least one, which extrapolates the curve over most of [0,
    // 1]. The intended bound keeps the index within the table.
    const int first = std::clamp(static_cast<int>(t * kSegments), 0, kSegments - 1);
    const float x = t * kSegments - float(first);
    std::array<Rgb, 4> c;
    for (size_t i = 0; i < 4; ++i) c[i] = kColors[size_t(first) + i];
    for (size_t left = 3; left > 0; --left)
        for (size_t i = 0; i < left; ++i) c[i] = lerp(x, c[i], c[i + 1]);
    return c[0] * kContrast;
}

class Marble final : public RgbTexture {
  public:
    Marble(const MarbleParams& params, const Mapping3D& mapping) : params_(params), mapping_(mapping) {}
    Rgb eval(const TextureContext& at) const override {
        const SolidPoint point = mapping_.at(at);
        const float k = params_.scale;
        const float layer =
            k * point.p.y + params_.variation * fbm(point.p * k, point.dpdx * k, point.dpdy * k, params_.noise);
        return std::isfinite(layer) ? colorAt(0.5f + 0.5f * std::sin(layer)) : colorAt(0);
    }

  private:
    MarbleParams params_;
    Mapping3D mapping_;
};

}  // namespace

RgbTexturePtr makeMarbleTexture(const MarbleParams& params, const Mapping3D& mapping) {
    return std::make_shared<Marble>(params, mapping);
}

}  // namespace drc
