// How much a surface faces a direction (the amount of pbrt-v4's "directionmix").
#pragma once
#include "scene/textures/texture.h"

namespace drc {

// The absolute cosine between the shading normal and a direction in world space, of any length but zero.
FloatTexturePtr makeDirectionTexture(const Vec3& direction);

}  // namespace drc
