// Measured indices of refraction of metals, for scenes that name them as pbrt does but do not come with the files.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pbrt/spectrum.h"

namespace drc::pbrt {

// The spectrum of a metal's eta or k. Names are "Cu.eta.spd" or "Cu.k.spd", optionally with folders, like the files of
// pbrt-v3's scenes, or "metal-Cu-eta" or "metal-Cu-k", as in pbrt-v4. Metals are named by chemical symbols. None for
// any other name.
std::optional<std::vector<SpectrumSample>> metalSpectrum(const std::string& name);

}  // namespace drc::pbrt
