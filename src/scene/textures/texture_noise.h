// Solid textures made of noise (pbrt's "fbm", "wrinkled" and "windy"; PBR 3e, sections 10.6.3 to 10.6.5).
#pragma once
#include "scene/textures/noise.h"
#include "scene/textures/texture_mapping.h"

namespace drc {

// Each of these returns the same number in all channels. T: float or Rgb.
template <typename T>
std::shared_ptr<const Texture<T>> makeFbmTexture(const NoiseSum& sum, const Mapping3D& mapping);
// Turbulence in place of fractional Brownian motion, for bumps with creases.
template <typename T>
std::shared_ptr<const Texture<T>> makeWrinkledTexture(const NoiseSum& sum, const Mapping3D& mapping);
// Waves on water, whose height is modulated by noise of larger scale, like gusts of wind.
template <typename T>
std::shared_ptr<const Texture<T>> makeWindyTexture(const Mapping3D& mapping);

extern template FloatTexturePtr makeFbmTexture<float>(const NoiseSum&, const Mapping3D&);
extern template RgbTexturePtr makeFbmTexture<Rgb>(const NoiseSum&, const Mapping3D&);
extern template FloatTexturePtr makeWrinkledTexture<float>(const NoiseSum&, const Mapping3D&);
extern template RgbTexturePtr makeWrinkledTexture<Rgb>(const NoiseSum&, const Mapping3D&);
extern template FloatTexturePtr makeWindyTexture<float>(const Mapping3D&);
extern template RgbTexturePtr makeWindyTexture<Rgb>(const Mapping3D&);

}  // namespace drc
