// Randomly placed dots (pbrt's "dots"; PBR 3e, section 10.6.2).
#pragma once
#include "scene/textures/texture_mapping.h"

namespace drc {

// Each square of unit side in the mapping's (s, t) contains one dot or none. Neither texture may be null; pbrt's
// defaults are inside = 1, outside = 0. T: float or Rgb.
template <typename T>
std::shared_ptr<const Texture<T>> makeDotsTexture(std::shared_ptr<const Texture<T>> inside,
                                                  std::shared_ptr<const Texture<T>> outside, const Mapping2D& mapping);
extern template FloatTexturePtr makeDotsTexture<float>(FloatTexturePtr, FloatTexturePtr, const Mapping2D&);
extern template RgbTexturePtr makeDotsTexture<Rgb>(RgbTexturePtr, RgbTexturePtr, const Mapping2D&);

}  // namespace drc
