#include "pbrt/camera_override.h"

#include <cmath>
#include <utility>

#include "base/limits.h"
#include "pbrt/graphics_state.h"
#include "pbrt/param_set.h"

namespace drc::pbrt {

std::string LookAt::fault() const {
    const Vec3 direction = look - eye;
    for (const Vec3& v : {eye, look, up})
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(v[i]) <= limits::kCoordinate)) return "a coordinate is beyond 1e18";
    if (direction == Vec3(0.f)) return "it looks from a point to the same point; the second must be another";
    if (up == Vec3(0.f)) return "the up vector, the last three numbers, is zero; it may be 0 1 0";
    if (length(cross(normalize(up), normalize(direction))) < 1e-6f)
        return "it looks along its up vector, the last three numbers; choose another up vector";
    return "";
}

TransformSet CameraOverride::placed(const TransformSet& worldToCamera) const {
    if (!lookAt) return worldToCamera;
    Transform there = Transform::lookAt(lookAt->eye, lookAt->look, lookAt->up);
    if (there.swapsHandedness() != worldToCamera.start().swapsHandedness()) there = Transform::scale(-1, 1, 1) * there;
    return {{there, there}};
}

void CameraOverride::applyFov(const std::string& type, ParamSet& params) const {
    if (!fov) return;
    if (type != "perspective")
        fail(params.pos(), "--fov: the camera '" + type + "' has no field of view; only 'perspective' has");
    const auto replace = [&](const char* name, double value) {
        Param p;
        p.typeName = "float";
        p.name = name;
        p.pos = p.valuePos = params.pos();
        p.numbers = {value};
        params.replace(std::move(p));
    };
    replace("fov", double(*fov));
    replace("halffov", -1);  // otherwise it would override "fov"
}

}  // namespace drc::pbrt
