// Helpers for the parameters of materials.
#pragma once
#include <optional>

#include "scene/lobes/microfacet.h"
#include "scene/textures/texture.h"

namespace drc {

// The texture, or a constant texture if it is null.
inline FloatTexturePtr orConstant(FloatTexturePtr texture, float value) {
    return texture ? std::move(texture) : std::make_shared<ConstantTexture<float>>(value);
}
inline RgbTexturePtr orConstant(RgbTexturePtr texture, const Rgb& value) {
    return texture ? std::move(texture) : std::make_shared<ConstantTexture<Rgb>>(value);
}

// Whether none of these textures varies; a null texture counts as constant.
template <class... Textures>
bool areConstant(const Textures&... textures) {
    return (... && (textures == nullptr || textures->isConstant()));
}

// Reflectances are clamped from below only: as in pbrt, parameters may make a material create energy.
inline Rgb evalClamped(const RgbTexture& texture, const TextureContext& at) {
    return clampNonNegative(texture.eval(at));
}

inline TrowbridgeReitz distributionFor(float uRoughness, float vRoughness, bool remap) {
    if (!remap) return TrowbridgeReitz(uRoughness, vRoughness);
    return TrowbridgeReitz(roughnessToAlpha(uRoughness), roughnessToAlpha(vRoughness));
}

// The roughness of pbrt-v4's materials: alpha is the texture's value, or its square root with `remap`. The surface is
// perfectly smooth if alpha is below TrowbridgeReitz::kMinAlpha on both axes.
struct RoughnessTextures {
    const FloatTexturePtr& both;  // for an axis whose own texture is null; never null
    const FloatTexturePtr &u, &v;
    bool remap;  // the textures are alpha squared, not alpha
};
// None: smooth.
inline std::optional<TrowbridgeReitz> distributionUnlessSmooth(const RoughnessTextures& roughness,
                                                               const TextureContext& at) {
    const auto alpha = [&](const FloatTexturePtr& own) {
        const float value = std::max(0.f, (own ? own : roughness.both)->eval(at));
        return roughness.remap ? std::sqrt(value) : value;
    };
    const float u = alpha(roughness.u), v = alpha(roughness.v);
    if (std::max(u, v) < TrowbridgeReitz::kMinAlpha) return std::nullopt;
    return TrowbridgeReitz(u, v);
}

}  // namespace drc
