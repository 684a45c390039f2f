// Parameters of materials and textures that may be constants or textures.
#pragma once
#include <string>

#include "pbrt/dialect.h"
#include "pbrt/named_map.h"
#include "pbrt/param_set.h"
#include "scene/textures/texture.h"

namespace drc::pbrt {

// The cost of evaluating a texture: how deep textures are nested, and how many texture lookups one lookup leads to.
struct TextureCost {
    int depth = 0, lookups = 0;
};

struct NamedTextures {
    NamedMap<FloatTexture> scalars;
    NamedMap<RgbTexture> colors;
    NamedMap<TextureCost> scalarCosts, colorCosts;  // with the same names as the textures
    Dialect dialect = Dialect::V3;
};

// As in pbrt-v3, a parameter of the shape overrides the material's parameter of the same name.
class TextureParams {
  public:
    // All arguments must outlive this object. shape may be null.
    TextureParams(const ParamSet& own, const NamedTextures& textures, const ParamSet* shape = nullptr)
        : own_(own), textures_(textures), shape_(shape) {}

    // The texture, or a constant one. The OrNull functions return null if there is no such parameter; an empty name
    // names no texture. For a texture that is not defined, or has the wrong type, the default counts in pbrt-v3, with a
    // warning; in pbrt-v4 UndefinedName is thrown.
    RgbTexturePtr color(std::string_view name, const Rgb& fallback) const;
    RgbTexturePtr colorOrNull(std::string_view name) const;
    FloatTexturePtr scalar(std::string_view name, float fallback) const;
    FloatTexturePtr scalarOrNull(std::string_view name) const;

    bool getBool(std::string_view name, bool fallback) const;
    float getFloat(std::string_view name, float fallback) const;
    std::string getString(std::string_view name, const std::string& fallback) const;

    const ParamSet& own() const { return own_; }
    // Cost of evaluating all textures that were requested: the largest depth, and the sum of the lookups.
    const TextureCost& cost() const { return cost_; }

  private:
    // The set (the shape's or the material's own) that provides a parameter of this name and one of these types.
    const ParamSet& setWith(std::string_view name, std::initializer_list<ParamType> types) const;
    // The texture of that name, or the constant of this type; null if the set has neither.
    template <typename T>
    std::shared_ptr<const Texture<T>> textureOrConstant(std::string_view name) const;

    const ParamSet& own_;
    const NamedTextures& textures_;
    const ParamSet* shape_;
    mutable TextureCost cost_;
};

}  // namespace drc::pbrt
