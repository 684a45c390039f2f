// An image texture (pbrt's "imagemap"; PBR 3e, section 10.4).
#pragma once
#include "scene/textures/mip_pyramid.h"
#include "scene/textures/texture_mapping.h"

namespace drc {

struct ImageMapParams {
    Mapping2D mapping;
    ImageWrap wrap = ImageWrap::Repeat;
    float scale = 1;  // multiplies the decoded values
    // Isotropic filtering over twice the footprint's longest extent, instead of over the footprint's ellipse.
    bool trilinear = false;
    float maxAnisotropy = 8;  // largest ratio of the ellipse's axes
};

// Any number of textures may share the pyramid.
RgbTexturePtr makeImageMap(std::shared_ptr<const RgbPyramid> pyramid, const ImageMapParams& params);
FloatTexturePtr makeImageMap(std::shared_ptr<const FloatPyramid> pyramid, const ImageMapParams& params);

}  // namespace drc
