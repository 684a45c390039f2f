// The materials of pbrt-v4, with names and parameters as in its documentation (https://pbrt.org/fileformat-v4). To add
// a material, add an entry to the table in material_factory_v4.cpp.
#pragma once
#include <string>

#include "pbrt/material_factory.h"

namespace drc::pbrt {

// "interface", "" and "none" give a null material. Throws Error for types that do not exist in pbrt-v4, and for wrong
// parameters; warns about unknown parameters.
std::shared_ptr<const MaterialInstance> makeMaterialV4(const std::string& type, ParamSet params,
                                                       const MaterialSources& sources);

// In pbrt-v4, shapes cannot override parameters of their material.
inline MaterialPtr materialForShapeV4(const MaterialInstance& instance, const ParamSet&, const MaterialSources&) {
    return instance.material;
}

}  // namespace drc::pbrt
