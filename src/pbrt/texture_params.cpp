#include "pbrt/texture_params.h"

#include <algorithm>

#include "base/suggest.h"

namespace drc::pbrt {
namespace {

// The texture that a parameter of the set names. Adds its cost.
template <typename T, typename Other>
std::shared_ptr<const Texture<T>> named(const ParamSet& set, const Param& param, const NamedMap<Texture<T>>& textures,
                                        const NamedMap<Texture<Other>>& others, const std::string& kind,
                                        const NamedMap<TextureCost>& costs, TextureCost& cost) {
    if (param.count() != 1) set.failAt(param, "must have one texture's name, not " + std::to_string(param.count()));
    const std::string& name = param.strings[0];
    if (auto texture = textures.find(name)) {
        if (const auto own = costs.find(name)) {
            cost.depth = std::max(cost.depth, own->depth);
            cost.lookups += own->lookups;
        }
        return texture;
    }
    fail(param.valuePos, "no " + kind + " texture '" + name + "' has been defined" +
                             (others.find(name) ? "; the texture of that name has the other type"
                                                : suggestion(name, textures.names())));
}

}  // namespace

const ParamSet& TextureParams::setWith(std::string_view name, std::initializer_list<ParamType> types) const {
    return shape_ != nullptr && shape_->findIfTyped(name, types) != nullptr ? *shape_ : own_;
}

RgbTexturePtr TextureParams::colorOrNull(std::string_view name) const {
    const ParamSet& set = setWith(name, {ParamType::Texture, ParamType::Color});
    if (const Param* texture = set.findIfTyped(name, {ParamType::Texture}))
        return named(set, *texture, textures_.colors, textures_.scalars, "spectrum", textures_.colorCosts, cost_);
    if (set.find(name, {ParamType::Color, ParamType::Texture}) == nullptr) return nullptr;
    return std::make_shared<ConstantTexture<Rgb>>(set.getColor(name, Rgb(0.f)));
}

FloatTexturePtr TextureParams::scalarOrNull(std::string_view name) const {
    const ParamSet& set = setWith(name, {ParamType::Texture, ParamType::Float});
    if (const Param* texture = set.findIfTyped(name, {ParamType::Texture}))
        return named(set, *texture, textures_.scalars, textures_.colors, "float", textures_.scalarCosts, cost_);
    if (set.find(name, {ParamType::Float, ParamType::Texture}) == nullptr) return nullptr;
    return std::make_shared<ConstantTexture<float>>(set.getFloat(name, 0));
}

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
