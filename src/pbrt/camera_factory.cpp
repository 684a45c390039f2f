#include "pbrt/camera_factory.h"

#include <utility>

#include "pbrt/registry.h"

namespace drc::pbrt {
namespace {

struct CameraContext {
    const ParamSet& params;
    const Transform& worldToCamera;
    const FilmGeometry& film;
};

std::unique_ptr<Camera> makePerspective(const CameraContext& context) {
    const ParamSet& params = context.params;
    PerspectiveParams p;
    p.worldToCamera = context.worldToCamera;
    p.fov = params.getFloat("fov", 90);
    const float half = params.getFloat("halffov", -1);
    if (half > 0) p.fov = 2 * half;
    if (!(p.fov > 0 && p.fov < 180)) fail(params.pos(), "the camera's field of view must be between 0 and 180 degrees");
    p.lensRadius = params.getFloat("lensradius", 0);
    p.focalDistance = params.getFloat("focaldistance", 1e6f);
    if (!(p.lensRadius >= 0)) fail(params.pos(), "the camera's lens radius must not be negative");
    if (p.lensRadius > 0 && !(p.focalDistance > 0)) fail(params.pos(), "the camera's focal distance must be positive");
    p.shutterOpen = params.getFloat("shutteropen", 0);
    p.shutterClose = params.getFloat("shutterclose", 1);
    if (p.shutterClose < p.shutterOpen) {
        warn(params.pos(), "the camera's shutter closes before it opens; the two times are swapped");
        std::swap(p.shutterOpen, p.shutterClose);
    }
    p.frameAspectRatio = params.getFloat("frameaspectratio", 0);
    if (!(p.frameAspectRatio >= 0)) fail(params.pos(), "the camera's frame aspect ratio must be positive");
    if (const Param* window = params.find("screenwindow", {ParamType::Float})) {
        if (window->numbers.size() != 4) params.failAt(*window, "must have four values of type 'float'");
        p.hasScreenWindow = true;
        for (size_t i = 0; i < 4; ++i) p.screenWindow[i] = float(window->numbers[i]);
        if (p.screenWindow[0] == p.screenWindow[1] || p.screenWindow[2] == p.screenWindow[3])
            params.failAt(*window, "is empty");
    }
    return makePerspectiveCamera(p, context.film);
}

using CameraMaker = std::unique_ptr<Camera> (*)(const CameraContext&);
constexpr Registered<CameraMaker> kCameras[] = {
    {"environment", nullptr},
    {"orthographic", nullptr},
    {"perspective", makePerspective},
    {"realistic", nullptr},
};

}  // namespace

std::unique_ptr<Camera> makeCamera(const std::string& type, const ParamSet& params, const Transform& worldToCamera,
                                   const FilmGeometry& film) {
    const auto make = findMaker<CameraMaker>(kCameras, "camera", type, params.pos(), "a perspective camera is used");
    if (make == nullptr) {
        const ParamSet none("camera 'perspective'", params.pos());
        return makePerspective({none, worldToCamera, film});
    }
    auto camera = make({params, worldToCamera, film});
    params.warnUnused();
    return camera;
}

}  // namespace drc::pbrt
