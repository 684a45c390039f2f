#include "render/render_run.h"

#include <fmt/core.h>

#include "base/log.h"
#include "reconstruct/noise_threshold.h"
#include "render/deadline.h"

namespace drc {
namespace {

bool isRaised(const CancelToken* token) { return token != nullptr && token->cancelled(); }

// Runs a pass, or the part of it that can be done until a checkpoint is due, and then saves the checkpoint. False: the
// render is done or cancelled.
bool step(Session& session, const RenderRun& run) {
    CheckpointWriter* checkpoint = run.checkpoint;
    if (checkpoint == nullptr) return session.step(run.cancel);
    bool goesOn = false;
    if (traitsOf(session.params().integrator).maps) {
        // A map pass counts only as a whole.
        goesOn = session.step(run.cancel);
    } else {
        const DeadlineToken due(checkpoint->due(), run.cancel);
        goesOn = session.step(&due.token()) || (due.token().cancelled() && !isRaised(run.cancel));
    }
    if (Schedule::Clock::now() >= checkpoint->due()) checkpoint->save(session);
    return goesOn;
}

// Whether an estimate of the error, which takes two thirds of the time that finishing the picture takes, leaves most of
// a time budget to samples.
bool hasTimeToEstimate(const Schedule& schedule) {
    constexpr double kMostOfBudget = 0.15;
    return schedule.reserved() <= kMostOfBudget * schedule.budget();
}

}  // namespace

bool hasWork(Session& session) {
    return session.schedule().next(session.film().passes(), session.mapPassesDone()).has_value();
}

bool runPasses(Session& session, PictureFinisher& finisher, const RenderRun& run) {
    NoiseThreshold threshold(run.noiseThreshold.value_or(0));
    while (step(session, run)) {
        if (threshold.isDue(session.samplesDone()) && hasTimeToEstimate(session.schedule())) {
            const double error = finisher.errorOf(session.picture()).whole;
            threshold.estimated(session.samplesDone(), error);
            logDebug(fmt::format("--noise-threshold {:g}: {:.4f} after {} spp; {:.0f} spp needed", *run.noiseThreshold,
                                 error, session.samplesDone(), *threshold.samplesNeeded()));
            if (threshold.reached()) break;
        }
        if (run.passDone)
            run.passDone(
                session.progress(),
                session.status() + (threshold.error() ? fmt::format(", error {:.3f}", *threshold.error()) : ""));
        if (session.schedule().wantsReserve(session.film().passes(), session.mapPassesDone())) {
            if (run.checkpoint) run.checkpoint->save(session);
            finisher.measure(session, run.checkpoint ? run.checkpoint->seconds() : 0);
        }
    }
    return threshold.reached() || !isRaised(run.cancel) || !hasWork(session);
}

}  // namespace drc
