// The mappings that textures have in common.
#pragma once
#include "math/transform.h"
#include "pbrt/dialect.h"
#include "pbrt/param_set.h"
#include "scene/texture_mapping.h"

namespace drc::pbrt {

// By the parameter "mapping", "uv" unless given. textureToWorld is the transformation current where the texture is
// defined. Throws Error for a mapping that does not exist; warns of parameters that the mapping does not have.
Mapping2D makeMapping2D(const ParamSet& texture, const Transform& textureToWorld, Dialect dialect = Dialect::V3);
Mapping3D makeMapping3D(const Transform& textureToWorld, Dialect dialect = Dialect::V3);

}  // namespace drc::pbrt
