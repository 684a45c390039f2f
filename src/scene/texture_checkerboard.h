// Squares or cubes of two textures in turn (pbrt's "checkerboard"; PBR 3e, section 10.5.2).
#pragma once
#include "scene/texture_mapping.h"

namespace drc {

// How the edges of 2D squares look where they are smaller than the footprint: both textures by the share of it that
// each covers (pbrt's aamode "closedform"), or whichever is at the point itself ("none").
enum class CheckerboardEdges { Averaged, Sharp };

// Squares are of unit side in the mapping's (s, t); the one at (0, 0) to (1, 1) shows a. Neither may be null; pbrt's
// defaults are a = 1, b = 0. T: float or Rgb.
template <typename T>
std::shared_ptr<const Texture<T>> makeCheckerboardTexture(std::shared_ptr<const Texture<T>> a,
                                                          std::shared_ptr<const Texture<T>> b, const Mapping2D& mapping,
                                                          CheckerboardEdges edges);
// The same with cubes of unit side in the texture's space, always with sharp edges.
template <typename T>
std::shared_ptr<const Texture<T>> makeSolidCheckerboardTexture(std::shared_ptr<const Texture<T>> a,
                                                               std::shared_ptr<const Texture<T>> b,
                                                               const Mapping3D& mapping);
extern template FloatTexturePtr makeCheckerboardTexture<float>(FloatTexturePtr, FloatTexturePtr, const Mapping2D&,
                                                               CheckerboardEdges);
extern template RgbTexturePtr makeCheckerboardTexture<Rgb>(RgbTexturePtr, RgbTexturePtr, const Mapping2D&,
                                                           CheckerboardEdges);
extern template FloatTexturePtr makeSolidCheckerboardTexture<float>(FloatTexturePtr, FloatTexturePtr, const Mapping3D&);
extern template RgbTexturePtr makeSolidCheckerboardTexture<Rgb>(RgbTexturePtr, RgbTexturePtr, const Mapping3D&);

}  // namespace drc
