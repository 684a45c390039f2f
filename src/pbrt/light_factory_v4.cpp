#include "pbrt/light_factory_v4.h"

#include <fmt/core.h>

#include "pbrt/equal_area_image.h"
#include "pbrt/light_factory.h"
#include "pbrt/light_params.h"
#include "pbrt/registry.h"
#include "scene/lights/portal.h"

namespace drc::pbrt {
namespace {

float scaleOf(const ParamSet& params) { return params.getNonNegativeFloat("scale", 1); }

// The factor for a light's colour: "scale" or, if the parameter `target` ("power" or "illuminance") is given, "scale" *
// target / own. own: the light's power or illuminance if its colour is white. As in pbrt the actual colour is not
// considered, so a colour of half the luminance gives half of the target.
float brightness(const ParamSet& params, std::string_view target, double own) {
    const float wanted = params.getFloat(target, -1);
    if (!(wanted > 0)) return scaleOf(params);
    if (!(own > 0))
        fail(params.pos(), "the picture of " + params.owner() + " is black: it cannot have the '" +
                               std::string(target) + "' that is asked for");
    return scaleOf(params) * float(wanted / own);
}

double meanLuminance(const LightImage& image) {
    double sum = 0;
    for (const Rgb& c : image.texels) sum += double(luminance(c));
    return sum / double(image.texels.size());
}

// pbrt-v4's equal-area image of all directions, converted to the layout of our lights; empty if the light has no image.
LightImage sphereOf(const LightContext& context, const std::string& what) {
    LightImage image = imageOf(context.params, context.files, "filename", what, readLinear);
    if (image.empty()) return image;
    if (image.width != image.height)
        fail(context.params.find("filename", {ParamType::String})->valuePos,
             fmt::format("the {} has {} x {} pixels; pbrt-v4 takes square ones alone, in the equal-area layout: "
                         "'imgtool makeequiarea' makes them from pictures by longitude and latitude",
                         what, image.width, image.height));
    image.mend();
    return image;
}

SourceLight makePoint(const LightContext& context) {
    const ParamSet& params = context.params;
    const float scale = brightness(params, "power", 4 * double(kPi));
    return lampOf(params, placed(context), params.getColor("I", Rgb(1.f)) * scale, nullptr);
}

SourceLight makeDistant(const LightContext& context) {
    const float scale = brightness(context.params, "illuminance", 1);
    return distantLight(context, context.params.getColor("L", Rgb(1.f)) * scale);
}

SourceLight makeSpot(const LightContext& context) {
    const ParamSet& params = context.params;
    const Rgb intensity = params.getColor("I", Rgb(1.f));
    const SpotFalloff falloff = spotFalloff(params, SpotEdge::Smooth);
    const float scale = brightness(params, "power", double(falloff.solidAngle()));
    return lampOf(params, aimed(params, context.toWorld), intensity * scale, &falloff);
}

SourceLight makeGoniometric(const LightContext& context) {
    LightImage image = sphereOf(context, "goniometric diagram");
    const double mean = image.empty() ? 1 : meanLuminance(image);
    const float scale = brightness(context.params, "power", 4 * double(kPi) * mean);
    // The image contains intensities, so colours are replaced by the mean of their channels.
    for (Rgb& c : image.texels) c = Rgb((c.x + c.y + c.z) / 3);
    // In both formats, the diagram's pole is the light's +y axis.
    return makeGoniometricLight(context.toWorld, context.params.getColor("I", Rgb(1.f)) * scale,
                                latLongFromEqualArea(image));
}

SourceLight makeProjection(const LightContext& context) {
    const ParamSet& params = context.params;
    const float fov = degreesBetween(params, "fov", 90, 0, 180);
    LightImage image = imageOf(context.params, context.files, "filename", "picture to project", readLinear);
    if (image.empty()) fail(params.pos(), "the projection light needs the parameter \"string filename\"");
    image.mend();
    // The image is upright: its upper edge is towards the light's +y axis.
    const LightImage upright = flippedTopToBottom(std::move(image));
    const double white = double(luminance(makeProjectionLight({}, Rgb(1.f), fov, upright)->power(0)));
    return makeProjectionLight(context.toWorld, Rgb(brightness(params, "power", white)), fov, upright);
}

// The corners of the portal; none without one. As in pbrt, the file gives them in world space, whatever the current
// transformation.
std::optional<std::array<Vec3, 4>> portalOf(const LightContext& context) {
    const Param* portal = context.params.find("portal", {ParamType::Point3});
    if (portal == nullptr) return {};
    if (portal->count() != 4)
        context.params.failAt(
            *portal, fmt::format("must have the 4 corners of a rectangle, in order, found {} points", portal->count()));
    std::array<Vec3, 4> corners;
    for (size_t i = 0; i < 4; ++i) corners[i] = context.fromFile.point(vec3At(portal->numbers, i));
    if (const std::string flaw = Portal::flawOf(corners); !flaw.empty())
        context.params.failAt(*portal, "must have the corners of a rectangle, in order: " + flaw);
    return corners;
}

SourceLight makeInfinite(const LightContext& context) {
    const ParamSet& params = context.params;
    const LightImage square = sphereOf(context, "environment map");
    if (!square.empty() && params.find("L", {ParamType::Color}) != nullptr)
        fail(params.pos(), "the infinite light has both 'L' and 'filename'; give the one or the other");
    const double own = square.empty() ? double(kPi) : horizontalIlluminance(square);
    const Rgb radiance = params.getColor("L", Rgb(1.f)) * brightness(params, "illuminance", own);
    LightPtr environment =
        makeInfiniteLight(context.toWorld, radiance, latLongFromEqualArea(square), audienceOf(params));
    const auto portal = portalOf(context);
    return portal ? makePortalLight(std::move(environment), *portal) : environment;
}

using LightMaker = SourceLight (*)(const LightContext&);
constexpr Registered<LightMaker> kLights[] = {
    {"distant", makeDistant}, {"goniometric", makeGoniometric}, {"infinite", makeInfinite},
    {"point", makePoint},     {"projection", makeProjection},   {"spot", makeSpot},
};

// Power of a shape, or of a mesh's average triangle, at a radiance of 1. In pbrt each triangle of a mesh is a light
// that emits the full "power". Here the mesh emits the same total, spread evenly over its area.
double emittedByWhite(const Primitive& primitive) {
    if (primitive.shape) return double(primitive.shape->area()) * double(kPi);
    double area = 0;
    for (uint32_t i = 0; i < primitive.mesh->triangleCount(); ++i) area += double(primitive.mesh->area(i));
    return area / std::max(1u, primitive.mesh->triangleCount()) * double(kPi);
}

// The image of an area light; null if it has none.
std::shared_ptr<const EmissionImage> emissionImageOf(const ParamSet& params, const FileSearch& files) {
    LightImage image = imageOf(params, files, "filename", "picture that is emitted", readLinear);
    if (image.empty()) return nullptr;
    if (params.find("L", {ParamType::Color}) != nullptr)
        fail(params.pos(), "the area light has both 'L' and 'filename'; give the one or the other");
    // The image's lower left corner is at (u, v) = (0, 0).
    return std::make_shared<const EmissionImage>(flippedTopToBottom(std::move(image)));
}

AreaLightBuilder makeDiffuse(const ParamSet& params, const FileSearch& files) {
    const bool twoSided = params.getBool("twosided", false);
    const float power = params.getFloat("power", -1);
    const EmissionProfile profile = emissionProfile(params);
    const auto image = emissionImageOf(params, files);
    const Rgb scale = params.getColor("L", Rgb(1.f)) * scaleOf(params);
    // As in pbrt, "power" refers to the whole image, whatever part of it a shape shows.
    const double ofImage = image ? double(luminance(image->mean())) : 1;
    if (power > 0 && !(ofImage > 0))
        fail(params.pos(),
             "the picture of " + params.owner() + " is black: it cannot have the 'power' that is asked for");
    if (isBlack(scale) || !(ofImage > 0)) return {};
    return [=](const Primitive& primitive) -> std::shared_ptr<const AreaLight> {
        const double own = power > 0 ? emittedByWhite(primitive) * (twoSided ? 2 : 1) * ofImage : 0;
        const Rgb scaled = own > 0 ? scale * float(double(power) / own) : scale;
        const Emission emission = image ? Emission(image, scaled) : Emission(scaled);
        return makeDiffuseAreaLight(primitive, emission.with(profile), twoSided);
    };
}

using AreaLightMaker = AreaLightBuilder (*)(const ParamSet&, const FileSearch&);
constexpr Registered<AreaLightMaker> kAreaLights[] = {{"diffuse", makeDiffuse}};

}  // namespace

SourceLight makeLightV4(const std::string& type, const ParamSet& params, const Transform& lightToWorld,
                        const Transform& fromFile, const FileSearch& files) {
    const LightMaker make = findMaker<LightMaker>(kLights, "light", type, params.pos(), "the light is left out");
    SourceLight light = make({params, lightToWorld, fromFile, files});
    params.warnUnused();
    return light;
}

AreaLightBuilder makeAreaLightV4(const std::string& type, const ParamSet& params, const FileSearch& files) {
    const auto make = findMaker<AreaLightMaker>(kAreaLights, "area light", type, params.pos(), "shapes do not emit");
    AreaLightBuilder builder = make(params, files);
    params.warnUnused();
    return builder;
}

}  // namespace drc::pbrt
