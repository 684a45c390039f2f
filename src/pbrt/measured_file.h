// The measured materials of the RGL database (Dupuy and Jakob 2018).
#pragma once
#include <string>

#include "scene/lobes/measured_table.h"

namespace drc::pbrt {

// Spectra become RGB as those of pbrt-v4's reflectances do (reflectanceToRgb()). Everything in the file that a table is
// made of is checked. Throws Error, in one line with the file's name, if it is damaged.
MeasuredData readMeasuredFile(const std::string& path);

}  // namespace drc::pbrt
