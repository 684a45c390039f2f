// The spectra of materials that are built into pbrt-v4.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pbrt/spectrum.h"

namespace drc::pbrt {

// Indices of refraction, and absorption k of metals: "glass-BK7", "metal-Cu-eta", "metal-TiO2-k", ... None for any
// other name.
std::optional<std::vector<SpectrumSample>> namedIndex(const std::string& name);

}  // namespace drc::pbrt
