// Indices of refraction of the optical glasses that are built into pbrt-v4.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "pbrt/spectrum.h"

namespace drc::pbrt {

// Names: "glass-BK7", "glass-BAF10", "glass-FK51A", "glass-LASF9", "glass-F5" (or "glass-SF5"), "glass-F10" (or
// "glass-SF10"), "glass-F11" (or "glass-SF11"). None for any other name.
std::optional<std::vector<SpectrumSample>> glassSpectrum(std::string_view name);

}  // namespace drc::pbrt
