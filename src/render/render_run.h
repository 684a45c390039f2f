// Runs the passes of a picture, from the first to the last. "Load, render for 30 s, denoise, write" is:
//
//     const auto scene = pbrt::loadPbrtFile("room.pbrt");
//     RenderParams params;
//     params.seconds = 30;
//     const ChosenDenoiser denoiser = chooseDenoiser(params, scene->sensor.settings);
//     Session session(*scene, params);
//     PictureWriter writer(session.sensor().settings, {"room.png", "room.exr"});
//     PictureFinisher finisher(filtersFor(session.params(), denoiser), writer);
//     runPasses(session, finisher);
//     finisher.finish(session.picture());
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "render/checkpoint_writer.h"
#include "render/picture_finisher.h"

namespace drc {

struct RenderRun {
    const CancelToken* cancel = nullptr;     // ends the run early; may be null
    CheckpointWriter* checkpoint = nullptr;  // saves the state now and then; may be null
    // The run ends when the finished picture's estimated error (DenoisedError::whole) is at most this; none: it ends
    // only when the samples or the time of its parameters are used up. Needs RenderParams::variance and
    // independentHalves.
    std::optional<double> noiseThreshold;
    // Called after each pass, on the caller's thread. share: part of the work that is done, in [0, 1]. status: as
    // Session::status(), with the error if it is known.
    std::function<void(double share, const std::string& status)> passDone;
};

// Whether passes are left to run and there is time for them.
bool hasWork(Session& session);

// Runs passes until all is done, the run is cancelled, or the picture is good enough. With a time budget, also measures
// how long finishing the picture will take, and leaves that time. Returns whether the picture is whole; it still is if
// the token is raised after the last sample.
bool runPasses(Session& session, PictureFinisher& finisher, const RenderRun& run = {});

}  // namespace drc
