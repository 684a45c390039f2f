// An image pyramid for filtered texture lookups: trilinear (PBR 3e, section 10.4.3), or over an ellipse by several
// trilinear lookups.
//
// Texels are stored in the smallest lossless form: if all values of an image are 8-bit values, the finest level is
// stored as bytes and the coarser ones as halves, otherwise all as floats.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/memory_use.h"
#include "image/image.h"

namespace drc {

enum class TexelEncoding {
    Linear,  // the texture's values are those of the image
    Srgb,    // the image is sRGB-encoded and decoded here
};

enum class ImageWrap { Repeat, Black, Clamp };

// If T is float, colours are converted to Rec. 709 luminance.
template <typename T>
class MipPyramid {
  public:
    // An empty pyramid, which must be assigned before any lookup.
    MipPyramid();
    // Builds the pyramid of the colours Image::rgb() on all cores; the result does not depend on the number of cores.
    // Throws Error if the image is empty.
    MipPyramid(const Image& image, TexelEncoding encoding);
    MipPyramid(MipPyramid&& other) noexcept;
    MipPyramid& operator=(MipPyramid&& other) noexcept;
    ~MipPyramid();

    int levels() const;
    int width() const;
    int height() const;
    size_t bytes() const;

    // (s, t) = (0, 0) is the bottom left corner of the image and (1, 1) the top right, as in pbrt. width: width of the
    // filter in units of s and t; 0 selects the finest level.
    T lookup(const Vec2& st, float width, ImageWrap wrap) const;
    // Filters over the ellipse with the conjugate diameters axis0 and axis1, in units of s and t, by a row of trilinear
    // lookups along its major axis; their number is about the ratio of its axes (McCormack et al., "Feline: Fast
    // Elliptical Lines for Anisotropic Texture Mapping", SIGGRAPH 1999). For a round footprint, the most common case,
    // this costs one lookup rather than the dozens of texels of an elliptically weighted average. maxAnisotropy:
    // ellipses with a larger ratio of the axes are widened to this ratio.
    T lookup(const Vec2& st, const Vec2& axis0, const Vec2& axis1, float maxAnisotropy, ImageWrap wrap) const;

  private:
    struct Level;
    T trilinear(const Vec2& st, float level, ImageWrap wrap) const;
    T bilinear(const Level& level, const Vec2& st, ImageWrap wrap) const;

    std::vector<Level> levels_;
    std::vector<float> decode_;  // value of each byte 0 to 255; empty unless the finest level is stored as bytes
    float maxResolutionLog2_ = 0;
    NotedMemory memory_;
};

using FloatPyramid = MipPyramid<float>;
using RgbPyramid = MipPyramid<Rgb>;
extern template class MipPyramid<float>;
extern template class MipPyramid<Rgb>;

// Decodes an sRGB-encoded value in [0, 1]; continued linearly below and by the power law above.
float srgbToLinear(float encoded);

}  // namespace drc
