#include "pbrt/light_factory.h"

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

EnvironmentMap readEnvironment(const std::string& path, const SourcePos& pos) {
    try {
        DecodedImage image = readLinear(path);
        return {image.width, image.height, std::move(image.texels)};
    } catch (const Error& error) {
        fail(pos, error.what());
    }
}

LightPtr makeInfinite(const LightContext& context) {
    const Rgb radiance = context.params.getColor("L", Rgb(1.f)) * scaleOf(context.params);
    context.params.ignore({"samples", "nsamples"});
    EnvironmentMap map;
    const std::string name = context.params.getString("mapname", "");
    if (!name.empty()) {
        const SourcePos pos = context.params.find("mapname", {ParamType::String})->valuePos;
        map = readEnvironment(context.files.find(name, pos, "environment map"), pos);
    }
    return makeInfiniteLight(context.toWorld, radiance, std::move(map));
}

using LightMaker = LightPtr (*)(const LightContext&);
constexpr Registered<LightMaker> kLights[] = {
    {"distant", makeDistant}, {"exinfinite", makeInfinite}, {"goniometric", nullptr}, {"infinite", makeInfinite},
    {"point", makePoint},     {"projection", nullptr},      {"spot", nullptr},
};

AreaLightBuilder makeDiffuse(const ParamSet& params) {
    const Rgb radiance = params.getColor("L", Rgb(1.f)) * scaleOf(params);
    const bool twoSided = params.getBool("twosided", false);
    params.ignore({"samples", "nsamples"});
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
