// Alternating squares or cubes of two textures (pbrt's "checkerboard"; PBR 3e, section 10.5.2).
#pragma once
#include "scene/textures/texture_mapping.h"

namespace drc {

// How 2D squares are filtered. Averaged: both textures are weighted by the share of the footprint that each covers
// (pbrt's aamode "closedform"). Sharp: point sampled ("none").
enum class CheckerboardEdges { Averaged, Sharp };

// The squares have unit sides in the mapping's (s, t), and the one from (0, 0) to (1, 1) shows a. Neither texture may
// be null; pbrt's defaults are a = 1, b = 0. T: float or Rgb.
template <typename T>
std::shared_ptr<const Texture<T>> makeCheckerboardTexture(std::shared_ptr<const Texture<T>> a,
                                                          std::shared_ptr<const Texture<T>> b, const Mapping2D& mapping,
                                                          CheckerboardEdges edges);
// A checkerboard of cubes with unit sides in texture space, always point sampled.
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
