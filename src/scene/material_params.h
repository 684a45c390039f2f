// What the materials' parameters have in common.
#pragma once
#include "scene/microfacet.h"
#include "scene/texture.h"

namespace drc {

// The texture, or a constant where there is none.
inline FloatTexturePtr orConstant(FloatTexturePtr texture, float value) {
    return texture ? std::move(texture) : std::make_shared<ConstantTexture<float>>(value);
}
inline RgbTexturePtr orConstant(RgbTexturePtr texture, const Rgb& value) {
    return texture ? std::move(texture) : std::make_shared<ConstantTexture<Rgb>>(value);
}

// None of these textures varies; null ones do not.
template <class... Textures>
bool areConstant(const Textures&... textures) {
    return (... && (textures == nullptr || textures->isConstant()));
}

// Reflectances are clamped from below only: like pbrt, a material may be told to create energy.
inline Rgb evalClamped(const RgbTexture& texture, const TextureContext& at) {
    return clampNonNegative(texture.eval(at));
}

inline TrowbridgeReitz distributionFor(float uRoughness, float vRoughness, bool remap) {
    if (!remap) return TrowbridgeReitz(uRoughness, vRoughness);
    return TrowbridgeReitz(roughnessToAlpha(uRoughness), roughnessToAlpha(vRoughness));
}

}  // namespace drc
