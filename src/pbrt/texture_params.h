// Parameters that may be values or textures, of a material or a texture.
#pragma once
#include <string>

#include "pbrt/named_map.h"
#include "pbrt/param_set.h"
#include "scene/texture.h"

namespace drc::pbrt {

// What one lookup of a texture leads to: how deep textures are looked up by textures, and how many lookups that is.
struct TextureCost {
    int depth = 0, lookups = 0;
};

struct NamedTextures {
    NamedMap<FloatTexture> scalars;
    NamedMap<RgbTexture> colors;
    NamedMap<TextureCost> scalarCosts, colorCosts;  // by the same names
};

// As in pbrt-v3, a shape's own parameter goes before the material's one of the same name.
class TextureParams {
  public:
    // All must outlive this. shape may be null.
    TextureParams(const ParamSet& own, const NamedTextures& textures, const ParamSet* shape = nullptr)
        : own_(own), textures_(textures), shape_(shape) {}

    // A texture, or the constant. Each throws Error at a parameter that names a texture which does not exist, or has
    // the wrong type. The OrNull ones return null where there is no such parameter.
    RgbTexturePtr color(std::string_view name, const Rgb& fallback) const;
    RgbTexturePtr colorOrNull(std::string_view name) const;
    FloatTexturePtr scalar(std::string_view name, float fallback) const;
    FloatTexturePtr scalarOrNull(std::string_view name) const;

    bool getBool(std::string_view name, bool fallback) const;
    float getFloat(std::string_view name, float fallback) const;
    std::string getString(std::string_view name, const std::string& fallback) const;

    const ParamSet& own() const { return own_; }
    // Of looking up every texture that was asked for: the deepest, and the sum.
    const TextureCost& cost() const { return cost_; }

  private:
    // The set in which a parameter of that name and one of these types is to be looked up.
    const ParamSet& setWith(std::string_view name, std::initializer_list<ParamType> types) const;

    const ParamSet& own_;
    const NamedTextures& textures_;
    const ParamSet* shape_;
    mutable TextureCost cost_;
};

}  // namespace drc::pbrt
