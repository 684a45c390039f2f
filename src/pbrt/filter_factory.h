// Creates pixel filters. To add one, add an entry to the table in filter_factory.cpp.
#pragma once
#include <string>

#include "pbrt/param_set.h"
#include "scene/filter.h"

namespace drc::pbrt {

// Throws Error for an unknown type, a radius that is not positive, or wrong parameters.
FilterPtr makeFilter(const std::string& type, const ParamSet& params);
// The counterpart for pbrt-v4, which has "xradius" for "xwidth" and defines the gaussian by its standard deviation.
FilterPtr makeFilterV4(const std::string& type, const ParamSet& params);

}  // namespace drc::pbrt
