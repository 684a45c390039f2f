// Measured indices of refraction of metals, for scenes that name them as pbrt does but come without the files.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pbrt/spectrum.h"

namespace drc::pbrt {

// The spectrum of a metal's eta or k: "Cu.eta.spd" or "Cu.k.spd" with or without folders before it, as the files that
// come with pbrt-v3's scenes are called, or "metal-Cu-eta" or "metal-Cu-k", pbrt-v4's names. Metals are given by their
// chemical symbols. None: no such name.
std::optional<std::vector<SpectrumSample>> metalSpectrum(const std::string& name);

}  // namespace drc::pbrt
