#include "pbrt/light_factory.h"

#include <fmt/core.h>

#include "base/log.h"
#include "math/frame.h"
#include "pbrt/decoded_image.h"
#include "pbrt/registry.h"

namespace drc::pbrt {
namespace {

struct LightContext {
    const ParamSet& params;
    const Transform& toWorld;
    const FileSearch& files;
};

// pbrt multiplies every light's colour by this one.
Rgb scaleOf(const ParamSet& params) { return params.getColor("scale", Rgb(1.f)); }

// pbrt's number of samples a light: here every sample of a pixel chooses one light by what it can bring.
void samplesNotNeeded(const ParamSet& params) {
    if (!params.has("samples") && !params.has("nsamples")) return;
    params.ignore({"samples", "nsamples"});
    logDebug(params.owner() + ": its number of samples is not needed: lights are sampled by what they bring");
}

// Throws Error unless low < value < high.
float between(const ParamSet& params, std::string_view name, float fallback, float low, float high) {
    const float value = params.getFloat(name, fallback);
    if (!(value > low && value < high))
        params.failAt(*params.find(name, {ParamType::Float}),
                      fmt::format("must be between {:g} and {:g} degrees, not {:g}", low, high, value));
    return value;
}

// The picture that the parameter "mapname" names; empty if there is none.
LightImage mapOf(const LightContext& context, const std::string& what) {
    const std::string name = context.params.getString("mapname", "");
    if (name.empty()) return {};
    const SourcePos pos = context.params.find("mapname", {ParamType::String})->valuePos;
    const std::string path = context.files.find(name, pos, what);
    try {
        DecodedImage image = readLinear(path);
        return {image.width, image.height, std::move(image.texels)};
    } catch (const Error& error) {
        fail(pos, error.what());
    }
}

LightPtr makePoint(const LightContext& context) {
    const Rgb intensity = context.params.getColor("I", Rgb(1.f)) * scaleOf(context.params);
    return makePointLight(context.toWorld.point(context.params.getPoint("from", Vec3(0, 0, 0))), intensity);
}

LightPtr makeDistant(const LightContext& context) {
    const Rgb radiance = context.params.getColor("L", Rgb(1.f)) * scaleOf(context.params);
    const Vec3 from = context.params.getPoint("from", Vec3(0, 0, 0));
    const Vec3 to = context.params.getPoint("to", Vec3(0, 0, 1));
    const Vec3 direction = normalize(context.toWorld.vector(from - to));
    if (direction == Vec3(0, 0, 0))
        fail(context.params.pos(), "the distant light has no direction: 'from' equals 'to'");
    return makeDistantLight(direction, radiance);
}

// A space whose origin is `from` and whose +z points to `to`.
Transform aimed(const ParamSet& params, const Transform& toWorld) {
    const Vec3 from = params.getPoint("from", Vec3(0, 0, 0)), to = params.getPoint("to", Vec3(0, 0, 1));
    const Vec3 z = normalize(to - from);
    if (z == Vec3(0, 0, 0)) fail(params.pos(), "the " + params.owner() + " has no direction: 'from' equals 'to'");
    const Frame f = Frame::fromNormal(z);
    return toWorld * Transform({f.s.x, f.t.x, f.n.x, from.x,  //
                                f.s.y, f.t.y, f.n.y, from.y,  //
                                f.s.z, f.t.z, f.n.z, from.z, 0, 0, 0, 1});
}

LightPtr makeSpot(const LightContext& context) {
    const Rgb intensity = context.params.getColor("I", Rgb(1.f)) * scaleOf(context.params);
    const float cone = between(context.params, "coneangle", 30, 0, 180);
    const float fade = context.params.getFloat("conedeltaangle", 5);
    if (!(fade >= 0))
        context.params.failAt(*context.params.find("conedeltaangle", {ParamType::Float}), "must not be negative");
    return makeSpotLight(aimed(context.params, context.toWorld), intensity, cone, fade);
}

LightPtr makeGoniometric(const LightContext& context) {
    const Rgb intensity = context.params.getColor("I", Rgb(1.f)) * scaleOf(context.params);
    return makeGoniometricLight(context.toWorld, intensity, mapOf(context, "goniometric diagram"));
}

LightPtr makeProjection(const LightContext& context) {
    const Rgb intensity = context.params.getColor("I", Rgb(1.f)) * scaleOf(context.params);
    const float fov = between(context.params, "fov", 45, 0, 180);
    return makeProjectionLight(context.toWorld, intensity, fov, mapOf(context, "picture to project"));
}

LightPtr makeInfinite(const LightContext& context) {
    const Rgb radiance = context.params.getColor("L", Rgb(1.f)) * scaleOf(context.params);
    samplesNotNeeded(context.params);
    return makeInfiniteLight(context.toWorld, radiance, mapOf(context, "environment map"));
}

using LightMaker = LightPtr (*)(const LightContext&);
constexpr Registered<LightMaker> kLights[] = {
    {"distant", makeDistant},   {"exinfinite", makeInfinite}, {"goniometric", makeGoniometric},
    {"infinite", makeInfinite}, {"point", makePoint},         {"projection", makeProjection},
    {"spot", makeSpot},
};

AreaLightBuilder makeDiffuse(const ParamSet& params) {
    const Rgb radiance = params.getColor("L", Rgb(1.f)) * scaleOf(params);
    const bool twoSided = params.getBool("twosided", false);
    samplesNotNeeded(params);
    if (isBlack(radiance)) return {};
    return [=](const Primitive& primitive) {
        return primitive.mesh ? makeMeshAreaLight(*primitive.mesh, radiance, twoSided)
                              : makeShapeAreaLight(primitive.shape, radiance, twoSided);
    };
}

using AreaLightMaker = AreaLightBuilder (*)(const ParamSet&);
constexpr Registered<AreaLightMaker> kAreaLights[] = {
    {"area", makeDiffuse},  // pbrt's old name
    {"diffuse", makeDiffuse},
};

}  // namespace

LightPtr makeLight(const std::string& type, const ParamSet& params, const Transform& lightToWorld,
                   const FileSearch& files) {
    const LightMaker make = findMaker<LightMaker>(kLights, "light", type, params.pos(), "the light is left out");
    if (make == nullptr) return nullptr;
    LightPtr light = make({params, lightToWorld, files});
    params.warnUnused();
    return light;
}

AreaLightBuilder makeAreaLight(const std::string& type, const ParamSet& params) {
    const auto make = findMaker<AreaLightMaker>(kAreaLights, "area light", type, params.pos(), "shapes do not emit");
    if (make == nullptr) return {};
    AreaLightBuilder builder = make(params);
    params.warnUnused();
    return builder;
}

}  // namespace drc::pbrt
