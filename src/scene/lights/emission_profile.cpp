#include "scene/lights/emission_profile.h"

#include <algorithm>

namespace drc {

EmissionProfile EmissionProfile::narrowed(float degrees) {
    EmissionProfile p;
    if (degrees >= 180) return p;
    const double half = double(degrees) * double(kPi) / 360, tangent = std::tan(half);
    p.tanHalf_ = float(tangent);
    // The integral over the cone of the cosine times 1 - tan(t) / tan(half) is pi (1 - half / tan(half)), where all
    // directions together have pi. For small angles the difference is that of the tangent's series.
    const double excess = half < 1e-3 ? half * half * half / 3 : tangent - half;
    p.scale_ = float(1 / excess);
    p.sinReach_ = float(std::sin(half));
    return p;
}

}  // namespace drc
