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
    // The error of the finished picture at which the run ends; none: it has all the samples and the time of its
    // parameters. Needs RenderParams::variance and independentHalves.
    std::optional<double> noiseThreshold;
    // Called after each pass, on the thread of the caller. share: of the work that is done, in [0, 1]. status: as
    // Session::status(), with the error if it is known.
    std::function<void(double share, const std::string& status)> passDone;
};

// Whether the session has neither all that was asked for nor used up its time.
bool hasWork(Session& session);

// Runs passes until all is done, the run is cancelled, or the picture is good enough. Measures meanwhile how much of a
// time budget finishing the picture will take, and leaves that. Returns whether the picture is whole: a token that is
// raised after the last sample takes nothing from it.
bool runPasses(Session& session, PictureFinisher& finisher, const RenderRun& run = {});

}  // namespace drc
