// The materials of pbrt-v4, for a front end that reads its format: names and parameters are as in its documentation
// (https://pbrt.org/fileformat-v4). A new one is one entry in the table of material_factory_v4.cpp.
#pragma once
#include <string>

#include "pbrt/material_factory.h"

namespace drc::pbrt {

// "interface", "" and "none" give a null material. What is not built becomes grey diffuse, with a warning. Throws Error
// for a type that pbrt-v4 does not know either and for wrong parameters; warns of parameters that are not known.
MaterialPtr makeMaterialV4(const std::string& type, const ParamSet& params, const NamedTextures& textures,
                           const NamedMaterials& materials);

}  // namespace drc::pbrt
