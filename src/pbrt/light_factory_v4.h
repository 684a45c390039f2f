// The lights of pbrt-v4 (https://pbrt.org/fileformat-v4). Unlike in pbrt-v3, "scale" is a number, and "power" or
// "illuminance" sets a light's total brightness, whatever its image. To add a light, add an entry to a table in
// light_factory_v4.cpp.
#pragma once
#include "pbrt/light_factory.h"

namespace drc::pbrt {

// The counterparts of makeLight() and makeAreaLight() for pbrt-v4.
SourceLight makeLightV4(const std::string& type, const ParamSet& params, const Transform& lightToWorld,
                        const Transform& fromFile, const FileSearch& files);
AreaLightBuilder makeAreaLightV4(const std::string& type, const ParamSet& params, const FileSearch& files);

}  // namespace drc::pbrt
