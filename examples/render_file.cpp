// Renders a scene for so many seconds, denoises it and writes it: render_file SCENE.pbrt SECONDS PICTURE.exr
#include <cstdio>
#include <cstdlib>

#include "pbrt/scene_file.h"
#include "render/render_run.h"

int main(int, char** arguments) try {
    const auto scene = drc::pbrt::loadPbrtFile(arguments[1]);
    drc::RenderParams params;
    params.seconds = std::atof(arguments[2]);
    const drc::ChosenDenoiser denoiser = drc::chooseDenoiser(params, scene->sensor.settings);
    drc::Session session(*scene, params);
    drc::PictureWriter writer(session.sensor().settings, {arguments[3]});
    drc::PictureFinisher finisher(drc::filtersFor(session.params(), denoiser), writer);
    drc::runPasses(session, finisher);
    finisher.finish(session.picture());
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
