// Creates textures. A new texture is an entry in the table of texture_factory.cpp, for both value types.
#pragma once
#include <string>

#include "math/transform.h"
#include "pbrt/dialect.h"
#include "pbrt/file_search.h"
#include "pbrt/texture_files.h"
#include "pbrt/texture_params.h"
#include "scene/textures/texture.h"

namespace drc::pbrt {

struct TextureRequest {
    const TextureParams& params;
    Transform textureToWorld;
    const FileSearch& files;
    TextureFiles& images;
    Dialect dialect = Dialect::V3;
    Vec3 origin{0.f};  // Scene::origin
};

// In the request's dialect. Types that are not supported become the constant 0.5, with a warning. Throw Error for types
// that pbrt does not have either, for wrong parameters, and for an image that is missing or damaged.
FloatTexturePtr makeFloatTexture(const std::string& type, const TextureRequest& request);
RgbTexturePtr makeRgbTexture(const std::string& type, const TextureRequest& request);

}  // namespace drc::pbrt
