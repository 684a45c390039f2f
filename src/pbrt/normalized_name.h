// Names of materials, textures and the like are the same if they look the same: "é" may be one character, or an "e" and
// an accent.
#pragma once
#include <string>

#include "pbrt/dialect.h"

namespace drc::pbrt {

// The name as it is compared: in pbrt-v4 in Unicode's composed form (NFC); as it is in pbrt-v3, and where it is not
// UTF-8.
std::string normalizedName(const std::string& name, Dialect dialect);

}  // namespace drc::pbrt
