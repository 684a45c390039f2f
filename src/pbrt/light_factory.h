// Creates lights for LightSource and AreaLightSource. To add one, add an entry to a table in light_factory.cpp.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "pbrt/file_search.h"
#include "pbrt/param_set.h"
#include "scene/lights/light.h"
#include "scene/scene.h"

namespace drc::pbrt {

// A light and, if it has an extent, the surface that emits it (bulb). The caller must add this surface to the scene,
// without a material and invisible to the camera.
struct SourceLight {
    SourceLight() = default;
    SourceLight(LightPtr source) : light(std::move(source)) {}  // not explicit: most lights have no extent
    SourceLight(std::shared_ptr<const AreaLight> source, ShapePtr from)
        : light(source), area(std::move(source)), bulb(std::move(from)) {}
    LightPtr light;
    std::shared_ptr<const AreaLight> area;  // the same light as `light`; null without an extent
    ShapePtr bulb;
};

// Without a light for types that are not supported, with a warning, and for lights that nothing can see. Throws Error
// for types that do not exist in pbrt-v3. fromFile: transform from the file's world space to the scene's.
SourceLight makeLight(const std::string& type, const ParamSet& params, const Transform& lightToWorld,
                      const Transform& fromFile, const FileSearch& files);

// Makes the light of an emissive mesh or shape. An empty function means that shapes do not emit.
using AreaLightBuilder = std::function<std::shared_ptr<const AreaLight>(const Primitive&)>;
AreaLightBuilder makeAreaLight(const std::string& type, const ParamSet& params, const FileSearch& files);

// Makes the area light of a mesh or shape.
std::shared_ptr<const AreaLight> makeDiffuseAreaLight(const Primitive& primitive, const Emission& emission,
                                                      bool twoSided);

}  // namespace drc::pbrt
