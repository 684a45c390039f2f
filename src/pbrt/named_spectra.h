// The spectra that pbrt-v4 has built in.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pbrt/spectrum.h"

namespace drc::pbrt {

// Indices of refraction, and k of metals: "glass-BK7", "metal-Cu-eta", ... None for any other name. isStandIn is set
// for brass (CuZn), for which copper is returned, because we have no measurements of it.
std::optional<std::vector<SpectrumSample>> namedIndex(const std::string& name, bool& isStandIn);

}  // namespace drc::pbrt
