// A texture that looks an image up (pbrt's "imagemap"; PBR 3e, section 10.4).
#pragma once
#include "scene/mip_pyramid.h"
#include "scene/texture.h"

namespace drc {

// pbrt's "uv" mapping: (s, t) = (u * uScale + uDelta, v * vScale + vDelta).
struct UvMapping {
    float uScale = 1, vScale = 1;
    float uDelta = 0, vDelta = 0;
    Vec2 apply(const Vec2& uv) const { return Vec2(uv.x * uScale + uDelta, uv.y * vScale + vDelta); }
};

struct ImageMapParams {
    UvMapping mapping;
    ImageWrap wrap = ImageWrap::Repeat;
    float scale = 1;  // multiplies the decoded values
    // pbrt filters by an ellipse unless told "trilinear", which blurs twice as wide. Here both are trilinear, and the
    // flag chooses between these two widths.
    bool trilinear = false;
};

// The pyramid may be shared by any number of textures.
RgbTexturePtr makeImageMap(std::shared_ptr<const RgbPyramid> pyramid, const ImageMapParams& params);
FloatTexturePtr makeImageMap(std::shared_ptr<const FloatPyramid> pyramid, const ImageMapParams& params);

}  // namespace drc
