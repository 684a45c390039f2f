#include "pbrt/texture_params.h"

#include <algorithm>

#include "base/suggest.h"
#include "pbrt/undefined_name.h"

namespace drc::pbrt {
namespace {

// Traits of the textures with values of type T.
template <typename T>
struct Kind;
template <>
struct Kind<float> {
    static constexpr const char* kName = kFloatTextureName;
    static constexpr ParamType kConstant = ParamType::Float;
    static const NamedMap<FloatTexture>& all(const NamedTextures& t) { return t.scalars; }
    static const NamedMap<RgbTexture>& others(const NamedTextures& t) { return t.colors; }
    static const NamedMap<TextureCost>& costs(const NamedTextures& t) { return t.scalarCosts; }
    static float constant(const ParamSet& set, std::string_view name) { return set.getFloat(name, 0); }
};
template <>
struct Kind<Rgb> {
    static constexpr const char* kName = kSpectrumTextureName;
    static constexpr ParamType kConstant = ParamType::Color;
    static const NamedMap<RgbTexture>& all(const NamedTextures& t) { return t.colors; }
    static const NamedMap<FloatTexture>& others(const NamedTextures& t) { return t.scalars; }
    static const NamedMap<TextureCost>& costs(const NamedTextures& t) { return t.colorCosts; }
    static Rgb constant(const ParamSet& set, std::string_view name) { return set.getColor(name, Rgb(0.f)); }
};

// The texture that a parameter of the set names. Adds its cost to `cost`.
template <typename T>
std::shared_ptr<const Texture<T>> named(const ParamSet& set, const Param& param, const NamedTextures& textures,
                                        TextureCost& cost) {
    using K = Kind<T>;
    const std::string& name = param.strings[0];
    if (auto texture = K::all(textures).find(name)) {
        if (const auto own = K::costs(textures).find(name)) {
            cost.depth = std::max(cost.depth, own->depth);
            cost.lookups += own->lookups;
        }
        return texture;
    }
    const std::string complaint = std::string("no ") + K::kName + " '" + name + "' has been defined",
                      advice = K::others(textures).find(name) ? "; the texture of that name has the other type"
                                                              : suggestion(name, K::all(textures).names());
    if (textures.dialect == Dialect::V4) throw UndefinedName(K::kName, name, param.valuePos, complaint + advice);
    warn(param.valuePos, complaint + "; the default of '" + param.name + "' of " + set.owner() + " counts" + advice);
    return nullptr;
}

}  // namespace

const ParamSet& TextureParams::setWith(std::string_view name, std::initializer_list<ParamType> types) const {
    return shape_ != nullptr && shape_->findIfTyped(name, types) != nullptr ? *shape_ : own_;
}

template <typename T>
std::shared_ptr<const Texture<T>> TextureParams::textureOrConstant(std::string_view name) const {
    constexpr ParamType kConstant = Kind<T>::kConstant;
    const ParamSet& set = setWith(name, {ParamType::Texture, kConstant});
    if (const Param* texture = set.findIfTyped(name, {ParamType::Texture})) {
        if (texture->count() != 1)
            set.failAt(*texture, "must have one texture's name, not " + std::to_string(texture->count()));
        return named<T>(set, *texture, textures_, cost_);
    }
    if (set.find(name, {kConstant, ParamType::Texture}) == nullptr) return nullptr;
    return constantTexture(Kind<T>::constant(set, name));
}

RgbTexturePtr TextureParams::colorOrNull(std::string_view name) const { return textureOrConstant<Rgb>(name); }

FloatTexturePtr TextureParams::scalarOrNull(std::string_view name) const { return textureOrConstant<float>(name); }

RgbTexturePtr TextureParams::color(std::string_view name, const Rgb& fallback) const {
    if (auto texture = colorOrNull(name)) return texture;
    return std::make_shared<ConstantTexture<Rgb>>(fallback);
}

FloatTexturePtr TextureParams::scalar(std::string_view name, float fallback) const {
    if (auto texture = scalarOrNull(name)) return texture;
    return std::make_shared<ConstantTexture<float>>(fallback);
}

bool TextureParams::getBool(std::string_view name, bool fallback) const {
    return setWith(name, {ParamType::Bool}).getBool(name, fallback);
}

float TextureParams::getFloat(std::string_view name, float fallback) const {
    return setWith(name, {ParamType::Float}).getFloat(name, fallback);
}

std::string TextureParams::getString(std::string_view name, const std::string& fallback) const {
    return setWith(name, {ParamType::String}).getString(name, fallback);
}

}  // namespace drc::pbrt
