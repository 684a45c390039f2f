// Creates lights for LightSource and AreaLightSource. A new light is an entry in a table of light_factory.cpp.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "pbrt/file_search.h"
#include "pbrt/param_set.h"
#include "scene/lights/light.h"
#include "scene/scene.h"

namespace drc::pbrt {

// A light with, if it has an extent, the surface that it shines from, which must be in the scene: it has no material,
// and the camera does not see it.
struct SourceLight {
    SourceLight() = default;
    SourceLight(LightPtr source) : light(std::move(source)) {}  // not explicit: most lights have no extent
    SourceLight(std::shared_ptr<const AreaLight> source, ShapePtr from)
        : light(source), area(std::move(source)), bulb(std::move(from)) {}
    LightPtr light;
    std::shared_ptr<const AreaLight> area;  // the same light
    ShapePtr bulb;
};

// Null, with a warning, for types that are not supported. Throws Error for types that pbrt-v3 does not have either.
// fromFile: from the world space of the file to that of the scene.
SourceLight makeLight(const std::string& type, const ParamSet& params, const Transform& lightToWorld,
                      const Transform& fromFile, const FileSearch& files);

// Makes the light of an emissive mesh or shape; an empty function means that shapes do not emit.
using AreaLightBuilder = std::function<std::shared_ptr<const AreaLight>(const Primitive&)>;
AreaLightBuilder makeAreaLight(const std::string& type, const ParamSet& params, const FileSearch& files);

// The light of a mesh or shape.
std::shared_ptr<const AreaLight> makeDiffuseAreaLight(const Primitive& primitive, const Emission& emission,
                                                      bool twoSided);

}  // namespace drc::pbrt
