// Parameters of materials and textures that may be constants or textures.
#pragma once
#include <string>

#include "pbrt/dialect.h"
#include "pbrt/named_map.h"
#include "pbrt/param_set.h"
#include "scene/textures/texture.h"

namespace drc::pbrt {

// The cost of evaluating a texture: nesting depth of its textures, and number of texture lookups that one lookup
// causes.
struct TextureCost {
    int depth = 0, lookups = 0;
};

struct NamedTextures {
    NamedMap<FloatTexture> scalars;
    NamedMap<RgbTexture> colors;
    NamedMap<TextureCost> scalarCosts, colorCosts;  // under the names of the textures
    NamedMap<size_t> scalarsListed, colorsListed;   // likewise: indices into SceneListing::textures, if there is one
    Dialect dialect = Dialect::V3;
};

// Reads a material's or texture's parameters. As in pbrt-v3, a parameter of the shape overrides the material's
// parameter of the same name.
class TextureParams {
  public:
    // All arguments must outlive this object. shape may be null.
    TextureParams(const ParamSet& own, const NamedTextures& textures, const ParamSet* shape = nullptr)
        : own_(own), textures_(textures), shape_(shape) {}

    // The texture that a parameter names, or its constant as a texture. If the parameter is missing or names the empty
    // texture, the OrNull functions return null. If it names a texture that is undefined or of the wrong type, pbrt-v3
    // warns and uses the default, whereas in pbrt-v4 UndefinedName is thrown.
    RgbTexturePtr color(std::string_view name, const Rgb& fallback) const;
    RgbTexturePtr colorOrNull(std::string_view name) const;
    FloatTexturePtr scalar(std::string_view name, float fallback) const;
    FloatTexturePtr scalarOrNull(std::string_view name) const;

    bool getBool(std::string_view name, bool fallback) const;
    float getFloat(std::string_view name, float fallback) const;
    std::string getString(std::string_view name, const std::string& fallback) const;

    const ParamSet& own() const { return own_; }
    // Cost of evaluating all textures requested so far: the largest depth, and the sum of the lookups.
    const TextureCost& cost() const { return cost_; }

  private:
    // The set that contains a parameter of this name and one of these types: the shape's if possible, otherwise the
    // material's.
    const ParamSet& setWith(std::string_view name, std::initializer_list<ParamType> types) const;
    // The named texture, or a constant of type T; null if the set contains neither.
    template <typename T>
    std::shared_ptr<const Texture<T>> textureOrConstant(std::string_view name) const;

    const ParamSet& own_;
    const NamedTextures& textures_;
    const ParamSet* shape_;
    mutable TextureCost cost_;
};

}  // namespace drc::pbrt
