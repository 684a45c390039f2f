// Squares of two textures in turn, over (u, v) and without antialiasing (pbrt's "checkerboard" of dimension 2 with
// aamode "none"; PBR 3e, section 10.5.2).
#pragma once
#include "scene/texture.h"
#include "scene/texture_imagemap.h"

namespace drc {

// Squares are of unit side in the mapping's (s, t); the one at (0, 0) to (1, 1) shows a. Neither may be null; pbrt's
// defaults are a = 1, b = 0. T: float or Rgb.
template <typename T>
std::shared_ptr<const Texture<T>> makeCheckerboardTexture(std::shared_ptr<const Texture<T>> a,
                                                          std::shared_ptr<const Texture<T>> b,
                                                          const UvMapping& mapping);
extern template FloatTexturePtr makeCheckerboardTexture<float>(FloatTexturePtr, FloatTexturePtr, const UvMapping&);
extern template RgbTexturePtr makeCheckerboardTexture<Rgb>(RgbTexturePtr, RgbTexturePtr, const UvMapping&);

}  // namespace drc
