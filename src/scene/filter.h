// Pixel reconstruction filters (PBR 3e, section 7.8), applied by filter importance sampling: camera samples are placed
// around the pixel's centre with a density proportional to |filter| and weighted by the filter's sign (Ernst et al.
// 2006).
#pragma once
#include <memory>
#include <string>

#include "math/vec.h"

namespace drc {

struct FilterSample {
    Vec2 offset;       // from the pixel's centre, in pixels
    float weight = 1;  // f / pdf; its mean is 1
};

class Filter {
  public:
    virtual ~Filter() = default;
    virtual Vec2 radius() const = 0;
    virtual float eval(const Vec2& offset) const = 0;
    virtual FilterSample sample(const Vec2& u) const = 0;
};

using FilterPtr = std::shared_ptr<const Filter>;

FilterPtr makeBoxFilter(const Vec2& radius);
FilterPtr makeTriangleFilter(const Vec2& radius);
FilterPtr makeGaussianFilter(const Vec2& radius, float alpha);
FilterPtr makeMitchellFilter(const Vec2& radius, float b, float c);
FilterPtr makeSincFilter(const Vec2& radius, float tau);

}  // namespace drc
