// Measured indices of refraction of metals, for scenes that name them as pbrt does but come without the files.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pbrt/spectrum.h"

namespace drc::pbrt {

// The spectrum of a metal's eta or k. Metals are named by chemical symbols: "Cu.eta.spd" or "Cu.k.spd", optionally with
// folders, like the files of pbrt-v3's scenes; or "metal-Cu-eta" or "metal-Cu-k", as in pbrt-v4. None for any other
// name.
std::optional<std::vector<SpectrumSample>> metalSpectrum(const std::string& name);

}  // namespace drc::pbrt
