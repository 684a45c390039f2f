// The mappings from surface points to texture coordinates.
#pragma once
#include "math/transform.h"
#include "pbrt/dialect.h"
#include "pbrt/param_set.h"
#include "scene/textures/texture_mapping.h"

namespace drc::pbrt {

// Makes the mapping that the parameter "mapping" names; the default is "uv". textureToWorld: the current transformation
// at the texture's definition, in the file's coordinates. origin: Scene::origin. Throws Error for an unknown mapping;
// warns about parameters that belong to other mappings.
Mapping2D makeMapping2D(const ParamSet& texture, const Transform& textureToWorld, Dialect dialect = Dialect::V3,
                        const Vec3& origin = Vec3(0.f));
Mapping3D makeMapping3D(const Transform& textureToWorld, Dialect dialect = Dialect::V3, const Vec3& origin = Vec3(0.f));

}  // namespace drc::pbrt
