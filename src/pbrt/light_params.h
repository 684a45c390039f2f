// What the lights of both dialects read in the same way.
#pragma once
#include <string>

#include "pbrt/decoded_image.h"
#include "pbrt/file_search.h"
#include "pbrt/param_set.h"
#include "scene/light.h"

namespace drc::pbrt {

struct LightContext {
    const ParamSet& params;
    const Transform& toWorld;
    const FileSearch& files;
};

// Throws Error unless low < value < high.
float degreesBetween(const ParamSet& params, std::string_view name, float fallback, float low, float high);

// The picture that the parameter names; empty if there is none. what is for messages: "environment map". read says what
// the numbers of the file mean.
LightImage imageOf(const LightContext& context, std::string_view param, const std::string& what,
                   DecodedImage (*read)(const std::string& path));

// A space whose origin is `from` and whose +z points to `to`.
Transform aimed(const ParamSet& params, const Transform& toWorld);

// From the lit points towards a distant light, world space.
Vec3 distantDirection(const LightContext& context);

// Degrees from the axis to a spotlight's edge, and how many of them fade.
struct SpotAngles {
    float cone, fade;
};
SpotAngles spotAngles(const ParamSet& params);

}  // namespace drc::pbrt
