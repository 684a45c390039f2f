// The materials of pbrt-v4: names and parameters are as in its documentation (https://pbrt.org/fileformat-v4). A new
// one is one entry in the table of material_factory_v4.cpp.
#pragma once
#include <string>

#include "pbrt/material_factory.h"

namespace drc::pbrt {

// "interface", "" and "none" give a null material. What is not built becomes grey diffuse, with a warning. Throws Error
// for a type that pbrt-v4 does not know either and for wrong parameters; warns of parameters that are not known.
std::shared_ptr<const MaterialInstance> makeMaterialV4(const std::string& type, ParamSet params,
                                                       const NamedTextures& textures, const NamedMaterials& materials);

// Shapes do not change their material in pbrt-v4.
inline MaterialPtr materialForShapeV4(const MaterialInstance& instance, const ParamSet&, const NamedTextures&,
                                      const NamedMaterials&) {
    return instance.material;
}

}  // namespace drc::pbrt
