// The product of two textures (pbrt's "scale"; PBR 3e, section 10.3.2).
#pragma once
#include "scene/textures/texture.h"

namespace drc {

// Neither may be null. T: float or Rgb.
template <typename T>
std::shared_ptr<const Texture<T>> makeScaleTexture(std::shared_ptr<const Texture<T>> a,
                                                   std::shared_ptr<const Texture<T>> b);
extern template FloatTexturePtr makeScaleTexture<float>(FloatTexturePtr, FloatTexturePtr);
extern template RgbTexturePtr makeScaleTexture<Rgb>(RgbTexturePtr, RgbTexturePtr);

}  // namespace drc
