// Names of materials, textures and the like are equal if they look equal: "é" may be one character, or an "e" and an
// accent.
#pragma once
#include <string>

#include "pbrt/dialect.h"

namespace drc::pbrt {

// The form of a name used for comparison: Unicode's composed form (NFC) in pbrt-v4; the name itself in pbrt-v3, or if
// it is not valid UTF-8.
std::string normalizedName(const std::string& name, Dialect dialect);

}  // namespace drc::pbrt
