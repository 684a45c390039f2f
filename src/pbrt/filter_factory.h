// PixelFilter. A new filter is one entry in the table of filter_factory.cpp.
#pragma once
#include <string>

#include "pbrt/param_set.h"
#include "scene/filter.h"

namespace drc::pbrt {

// Throws Error for an unknown type, a radius that is not positive, or wrong parameters.
FilterPtr makeFilter(const std::string& type, const ParamSet& params);
// pbrt-v4's: "xradius" for "xwidth", and the gaussian by its standard deviation.
FilterPtr makeFilterV4(const std::string& type, const ParamSet& params);

}  // namespace drc::pbrt
