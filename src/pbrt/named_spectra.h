// The spectra that pbrt-v4 has built in and its scenes name.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pbrt/spectrum.h"

namespace drc::pbrt {

// Indices of refraction, and k of metals: "glass-BK7", "metal-Cu-eta", ... None: no such name. Brass (CuZn), which we
// have no measurements of, is copper, and isStandIn is then set.
std::optional<std::vector<SpectrumSample>> namedIndex(const std::string& name, bool& isStandIn);

}  // namespace drc::pbrt
