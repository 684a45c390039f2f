#include "pbrt/light_factory.h"

#include "base/log.h"
#include "pbrt/light_params.h"
#include "pbrt/registry.h"

namespace drc::pbrt {
namespace {

// The parameter that multiplies every light's colour in pbrt-v3.
Rgb scaleOf(const ParamSet& params) { return params.getColor("scale", Rgb(1.f)); }

// Accepts pbrt's number of samples per light, which has no effect: every sample of a pixel chooses one light.
void samplesNotNeeded(const ParamSet& params) {
    if (!params.has("samples") && !params.has("nsamples")) return;
    params.ignore({"samples", "nsamples"});
    logDebug(params.owner() + ": its number of samples is not needed: lights are sampled by what they bring");
}

// pbrt-v3 decodes only images of textures, so images of lights are linear even in 8-bit files. Lookups within half a
// pixel of an edge interpolate with the opposite edge.
LightImage pictureOf(const LightContext& context, const std::string& what) {
    LightImage image = imageOf(context.params, context.files, "mapname", what, readAsStored);
    image.repeats = true;
    return image;
}

SourceLight makePoint(const LightContext& context) {
    const Rgb intensity = context.params.getColor("I", Rgb(1.f)) * scaleOf(context.params);
    return lampOf(context.params, placed(context), intensity, nullptr);
}

SourceLight makeDistant(const LightContext& context) {
    const Rgb radiance = context.params.getColor("L", Rgb(1.f)) * scaleOf(context.params);
    return distantLight(context, radiance);
}

SourceLight makeSpot(const LightContext& context) {
    const Rgb intensity = context.params.getColor("I", Rgb(1.f)) * scaleOf(context.params);
    const SpotFalloff falloff = spotFalloff(context.params, SpotEdge::Steep);
    return lampOf(context.params, aimed(context.params, context.toWorld), intensity, &falloff);
}

SourceLight makeGoniometric(const LightContext& context) {
    const Rgb intensity = context.params.getColor("I", Rgb(1.f)) * scaleOf(context.params);
    return makeGoniometricLight(context.toWorld, intensity, pictureOf(context, "goniometric diagram"));
}

SourceLight makeProjection(const LightContext& context) {
    const Rgb intensity = context.params.getColor("I", Rgb(1.f)) * scaleOf(context.params);
    const float fov = degreesBetween(context.params, "fov", 45, 0, 180);
    return makeProjectionLight(context.toWorld, intensity, fov, pictureOf(context, "picture to project"));
}

SourceLight makeInfinite(const LightContext& context) {
    const Rgb radiance = context.params.getColor("L", Rgb(1.f)) * scaleOf(context.params);
    samplesNotNeeded(context.params);
    return makeInfiniteLight(context.toWorld, radiance, pictureOf(context, "environment map"),
                             audienceOf(context.params));
}

using LightMaker = SourceLight (*)(const LightContext&);
constexpr Registered<LightMaker> kLights[] = {
    {"distant", makeDistant},   {"exinfinite", makeInfinite}, {"goniometric", makeGoniometric},
    {"infinite", makeInfinite}, {"point", makePoint},         {"projection", makeProjection},
    {"spot", makeSpot},
};

AreaLightBuilder makeDiffuse(const ParamSet& params) {
    const Rgb radiance = params.getColor("L", Rgb(1.f)) * scaleOf(params);
    const bool twoSided = params.getBool("twosided", false);
    const Emission emission = Emission(radiance).with(emissionProfile(params));
    samplesNotNeeded(params);
    if (isBlack(radiance)) return {};
    return [=](const Primitive& primitive) { return makeDiffuseAreaLight(primitive, emission, twoSided); };
}

using AreaLightMaker = AreaLightBuilder (*)(const ParamSet&);
constexpr Registered<AreaLightMaker> kAreaLights[] = {
    {"area", makeDiffuse},  // pbrt's old name
    {"diffuse", makeDiffuse},
};

}  // namespace

SourceLight makeLight(const std::string& type, const ParamSet& params, const Transform& lightToWorld,
                      const Transform& fromFile, const FileSearch& files) {
    const LightMaker make = findMaker<LightMaker>(kLights, "light", type, params.pos(), "the light is left out");
    if (make == nullptr) return {};
    SourceLight light = make({params, lightToWorld, fromFile, files});
    params.warnUnused();
    return light;
}

AreaLightBuilder makeAreaLight(const std::string& type, const ParamSet& params, const FileSearch&) {
    const auto make = findMaker<AreaLightMaker>(kAreaLights, "area light", type, params.pos(), "shapes do not emit");
    if (make == nullptr) return {};
    AreaLightBuilder builder = make(params);
    params.warnUnused();
    return builder;
}

std::shared_ptr<const AreaLight> makeDiffuseAreaLight(const Primitive& primitive, const Emission& emission,
                                                      bool twoSided) {
    return primitive.mesh ? makeMeshAreaLight(*primitive.mesh, emission, twoSided)
                          : makeShapeAreaLight(primitive.shape, emission, twoSided);
}

}  // namespace drc::pbrt
