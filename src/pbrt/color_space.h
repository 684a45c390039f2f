// The RGB colour spaces of pbrt-v4's ColorSpace directive, and their conversion to linear Rec. 709.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "math/vec.h"

namespace drc::pbrt {

class ColorSpace {
  public:
    // "srgb", "rec2020", "aces2065-1" or "dci-p3"; null for any other name.
    static const ColorSpace* named(std::string_view name);
    static const ColorSpace& srgb() { return *named("srgb"); }
    static std::vector<std::string_view> names();

    // Colours outside Rec. 709 are clamped at zero. Light keeps its chromaticity: white is not adapted.
    Rgb light(const Rgb& c) const { return clampNonNegative(mix(light_, c)); }
    // c from 0 to 1. A reflectance keeps its appearance under the colour space's own white, so that white paper stays
    // white, as long as Rec. 709 can show it. For a saturated colour outside Rec. 709, the result is the reflectance
    // for which interreflections between walls add up to the right colour.
    Rgb reflectance(const Rgb& c) const;

  private:
    struct Primaries;
    explicit ColorSpace(const Primaries& primaries);
    static Rgb mix(const Rgb (&primaries)[3], const Rgb& c) {
        return primaries[0] * c.x + primaries[1] * c.y + primaries[2] * c.z;
    }

    Rgb light_[3], reflectance_[3];  // the primaries as linear Rec. 709
};

}  // namespace drc::pbrt
