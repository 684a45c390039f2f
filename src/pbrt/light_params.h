// Light parameters with the same meaning in both dialects.
#pragma once
#include <string>

#include "pbrt/decoded_image.h"
#include "pbrt/file_search.h"
#include "pbrt/light_factory.h"
#include "pbrt/param_set.h"
#include "scene/lights/light.h"

namespace drc::pbrt {

struct LightContext {
    const ParamSet& params;
    const Transform& toWorld;
    const Transform& fromFile;  // for points that the file gives in its world space
    const FileSearch& files;
};

// The parameter's value. Throws Error unless low < value < high.
float degreesBetween(const ParamSet& params, std::string_view name, float fallback, float low, float high);

// The image that a parameter names; empty if there is none. `what` is used in messages: "environment map". `read`
// determines how the file's values are interpreted.
LightImage imageOf(const ParamSet& params, const FileSearch& files, std::string_view param, const std::string& what,
                   DecodedImage (*read)(const std::string& path));

// The light's space with its origin at `from`, to world.
Transform placed(const LightContext& context);
// The light's space with its origin at `from` and its +z axis towards `to`, to world.
Transform aimed(const ParamSet& params, const Transform& toWorld);

// Direction from lit points towards a distant light; unit length, world space.
Vec3 distantDirection(const LightContext& context);
// A distant light with this irradiance on a surface that faces it. DRC's own parameter "float angle" sets the angular
// diameter of the light, in degrees.
LightPtr distantLight(const LightContext& context, const Rgb& irradiance);

SpotFalloff spotFalloff(const ParamSet& params, SpotEdge edge);

// A point or spot light of this intensity at the origin of its space; spots shine along +z. spot: null for a point
// light. DRC's own parameter "float radius" makes it a sphere of the same intensity, each point of which has the spot's
// profile. Shadows are then soft, and `bulb` is set.
SourceLight lampOf(const ParamSet& params, const Transform& toWorld, const Rgb& intensity, const SpotFalloff* spot);

// DRC's own parameters "bool visibletocamera" and "bool illuminates" of distant and infinite lights.
LightAudience audienceOf(const ParamSet& params);
// The emission profile of DRC's own area light parameter "float spread", in degrees in (0, 180]; 180 if absent.
EmissionProfile emissionProfile(const ParamSet& params);

}  // namespace drc::pbrt
