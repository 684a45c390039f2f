// pbrt-v3's BSDF files: tables of Fourier series (PBR 3e, section 8.6).
#pragma once
#include <string>

#include "scene/lobes/fourier_table.h"

namespace drc::pbrt {

// Everything in the file that a table is made of is checked. Throws Error, in one line with the file's name, if it is
// damaged or of a kind that is not supported.
FourierSeries readFourierFile(const std::string& path);

}  // namespace drc::pbrt
