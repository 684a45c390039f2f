// Scattering media that scenes may name, with measured coefficients.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/vec.h"

namespace drc::pbrt {

struct NamedMedium {
    Rgb sigmaA;       // absorption, per millimetre
    Rgb sigmaSPrime;  // reduced scattering, per millimetre: coefficient of the equivalent isotropic medium
};

// "Skin1", "Wholemilk", ...: from Jensen et al., "A Practical Model for Subsurface Light Transport", 2001, and
// Narasimhan et al., "Acquiring Scattering Properties of Participating Media by Dilution", 2006. None for other names.
std::optional<NamedMedium> namedMedium(std::string_view name);
std::vector<std::string_view> namesOfMedia();

}  // namespace drc::pbrt
