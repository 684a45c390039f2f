// Pixel reconstruction filters (PBR 3e, section 7.8), applied by filter importance sampling: camera samples are placed
// around the pixel's centre with a density proportional to |filter| and weighted by the filter's sign (Ernst et al.
// 2006). Which of a pixel's samples lie in negative lobes is not left to chance: they come at regular intervals, not
// before the ninth sample, so that the weights of a pixel's samples never sum to nearly zero.
#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "math/vec.h"

namespace drc {

struct FilterSample {
    Vec2 offset;       // from the pixel's centre, in pixels
    float weight = 1;  // f / pdf: of the same magnitude for all samples, with the sign of f; its mean is 1
};

class Filter {
  public:
    virtual ~Filter() = default;
    virtual Vec2 radius() const = 0;
    virtual float eval(const Vec2& offset) const = 0;
    // The position of a pixel's sample number `index`. pixel: any number that all samples of a pixel share; pixels have
    // their negative samples at different times.
    virtual FilterSample sample(const Vec2& u, uint32_t index, uint64_t pixel) const = 0;
    // Films keep groups of samples apart, by the sample's number modulo this: each group has its share of those in
    // negative lobes.
    static constexpr uint32_t kGroups = 4;
};

using FilterPtr = std::shared_ptr<const Filter>;

FilterPtr makeBoxFilter(const Vec2& radius);
FilterPtr makeTriangleFilter(const Vec2& radius);
FilterPtr makeGaussianFilter(const Vec2& radius, float alpha);
FilterPtr makeMitchellFilter(const Vec2& radius, float b, float c);
FilterPtr makeSincFilter(const Vec2& radius, float tau);

}  // namespace drc
