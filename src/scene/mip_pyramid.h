// An image at all its resolutions, for textures that are filtered by trilinear interpolation (PBR 3e, section 10.4.3).
//
// Texels are kept as small as they can be without harm: an image whose values all come from 8 bits is kept as bytes
// and its coarser levels as halves, any other as floats.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "math/vec.h"

namespace drc {

// A decoded image, row-major, row 0 at the top.
struct TexelImage {
    int width = 0, height = 0;
    std::vector<Rgb> texels;
};

enum class TexelEncoding {
    Linear,  // the image's values are what the texture gives
    Srgb,    // the image's values are sRGB-encoded and decoded here
};

enum class ImageWrap { Repeat, Black, Clamp };

// Rec. 709 luminance stands for an image's colour where T is float.
template <typename T>
class MipPyramid {
  public:
    // Throws Error if the image is empty or its size is not that of its texels.
    MipPyramid(const TexelImage& image, TexelEncoding encoding);
    ~MipPyramid();

    int levels() const;
    int width() const;
    int height() const;
    size_t bytes() const;

    // (s, t) = (0, 0) is the image's bottom left corner and (1, 1) its top right one, as in pbrt. width: of the filter,
    // in the same units; 0: the finest level.
    T lookup(const Vec2& st, float width, ImageWrap wrap) const;

  private:
    struct Level;
    T bilinear(const Level& level, const Vec2& st, ImageWrap wrap) const;

    std::vector<Level> levels_;
    std::vector<float> decode_;  // the values of the 256 bytes; empty unless the finest level is bytes
    float maxResolutionLog2_ = 0;
};

using FloatPyramid = MipPyramid<float>;
using RgbPyramid = MipPyramid<Rgb>;
extern template class MipPyramid<float>;
extern template class MipPyramid<Rgb>;

// Value in [0, 1] of an sRGB-encoded value; continued linearly or by the power beyond.
float srgbToLinear(float encoded);

}  // namespace drc
