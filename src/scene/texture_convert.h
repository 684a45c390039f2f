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

}  // namespace drc
