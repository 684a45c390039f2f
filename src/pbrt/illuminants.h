// The light that pbrt-v4 calls white, and the standard illuminants that it knows by name.
#pragma once
#include <optional>
#include <string_view>

#include "math/vec.h"

namespace drc::pbrt {

// Relative spectral power of CIE standard illuminant D65 at a wavelength within the table of cie.h, 100 at 560 nm.
float d65At(float nanometres);

// The colour of "stdillum-A", "stdillum-D50", "stdillum-D65", "stdillum-F1" to "stdillum-F12" and "illum-acesD60", with
// a luminance of one. None: no such name.
std::optional<Rgb> illuminantNamed(std::string_view name);

}  // namespace drc::pbrt
