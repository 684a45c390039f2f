#include "scene/textures/texture_noise.h"

namespace drc {
namespace {

float fbmAt(const SolidPoint& at, const NoiseSum& sum) { return fbm(at.p, at.dpdx, at.dpdy, sum); }

float wrinklesAt(const SolidPoint& at, const NoiseSum& sum) { return turbulence(at.p, at.dpdx, at.dpdy, sum); }

float wavesAt(const SolidPoint& at, const NoiseSum& waves) {
    // Gusts are ten times as large as waves.
    const float wind = fbm(at.p * 0.1f, at.dpdx * 0.1f, at.dpdy * 0.1f, {3, 0.5f});
    return std::abs(wind) * fbm(at.p, at.dpdx, at.dpdy, waves);
}

template <typename T, float (*valueAt)(const SolidPoint&, const NoiseSum&)>
class NoiseTexture final : public Texture<T> {
  public:
    NoiseTexture(const NoiseSum& sum, const Mapping3D& mapping) : sum_(sum), mapping_(mapping) {}
    T eval(const TextureContext& at) const override { return T(valueAt(mapping_.at(at), sum_)); }

  private:
    NoiseSum sum_;
    Mapping3D mapping_;
};

}  // namespace

template <typename T>
std::shared_ptr<const Texture<T>> makeFbmTexture(const NoiseSum& sum, const Mapping3D& mapping) {
    return std::make_shared<NoiseTexture<T, fbmAt>>(sum, mapping);
}
template <typename T>
std::shared_ptr<const Texture<T>> makeWrinkledTexture(const NoiseSum& sum, const Mapping3D& mapping) {
    return std::make_shared<NoiseTexture<T, wrinklesAt>>(sum, mapping);
}
template <typename T>
std::shared_ptr<const Texture<T>> makeWindyTexture(const Mapping3D& mapping) {
    return std::make_shared<NoiseTexture<T, wavesAt>>(NoiseSum{6, 0.5f}, mapping);
}
template FloatTexturePtr makeFbmTexture<float>(const NoiseSum&, const Mapping3D&);
template RgbTexturePtr makeFbmTexture<Rgb>(const NoiseSum&, const Mapping3D&);
template FloatTexturePtr makeWrinkledTexture<float>(const NoiseSum&, const Mapping3D&);
template RgbTexturePtr makeWrinkledTexture<Rgb>(const NoiseSum&, const Mapping3D&);
template FloatTexturePtr makeWindyTexture<float>(const Mapping3D&);
template RgbTexturePtr makeWindyTexture<Rgb>(const Mapping3D&);

}  // namespace drc
