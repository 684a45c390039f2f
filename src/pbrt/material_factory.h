// Creates materials. To add one, add an entry to the table in material_factory.cpp.
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

// A material and its parameters, some of which shapes may override.
struct MaterialInstance {
    std::string type;
    ParamSet params;
    MaterialPtr material;  // null for "none"
    std::string name;      // name from MakeNamedMaterial; empty if unnamed
    bool awaited = false;  // uses names that are defined later, and is made once they are
    size_t listed = 0;     // index into SceneListing::materials, if there is one
};
using NamedMaterials = NamedMap<MaterialInstance>;

// Everything that material parameters can refer to by name.
struct MaterialSources {
    const NamedTextures& textures;
    const NamedMaterials& materials;
    const FileSearch& files;
    TextureFiles& images;
    BsdfFiles& bsdfs;
};

// "" and "none" give a null material. Throws Error for types that do not exist in pbrt-v3, and for wrong parameters.
std::shared_ptr<const MaterialInstance> makeMaterial(const std::string& type, ParamSet params,
                                                     const MaterialSources& sources);

// The material of a shape: the instance's, unless the shape's parameters override some of its parameters.
MaterialPtr materialForShape(const MaterialInstance& instance, const ParamSet& shape, const MaterialSources& sources);

}  // namespace drc::pbrt
