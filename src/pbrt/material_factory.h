// Materials. A new one is one entry in the table of material_factory.cpp.
#pragma once
#include <memory>
#include <string>

#include "pbrt/named_map.h"
#include "pbrt/texture_params.h"
#include "scene/material.h"

namespace drc::pbrt {

// A material as the file gives it, for shapes that override some of its parameters, and as it was made.
struct MaterialInstance {
    std::string type;
    ParamSet params;
    MaterialPtr material;  // null: "none"
};
using NamedMaterials = NamedMap<MaterialInstance>;

// "" and "none" give a null material. What is not built becomes grey matte, with a warning. Throws Error for a type
// that pbrt-v3 does not know either and for wrong parameters.
std::shared_ptr<const MaterialInstance> makeMaterial(const std::string& type, ParamSet params,
                                                     const NamedTextures& textures, const NamedMaterials& materials);

// The material of a shape: the instance's own, shared, unless the shape's parameters override some of its.
MaterialPtr materialForShape(const MaterialInstance& instance, const ParamSet& shape, const NamedTextures& textures,
                             const NamedMaterials& materials);

}  // namespace drc::pbrt
