// Pixel reconstruction filters (PBR 3e, section 7.8), applied by filter importance sampling: camera samples are placed
// around the pixel's centre with a density proportional to |filter| and weighted by the filter's sign (Ernst et al.
// 2006). Samples in negative lobes do not occur at random: each pixel has them at regular intervals, and none among its
// first eight samples, so that the sum of a pixel's weights is never nearly zero.
#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "math/vec.h"

namespace drc {

struct FilterSample {
    Vec2 offset;       // from the pixel's centre, in pixels
    float weight = 1;  // f / pdf, with f scaled to integrate to 1: constant magnitude, sign of f, mean 1
};

class Filter {
  public:
    virtual ~Filter() = default;
    virtual Vec2 radius() const = 0;
    virtual float eval(const Vec2& offset) const = 0;
    // The offset and weight of a pixel's sample number `index`. u: uniform in [0, 1)^2. pixel: any number that
    // identifies the pixel; it offsets the indices of negative samples, so that they differ between pixels.
    virtual FilterSample sample(const Vec2& u, uint32_t index, uint64_t pixel) const = 0;
    // Films accumulate samples in this many groups, by the sample's number modulo kGroups. Each group has its own share
    // of the samples in negative lobes.
    static constexpr uint32_t kGroups = 4;
};

using FilterPtr = std::shared_ptr<const Filter>;

FilterPtr makeBoxFilter(const Vec2& radius);
FilterPtr makeTriangleFilter(const Vec2& radius);
FilterPtr makeGaussianFilter(const Vec2& radius, float alpha);
FilterPtr makeMitchellFilter(const Vec2& radius, float b, float c);
FilterPtr makeSincFilter(const Vec2& radius, float tau);

}  // namespace drc
