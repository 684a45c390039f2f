// The lights of pbrt-v4 (https://pbrt.org/fileformat-v4). Unlike in pbrt-v3, "scale" is a number, and "power" or
// "illuminance" says how bright a light is in all, whatever its picture holds. A new light is one entry in a table of
// light_factory_v4.cpp.
#pragma once
#include "pbrt/light_factory.h"

namespace drc::pbrt {

// As makeLight and makeAreaLight are for pbrt-v3.
LightPtr makeLightV4(const std::string& type, const ParamSet& params, const Transform& lightToWorld,
                     const FileSearch& files);
AreaLightBuilder makeAreaLightV4(const std::string& type, const ParamSet& params);

}  // namespace drc::pbrt
