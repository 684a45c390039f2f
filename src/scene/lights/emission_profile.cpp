#include "scene/lights/emission_profile.h"

#include <algorithm>

namespace drc {

EmissionProfile EmissionProfile::narrowed(float degrees) {
    EmissionProfile p;
    if (degrees >= 180) return p;
    const double half = double(degrees) * double(kPi) / 360, tangent = std::tan(half);
    p.tanHalf_ = float(tangent);
    // Normalised to the power of an even profile, pi: the integral of cos(t) (1 - tan(t) / tan(half)) over the cone is
    // pi (1 - half / tan(half)). For small angles, the first term of the tangent's series replaces tan(half) - half.
    const double excess = half < 1e-3 ? half * half * half / 3 : tangent - half;
    p.scale_ = float(1 / excess);
    p.sinReach_ = float(std::sin(half));
    return p;
}

}  // namespace drc
