// Bilinear interpolation between the values at the corners of the unit square (pbrt's "bilerp"; PBR 3e, section
// 10.3.4).
#pragma once
#include "scene/textures/texture_mapping.h"

namespace drc {

// v01 is the value at s = 0, t = 1. pbrt's defaults are 0 at t = 0 and 1 at t = 1. T: float or Rgb.
template <typename T>
struct BilerpCorners {
    T v00, v01, v10, v11;
};
template <typename T>
std::shared_ptr<const Texture<T>> makeBilerpTexture(const BilerpCorners<T>& corners, const Mapping2D& mapping);
extern template FloatTexturePtr makeBilerpTexture<float>(const BilerpCorners<float>&, const Mapping2D&);
extern template RgbTexturePtr makeBilerpTexture<Rgb>(const BilerpCorners<Rgb>&, const Mapping2D&);

}  // namespace drc
