// Textures made of one other texture.
#pragma once
#include "scene/texture.h"

namespace drc {

// 1 - x, and no less than 0 (the "invert" of pbrt-v4's image maps). Not for null. T: float or Rgb.
template <typename T>
std::shared_ptr<const Texture<T>> makeInvertedTexture(std::shared_ptr<const Texture<T>> texture);
extern template FloatTexturePtr makeInvertedTexture<float>(FloatTexturePtr);
extern template RgbTexturePtr makeInvertedTexture<Rgb>(RgbTexturePtr);

// Numbers as greys.
RgbTexturePtr makeGreyTexture(FloatTexturePtr number);
// What a share leaves to one, as a grey; shares below 0 count as 0, above 1 as 1.
RgbTexturePtr makeRemainderTexture(FloatTexturePtr share);

}  // namespace drc
