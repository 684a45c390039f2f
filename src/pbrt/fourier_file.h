// pbrt-v3's BSDF files: tables of Fourier series (PBR 3e, section 8.6).
#pragma once
#include <string>

#include "scene/lobes/fourier_table.h"

namespace drc::pbrt {

// Checks all values that a table is built from. Throws Error, in one line with the file's name, if the file is damaged
// or of an unsupported kind.
FourierSeries readFourierFile(const std::string& path);

}  // namespace drc::pbrt
