// Creates materials. A new material is an entry in the table of material_factory.cpp.
#pragma once
#include <memory>
#include <string>

#include "pbrt/bsdf_files.h"
#include "pbrt/file_search.h"
#include "pbrt/named_map.h"
#include "pbrt/texture_files.h"
#include "pbrt/texture_params.h"
#include "scene/materials/material.h"

namespace drc::pbrt {

// A material with its parameters, which shapes may override in part.
struct MaterialInstance {
    std::string type;
    ParamSet params;
    MaterialPtr material;  // null: "none"
    std::string name;      // that MakeNamedMaterial gives it; empty: none
    bool awaited = false;  // it uses names that are defined later, and is made when they are
};
using NamedMaterials = NamedMap<MaterialInstance>;

// Everything that a material's parameters can refer to by name.
struct MaterialSources {
    const NamedTextures& textures;
    const NamedMaterials& materials;
    const FileSearch& files;
    TextureFiles& images;
    BsdfFiles& bsdfs;
};

// "" and "none" give a null material. Throws Error for types that pbrt-v3 does not have, and for wrong parameters.
std::shared_ptr<const MaterialInstance> makeMaterial(const std::string& type, ParamSet params,
                                                     const MaterialSources& sources);

// The material of a shape: that of the instance, unless the shape's parameters override some of its parameters.
MaterialPtr materialForShape(const MaterialInstance& instance, const ParamSet& shape, const MaterialSources& sources);

}  // namespace drc::pbrt
