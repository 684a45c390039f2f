#include "pbrt/light_params.h"

#include <fmt/core.h>

#include "math/frame.h"
#include "scene/shapes/shape_sphere.h"

namespace drc::pbrt {
namespace {

// The transform's scale: the geometric mean of its scales along the axes.
float sizeOf(const Transform& t) {
    return std::cbrt(std::abs(dot(cross(t.vector(Vec3(1, 0, 0)), t.vector(Vec3(0, 1, 0))), t.vector(Vec3(0, 0, 1)))));
}

}  // namespace

float degreesBetween(const ParamSet& params, std::string_view name, float fallback, float low, float high) {
    const float value = params.getFloat(name, fallback);
    if (!(value > low && value < high))
        params.failAt(*params.find(name, {ParamType::Float}),
                      fmt::format("must be between {:g} and {:g} degrees, not {:g}", low, high, value));
    return value;
}

LightImage imageOf(const ParamSet& params, const FileSearch& files, std::string_view param, const std::string& what,
                   DecodedImage (*read)(const std::string& path)) {
    const Param* name = params.findFile(param);
    if (name == nullptr) return {};
    const SourcePos pos = name->valuePos;
    const std::string path = files.find(name->strings[0], pos, what);
    try {
        DecodedImage image = read(path);
        return {image.width, image.height, std::move(image.texels)};
    } catch (const Error& error) {
        fail(pos, error.what());
    }
}

Transform placed(const LightContext& context) {
    return context.toWorld * Transform::translate(context.params.getPoint("from", Vec3(0, 0, 0)));
}

Transform aimed(const ParamSet& params, const Transform& toWorld) {
    const Vec3 from = params.getPoint("from", Vec3(0, 0, 0)), to = params.getPoint("to", Vec3(0, 0, 1));
    const Vec3 z = normalize(to - from);
    if (z == Vec3(0, 0, 0)) fail(params.pos(), "the " + params.owner() + " has no direction: 'from' equals 'to'");
    const Frame f = Frame::fromNormal(z);
    return toWorld * Transform({f.s.x, f.t.x, f.n.x, from.x,  //
                                f.s.y, f.t.y, f.n.y, from.y,  //
                                f.s.z, f.t.z, f.n.z, from.z, 0, 0, 0, 1});
}

Vec3 distantDirection(const LightContext& context) {
    const Vec3 from = context.params.getPoint("from", Vec3(0, 0, 0));
    const Vec3 to = context.params.getPoint("to", Vec3(0, 0, 1));
    const Vec3 direction = normalize(context.toWorld.vector(from - to));
    if (direction == Vec3(0, 0, 0))
        fail(context.params.pos(), "the distant light has no direction: 'from' equals 'to'");
    return direction;
}

LightPtr distantLight(const LightContext& context, const Rgb& irradiance) {
    const Vec3 direction = distantDirection(context);
    const float angle = context.params.getFloat("angle", 0);
    if (!(angle >= 0 && angle <= 180))
        context.params.failAt(*context.params.find("angle", {ParamType::Float}),
                              fmt::format("must be from 0 to 180 degrees, not {:g}", angle));
    const LightAudience audience = audienceOf(context.params);
    if (angle > 0) return makeSunLight(direction, irradiance, angle, audience);
    // A light without extent is invisible to the camera.
    return audience == LightAudience::Camera ? nullptr : makeDistantLight(direction, irradiance);
}

SpotFalloff spotFalloff(const ParamSet& params, SpotEdge edge) {
    const float cone = params.getFloat("coneangle", 30);
    if (!(cone > 0 && cone <= 180))
        params.failAt(*params.find("coneangle", {ParamType::Float}),
                      fmt::format("must be above 0 and at most 180 degrees, not {:g}", cone));
    return {cone, params.getNonNegativeFloat("conedeltaangle", 5), edge};
}

SourceLight lampOf(const ParamSet& params, const Transform& toWorld, const Rgb& intensity, const SpotFalloff* spot) {
    const Vec3 origin = toWorld.point(Vec3(0.f));
    const float radius = params.getNonNegativeFloat("radius", 0) * sizeOf(toWorld);
    if (!(radius > 0)) return spot ? makeSpotLight(toWorld, intensity, *spot) : makePointLight(origin, intensity);
    const ShapePtr bulb = makeSphere({.objectToWorld = Transform::translate(origin), .radius = radius});
    EmissionProfile profile;
    if (spot) profile = EmissionProfile({normalize(toWorld.vector(Vec3(0, 0, 1))), *spot});
    return {makeShapeAreaLight(bulb, Emission(intensity / (kPi * sqr(radius))).with(profile), false), bulb};
}

LightAudience audienceOf(const ParamSet& params) {
    const bool camera = params.getBool("visibletocamera", true), others = params.getBool("illuminates", true);
    if (!camera && !others)
        fail(params.pos(),
             "the " + params.owner() + " is seen by nothing: one of 'visibletocamera' and 'illuminates' must be true");
    if (!others) return LightAudience::Camera;
    return camera ? LightAudience::All : LightAudience::Surfaces;
}

EmissionProfile emissionProfile(const ParamSet& params) {
    const float spread = params.getFloat("spread", 180);
    if (!(spread > 0 && spread <= 180))
        params.failAt(*params.find("spread", {ParamType::Float}),
                      fmt::format("must be above 0 and at most 180 degrees, not {:g}", spread));
    return EmissionProfile::narrowed(spread);
}

}  // namespace drc::pbrt
