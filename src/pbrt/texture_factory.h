// Creates textures. To add one, add an entry to the table in texture_factory.cpp, for both value types.
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

// Make a texture in the request's dialect. Unsupported types become the constant 0.5, with a warning. Throw Error for
// types that do not exist in pbrt, for wrong parameters, and for missing or damaged images.
FloatTexturePtr makeFloatTexture(const std::string& type, const TextureRequest& request);
RgbTexturePtr makeRgbTexture(const std::string& type, const TextureRequest& request);

}  // namespace drc::pbrt
