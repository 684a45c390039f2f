// What directives change and AttributeBegin saves.
#pragma once
#include <array>
#include <map>
#include <memory>
#include <string>

#include "math/animated_transform.h"
#include "pbrt/color_space.h"
#include "pbrt/light_factory.h"
#include "pbrt/material_factory.h"
#include "pbrt/texture_params.h"

namespace drc::pbrt {

// The current transformation at the first and at the second of the two TransformTimes.
struct TransformSet {
    std::array<Transform, 2> at;

    const Transform& start() const { return at[0]; }
    bool isAnimated() const { return !(at[0] == at[1]); }
    AnimatedTransform animated() const { return {at[0], at[1]}; }
    TransformSet inverse() const { return {{at[0].inverse(), at[1].inverse()}}; }
    bool operator==(const TransformSet&) const = default;
};

struct GraphicsState {
    TransformSet ctm;
    std::array<bool, 2> active{true, true};  // which of the two transform directives change
    bool reverseOrientation = false;
    std::shared_ptr<const MaterialInstance> material;
    NamedMap<MaterialInstance> namedMaterials;
    NamedTextures textures;
    AreaLightBuilder areaLight;  // empty: shapes do not emit
    // pbrt-v4's: the space of "rgb" colours, and what Attribute gives to all that are made, by its target.
    const ColorSpace* colorSpace = &ColorSpace::srgb();
    std::map<std::string, std::shared_ptr<const ParamSet>> attributes;
};

}  // namespace drc::pbrt
