// A blend of two textures (pbrt's "mix"; PBR 3e, section 10.3.3).
#pragma once
#include "scene/textures/texture.h"

namespace drc {

// (1 - amount) a + amount b. A mix of materials, in contrast, weights its first material by the amount. No argument may
// be null. T: float or Rgb.
template <typename T>
std::shared_ptr<const Texture<T>> makeMixTexture(std::shared_ptr<const Texture<T>> a,
                                                 std::shared_ptr<const Texture<T>> b, FloatTexturePtr amount);
extern template FloatTexturePtr makeMixTexture<float>(FloatTexturePtr, FloatTexturePtr, FloatTexturePtr);
extern template RgbTexturePtr makeMixTexture<Rgb>(RgbTexturePtr, RgbTexturePtr, FloatTexturePtr);

}  // namespace drc
