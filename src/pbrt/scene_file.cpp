#include "pbrt/scene_file.h"

#include <cmath>

#include "base/warning_batch.h"
#include "pbrt/kept_contents.h"
#include "pbrt/parser.h"

namespace drc::pbrt {
namespace {

// A scene whose centre is farther from zero along an axis than this many of its radii gets a new origin on that axis.
constexpr float kFarInRadii = 4;

// The bounds of the scene in the coordinates of its file.
Bounds boundsInFile(const Scene& scene) {
    Bounds bounds = scene.bounds();
    if (!bounds.empty()) {
        bounds.min += scene.origin;
        bounds.max += scene.origin;
    }
    return bounds;
}

// The origin for a scene with these bounds, by axis: zero, or near the scene's centre if that is far away. It is a
// multiple of a power of two that is at least the scene's radius, so that coordinates lose no bits, and the frames of
// an animation get the same origin.
Vec3 originOf(const Bounds& bounds) {
    Vec3 origin(0.f);
    if (bounds.empty() || !(bounds.radius() > 0)) return origin;
    const float step = std::exp2(std::ceil(std::log2(bounds.radius())));
    for (int i = 0; i < 3; ++i)
        if (const float c = bounds.center()[i]; std::abs(c) > kFarInRadii * bounds.radius())
            origin[i] = step * std::round(c / step);
    return origin;
}

std::unique_ptr<Scene> load(const std::shared_ptr<const Source>& source, const LoadOptions& options) {
    std::unique_ptr<Scene> scene;
    // The frames of an animation have the same origin, unless the scene's bounds change much.
    const Vec3 likely = options.kept ? options.kept->origin().value_or(Vec3(0.f)) : Vec3(0.f);
    {
        const WarningBatch warnings;
        scene = Parser(source, likely).parse(options);
    }
    const Vec3 origin = originOf(boundsInFile(*scene));
    if (origin == likely) return scene;
    // Reads the file again instead of moving the scene, because its positions have already been rounded to floats.
    scene.reset();
    return Parser(source, origin).parse(options);
}

}  // namespace

std::unique_ptr<Scene> loadPbrtFile(const std::string& path, const LoadOptions& options) {
    return load(Source::open(path), options);
}

std::unique_ptr<Scene> loadPbrtCamera(const std::string& path, const Vec3& origin, const LoadOptions& options) {
    const WarningBatch warnings;
    return Parser(Source::fromFile(path), origin).parseCamera(options);
}

std::unique_ptr<Scene> loadPbrtString(const std::string& text, const std::string& directory, const LoadOptions& options,
                                      const std::string& name) {
    return load(Source::fromText(text, name, directory), options);
}

}  // namespace drc::pbrt
