#include "pbrt/camera_factory.h"

#include <utility>

#include "base/log.h"
#include "pbrt/lens_file.h"
#include "pbrt/registry.h"

namespace drc::pbrt {
namespace {

struct CameraContext {
    const ParamSet& params;
    const CameraMotion& motion;
    const FilmGeometry& film;
    const FileSearch& files;
};

Shutter shutterOf(const CameraContext& context) {
    const ParamSet& params = context.params;
    const auto [start, end] = context.motion.transformTimes;
    Shutter shutter{params.getFloat("shutteropen", 0), params.getFloat("shutterclose", 1), start, end};
    if (shutter.close < shutter.open) {
        warn(params.pos(), "the camera's shutter closes before it opens; the two times are swapped");
        std::swap(shutter.open, shutter.close);
    }
    return shutter;
}

// The parameters shared by perspective and orthographic cameras.
ProjectiveCameraParams projectiveParams(const CameraContext& context) {
    const ParamSet& params = context.params;
    ProjectiveCameraParams p;
    p.worldToCamera = context.motion.worldToCamera;
    p.lensRadius = params.getFloat("lensradius", 0);
    p.focalDistance = params.getFloat("focaldistance", 1e6f);
    if (!(p.lensRadius >= 0)) fail(params.pos(), "the camera's lens radius must not be negative");
    if (p.lensRadius > 0 && !(p.focalDistance > 0)) fail(params.pos(), "the camera's focal distance must be positive");
    p.shutter = shutterOf(context);
    p.frameAspectRatio = params.getFloat("frameaspectratio", 0);
    if (!(p.frameAspectRatio >= 0)) fail(params.pos(), "the camera's frame aspect ratio must be positive");
    if (const Param* window = params.find("screenwindow", {ParamType::Float})) {
        if (window->numbers.size() != 4) params.failAt(*window, "must have four values of type 'float'");
        p.hasScreenWindow = true;
        for (size_t i = 0; i < 4; ++i) p.screenWindow[i] = float(window->numbers[i]);
        if (p.screenWindow[0] == p.screenWindow[1] || p.screenWindow[2] == p.screenWindow[3])
            params.failAt(*window, "is empty");
    }
    return p;
}

std::unique_ptr<Camera> makePerspective(const CameraContext& context) {
    const ParamSet& params = context.params;
    ProjectiveCameraParams p = projectiveParams(context);
    p.fov = params.getFloat("fov", 90);
    const float half = params.getFloat("halffov", -1);
    if (half > 0) p.fov = 2 * half;
    if (!(p.fov > 0 && p.fov < 180)) fail(params.pos(), "the camera's field of view must be between 0 and 180 degrees");
    return makePerspectiveCamera(p, context.film);
}

std::unique_ptr<Camera> makeOrthographic(const CameraContext& context) {
    return makeOrthographicCamera(projectiveParams(context), context.film);
}

std::unique_ptr<Camera> makeEnvironment(const CameraContext& context) {
    EnvironmentCameraParams p;
    p.worldToCamera = context.motion.worldToCamera;
    p.shutter = shutterOf(context);
    for (const char* name : {"lensradius", "focaldistance", "frameaspectratio", "screenwindow"}) {
        if (!context.params.has(name)) continue;
        context.params.ignore({name});
        logDebug(std::string("camera 'environment' sees all directions from one point: '") + name +
                 "' has no effect, as in pbrt");
    }
    return makeEnvironmentCamera(p, context.film);
}

// pbrt-v4's spherical camera. Only its lat-long mapping is supported.
std::unique_ptr<Camera> makeSpherical(const CameraContext& context) {
    const std::string mapping = context.params.getString("mapping", "equalarea");
    if (mapping != "equalarea" && mapping != "equirectangular")
        context.params.failAt(*context.params.find("mapping", {ParamType::String}),
                              "must be 'equalarea' or 'equirectangular', not '" + mapping + "'");
    if (mapping == "equalarea")
        warn(context.params.pos(),
             "the mapping 'equalarea' of the spherical camera is not supported yet; 'equirectangular' is used");
    return makeEnvironment(context);
}

// simpleWeighting: pbrt-v3 scenes may choose it by a parameter; pbrt-v4 has only the other kind of weighting.
std::unique_ptr<Camera> makeLensCamera(const CameraContext& context, bool simpleWeighting) {
    const ParamSet& params = context.params;
    RealisticCameraParams p;
    p.worldToCamera = context.motion.worldToCamera;
    p.shutter = shutterOf(context);
    const float stop = params.getFloat("aperturediameter", 1);
    if (!(stop > 0)) params.failAt(*params.find("aperturediameter", {ParamType::Float}), "must be positive");
    p.focusDistance = params.getFloat("focusdistance", 10);
    if (!(p.focusDistance > 0)) params.failAt(*params.find("focusdistance", {ParamType::Float}), "must be positive");
    p.simpleWeighting = simpleWeighting;
    const Param& lens = params.needFile("lensfile");
    const SourcePos pos = lens.valuePos;
    const std::string path = context.files.find(lens.strings[0], pos, "lens file");
    p.lens = placedAt(pos, [&] { return readLensFile(path, stop); });
    try {
        return makeRealisticCamera(p, context.film);
    } catch (const Error& error) {
        fail(params.pos(), error.what());
    }
}

std::unique_ptr<Camera> makeRealistic(const CameraContext& context) {
    return makeLensCamera(context, context.params.getBool("simpleweighting", true));
}

std::unique_ptr<Camera> makeRealisticV4(const CameraContext& context) {
    if (context.params.getString("aperture", "circular") != "circular")
        warn(context.params.find("aperture", {ParamType::String})->valuePos,
             "the aperture '" + context.params.getString("aperture", "") + "' is not supported yet; it is a circle");
    return makeLensCamera(context, false);
}

using CameraMaker = std::unique_ptr<Camera> (*)(const CameraContext&);
constexpr Registered<CameraMaker> kCameras[] = {
    {"environment", makeEnvironment},
    {"orthographic", makeOrthographic},
    {"perspective", makePerspective},
    {"realistic", makeRealistic},
};

constexpr Registered<CameraMaker> kCamerasV4[] = {
    {"orthographic", makeOrthographic},
    {"perspective", makePerspective},
    {"realistic", makeRealisticV4},
    {"spherical", makeSpherical},
};

std::unique_ptr<Camera> make(std::span<const Registered<CameraMaker>> table, const std::string& type,
                             const CameraContext& context) {
    auto camera = findMaker<CameraMaker>(table, "camera", type, context.params.pos(), "")(context);
    context.params.warnUnused();
    return camera;
}

}  // namespace

std::unique_ptr<Camera> makeCamera(const std::string& type, const ParamSet& params, const CameraMotion& motion,
                                   const FilmGeometry& film, const FileSearch& files) {
    return make(kCameras, type, {params, motion, film, files});
}

std::unique_ptr<Camera> makeCameraV4(const std::string& type, const ParamSet& params, const CameraMotion& motion,
                                     const FilmGeometry& film, const FileSearch& files) {
    return make(kCamerasV4, type, {params, motion, film, files});
}

float exposureTimeV4(const ParamSet& camera) {
    const float time = camera.getFloat("shutterclose", 1) - camera.getFloat("shutteropen", 0);
    if (!(time > 0)) fail(camera.pos(), "the camera's shutter must close after it opens; the picture would be black");
    return time;
}

}  // namespace drc::pbrt
