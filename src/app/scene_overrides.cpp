#include "app/scene_overrides.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "app/command.h"
#include "app/option_checks.h"
#include "app/usage_error.h"
#include "base/log.h"
#include "scene/crop_window.h"

namespace drc {
namespace {

// Stricter than for scene files, in which pbrt allows edges in either order and beyond the film: on a command line,
// these are most often a window in pixels, or numbers in the wrong order.
CropWindow cropOf(const std::vector<double>& values) {
    const auto wrong = [&](const std::string& why) {
        return UsageError(
            fmt::format("--crop {}: {}; give x0 x1 y0 y1, from 0 to 1, with x0 < x1 and y0 < y1, as --crop 0 0.5 0 1 "
                        "for the left half",
                        fmt::join(values, " "), why));
    };
    if (std::ranges::any_of(values, [](double v) { return !(v >= 0 && v <= 1); }))
        throw wrong("the numbers are fractions of the film");
    for (size_t axis = 0; axis < 2; ++axis)
        if (!(values[2 * axis] < values[2 * axis + 1]))
            throw wrong(fmt::format("{0}0 must be less than {0}1", axis == 0 ? 'x' : 'y'));
    return asUsage([&] { return cropWindowOf(values); });
}

pbrt::LookAt lookAtOf(const std::vector<double>& v) {
    const auto point = [&](size_t i) { return Vec3(float(v[i]), float(v[i + 1]), float(v[i + 2])); };
    const pbrt::LookAt lookAt{point(0), point(3), point(6)};
    if (const std::string fault = lookAt.fault(); !fault.empty()) throw UsageError("--lookat: " + fault);
    return lookAt;
}

}  // namespace

void SceneOverrides::check() const { loadOptions(); }

pbrt::LoadOptions SceneOverrides::loadOptions() const {
    pbrt::LoadOptions load;
    if (!resolution.empty()) load.resolution = parseResolution(resolution);
    if (!crop.empty()) cropOf(crop);
    if (!lookAt.empty()) load.camera.lookAt = lookAtOf(lookAt);
    if (fov) load.camera.fov = float(*fov);
    load.overrides = parameters;
    return load;
}

void SceneOverrides::cropFilm(RenderSettings& settings) const {
    if (!crop.empty()) std::ranges::copy(cropOf(crop), settings.cropWindow);
}

std::unique_ptr<Scene> SceneOverrides::load(const std::string& path, pbrt::LoadOptions options) const {
    try {
        return pbrt::loadPbrtFile(path, options);
    } catch (const Error& error) {
        // For a wrong parameter of -D, the front end gives the option in place of a file name.
        if (error.where().file == "-D") throw UsageError(error.what());
        throw;
    }
}

void addSceneOverrides(CLI::App& command, SceneOverrides& o) {
    command.add_option("--resolution", o.resolution,
                       "WIDTHxHEIGHT of the film in pixels, in place of the scene file's");
    command
        .add_option("--crop,--cropwindow", o.crop,
                    "The part of the film to render, as x0 x1 y0 y1: fractions from 0 to 1, from the upper left corner")
        ->type_size(4)
        ->expected(1)
        ->delimiter(',')
        ->type_name("X0 X1 Y0 Y1")
        ->check(finiteNumber());
    command
        .add_option("--lookat", o.lookAt,
                    "The camera in place of the scene file's: the point where it stands, the point that it looks to, "
                    "and the direction that is up in the picture, in the file's coordinates, as in its LookAt")
        ->type_size(9)
        ->expected(1)
        ->delimiter(',')
        ->type_name("EX EY EZ LX LY LZ UX UY UZ")
        ->check(finiteNumber());
    command
        .add_option("--fov", o.fov,
                    "The angle that the shorter side of the picture shows, in degrees, in place of the scene file's")
        ->type_name("DEGREES")
        ->check(numberBetween(0, 180));
    command
        .add_option("-D", o.parameters,
                    "NAME=VALUE: replaces a parameter of the scene file's film, sampler or integrator, as "
                    "film.xresolution=640; may be repeated")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace drc
