// The graphics state: directives change it, and AttributeBegin saves it.
#pragma once
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "math/animated_transform.h"
#include "pbrt/color_space.h"
#include "pbrt/light_factory.h"
#include "pbrt/material_factory.h"
#include "pbrt/texture_params.h"

namespace drc::pbrt {

// The current transformation at each of the two TransformTimes: at[0] start, at[1] end.
struct TransformSet {
    std::array<Transform, 2> at;

    const Transform& start() const { return at[0]; }
    bool isAnimated() const { return !(at[0] == at[1]); }
    AnimatedTransform animated() const { return {at[0], at[1]}; }
    TransformSet inverse() const { return {{at[0].inverse(), at[1].inverse()}}; }
    bool operator==(const TransformSet&) const = default;
};

// The part of the graphics state that only a SceneListing needs.
struct ListedState {
    std::optional<size_t> areaLight;  // index into SceneListing::areaLights
    std::string inside, outside;      // names of the media
};

struct GraphicsState {
    TransformSet ctm;
    std::array<bool, 2> active{true, true};  // which of the two times transform directives affect
    bool reverseOrientation = false;
    std::shared_ptr<const MaterialInstance> material;
    NamedMap<MaterialInstance> namedMaterials;
    NamedTextures textures;
    AreaLightBuilder areaLight;  // empty if shapes do not emit
    MediumInterface media;       // inside and outside of shapes; the outside one also surrounds a camera
    // For pbrt-v4: the colour space of "rgb" values; and the parameters set by Attribute, by target ("shape", ...).
    const ColorSpace* colorSpace = &ColorSpace::srgb();
    std::map<std::string, std::shared_ptr<const ParamSet>> attributes;
    ListedState listed;
};

}  // namespace drc::pbrt
