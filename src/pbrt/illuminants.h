// The white point of pbrt-v4, and the standard illuminants that are built into it.
#pragma once
#include <optional>
#include <string_view>

#include "math/vec.h"

namespace drc::pbrt {

// Relative spectral power of CIE standard illuminant D65, 100 at 560 nm. Wavelengths must be within the table of cie.h.
float d65At(float nanometres);

// The colour, scaled to a luminance of one, of "stdillum-A", "stdillum-D50", "stdillum-D65", "stdillum-F1" to
// "stdillum-F12" or "illum-acesD60". None for any other name.
std::optional<Rgb> illuminantNamed(std::string_view name);

}  // namespace drc::pbrt
