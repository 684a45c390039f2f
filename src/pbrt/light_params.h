// Parameters of lights that both dialects read in the same way.
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
// defines the meaning of the file's values.
LightImage imageOf(const ParamSet& params, const FileSearch& files, std::string_view param, const std::string& what,
                   DecodedImage (*read)(const std::string& path));

// A light space with its origin at `from`.
Transform placed(const LightContext& context);
// A light space with its origin at `from` and its +z axis towards `to`.
Transform aimed(const ParamSet& params, const Transform& toWorld);

// Direction from lit points towards a distant light, world space.
Vec3 distantDirection(const LightContext& context);
// A distant light of this irradiance on a surface that faces it; with DRC's own parameter "float angle", the diameter
// in degrees that it is seen under.
LightPtr distantLight(const LightContext& context, const Rgb& irradiance);

SpotFalloff spotFalloff(const ParamSet& params, SpotEdge edge);

// A point or spot light at the origin of its space that shines along +z, of this intensity. spot: null for a point
// light. With DRC's own parameter "float radius", it is a sphere of the same intensity, each point of which has the
// spot's profile: the shadows are soft, and `bulb` is set.
SourceLight lampOf(const ParamSet& params, const Transform& toWorld, const Rgb& intensity, const SpotFalloff* spot);

// DRC's own parameters "bool visibletocamera" and "bool illuminates" of distant and infinite lights.
LightAudience audienceOf(const ParamSet& params);
// Emission narrowed by DRC's own area light parameter "float spread", in degrees in (0, 180]; 180 if absent.
EmissionProfile emissionProfile(const ParamSet& params);

}  // namespace drc::pbrt
