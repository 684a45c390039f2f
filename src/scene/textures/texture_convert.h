// Textures derived from a single other texture.
#pragma once
#include "scene/textures/texture.h"

namespace drc {

// max(0, 1 - x), the "invert" of pbrt-v4's image maps. The texture must not be null. T: float or Rgb.
template <typename T>
std::shared_ptr<const Texture<T>> makeInvertedTexture(std::shared_ptr<const Texture<T>> texture);
extern template FloatTexturePtr makeInvertedTexture<float>(FloatTexturePtr);
extern template RgbTexturePtr makeInvertedTexture<Rgb>(RgbTexturePtr);

// Clamps each channel to [0, most], for use as a reflectance. The texture must not be null.
RgbTexturePtr makeClampedTexture(RgbTexturePtr texture, float most);
// A float texture as grey values.
RgbTexturePtr makeGreyTexture(FloatTexturePtr number);
// 1 - share, as grey values, with the share clamped to [0, 1].
RgbTexturePtr makeRemainderTexture(FloatTexturePtr share);

}  // namespace drc
