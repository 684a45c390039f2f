// A texture that looks an image up (pbrt's "imagemap"; PBR 3e, section 10.4).
#pragma once
#include "scene/mip_pyramid.h"
#include "scene/texture_mapping.h"

namespace drc {

struct ImageMapParams {
    Mapping2D mapping;
    ImageWrap wrap = ImageWrap::Repeat;
    float scale = 1;  // multiplies the decoded values
    // Filter over a square as wide as twice the footprint's longest extent, instead of over the footprint's ellipse.
    bool trilinear = false;
    float maxAnisotropy = 8;  // how much longer than wide that ellipse may be
};

// The pyramid may be shared by any number of textures.
RgbTexturePtr makeImageMap(std::shared_ptr<const RgbPyramid> pyramid, const ImageMapParams& params);
FloatTexturePtr makeImageMap(std::shared_ptr<const FloatPyramid> pyramid, const ImageMapParams& params);

}  // namespace drc
