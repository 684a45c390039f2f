// The measured materials of the RGL database (Dupuy and Jakob 2018).
#pragma once
#include <string>

#include "scene/lobes/measured_table.h"

namespace drc::pbrt {

// Spectra are converted to RGB like the reflectances of pbrt-v4 (reflectanceToRgb()). Checks all values that a table is
// built from. Throws Error, in one line with the file's name, if the file is damaged.
MeasuredData readMeasuredFile(const std::string& path);

}  // namespace drc::pbrt
