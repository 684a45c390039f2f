// An image at all its resolutions, for textures that are filtered by trilinear interpolation (PBR 3e, section 10.4.3),
// over an ellipse by several of them.
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
    // The filter is the ellipse with these axes (conjugate diameters, in the same units). As many trilinear lookups as
    // it is longer than wide lie in a row along it (McCormack et al., "Feline: Fast Elliptical Lines for Anisotropic
    // Texture Mapping", SIGGRAPH 1999): where it is round, which it mostly is, this costs what one lookup does, and not
    // the dozens of texels of an elliptically weighted average. maxAnisotropy: a longer ellipse is widened.
    T lookup(const Vec2& st, const Vec2& axis0, const Vec2& axis1, float maxAnisotropy, ImageWrap wrap) const;

  private:
    struct Level;
    T trilinear(const Vec2& st, float level, ImageWrap wrap) const;
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
