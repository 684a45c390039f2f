#include <fmt/ranges.h>

#include <csignal>
#include <filesystem>

#include "app/checkpoint_writer.h"
#include "app/command.h"
#include "app/display_options.h"
#include "app/display_server.h"
#include "app/distinct_files.h"
#include "app/exit_code.h"
#include "app/frame_checkpoint.h"
#include "app/frame_sequence.h"
#include "app/memory_table.h"
#include "app/models.h"
#include "app/picture_finisher.h"
#include "app/render_options.h"
#include "app/same_world.h"
#include "app/usage_error.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/parallel_time.h"
#include "base/progress.h"
#include "maps/network_map_denoiser.h"
#include "pbrt/scene_file.h"
#include "reconstruct/noise_threshold.h"
#include "render/deadline.h"
#include "scene/film_output.h"

namespace drc {
namespace {

using Clock = std::chrono::steady_clock;

struct ChosenMapDenoiser {
    std::shared_ptr<const MapDenoiser> mapDenoiser;
    std::string weightsHash;
};

// Also sets the layout of the maps to the one that the denoiser was made for.
ChosenMapDenoiser chooseMapDenoiser(const RenderOptions& o, IndirectSettings& indirect) {
    const auto setProjection = [&](const std::string& ownOfNetwork) {
        const std::string& name = o.projection != "auto" ? o.projection
                                  : ownOfNetwork.empty() ? projectionName(Projection::EqualArea)
                                                         : ownOfNetwork;
        indirect.capture.layout = MapLayout(projectionFromName(name), indirect.capture.layout.size());
    };
    setProjection("");
    if (o.mapDenoiser == "gaussian") return {makeGaussianMapDenoiser(1), ""};
    if (o.mapDenoiser == "none") return {makeIdentityMapDenoiser(), ""};
    if (o.mapDenoiser == "oracle") {
        indirect.capture.samplesPerTexel = o.oracleSamples;
        return {makeIdentityMapDenoiser(), ""};
    }
    const auto weights = UNetWeights::load(findWeights(o.weights));
    setProjection(weights->projection());
    std::optional<Precision> precision;
    if (o.precision != "auto") precision = o.precision == "fp32" ? Precision::Fp32 : Precision::Bf16;
    return {makeNetworkMapDenoiser(weights, indirect.capture.layout, precision), weights->hash()};
}

// Refuses outputs of the present frame that would replace each other, or what the command line says is read.
DistinctFiles filesOf(const RenderOptions& o) {
    DistinctFiles files;
    const auto reads = [&](const std::string& what, const std::string& path) {
        if (!path.empty() && path != "-") files.reads(what, path);
    };
    const auto writes = [&](const std::string& what, const std::string& path) {
        if (!path.empty()) files.writes(what, path);
    };
    reads("the scene", o.scene);
    reads("--frames", o.frames);
    reads("--weights", o.weights);
    reads("--oidn-library", o.oidnLibrary);
    // A checkpoint that is gone on from may be saved anew.
    if (!isSameFile(o.resume, o.checkpoint)) reads("--resume", o.resume);
    for (const std::string& path : o.outputs) writes("-o", path);
    writes("--timing", o.timing);
    writes("--checkpoint", o.checkpoint);
    return files;
}

// Refuses outputs that would replace a file that the scene names.
void keepFrom(const std::vector<std::string>& filesOfScene, DistinctFiles files) {
    for (const std::string& path : filesOfScene) files.reads("the scene's file", path);
}

std::unique_ptr<Scene> loadScene(RenderOptions& o) {
    auto scene = o.overrides.load(o.scene);
    if (o.outputs.empty()) {
        o.outputs = filmOutputs(scene->settings);
        for (const std::string& path : o.outputs) checkOutput("-o", path);
    }
    keepFrom(scene->files, filesOf(o));
    return scene;
}

void writeTiming(const std::string& path, Stats& stats) {
    const auto seconds = [&](const char* timer) { return stats.timer(timer).seconds(); };
    writeFileAtomically(
        path, fmt::format("{{\"load_seconds\": {:.4f}, \"render_seconds\": {:.4f}, \"denoise_seconds\": "
                          "{:.4f}, \"write_seconds\": {:.4f}}}\n",
                          seconds("load") + seconds("build"), seconds("render"), seconds("denoise"), seconds("write")));
}

// How a render has ended.
enum class RenderEnd {
    Whole,        // also if it was interrupted after its last sample
    Interrupted,  // its pictures have fewer samples than they should
    NotInPlace,   // a picture is not where the user wanted it
};

// Runs a pass, or as much of it as can be done until a checkpoint is due, which is then saved. False: the render is
// done, or interrupted.
bool step(Session& session, CheckpointWriter* checkpoint) {
    if (checkpoint == nullptr) return session.step(&interruptToken());
    bool goesOn = false;
    if (usesMaps(session.params().integrator)) {
        // A map pass counts as a whole alone.
        goesOn = session.step(&interruptToken());
    } else {
        const DeadlineToken due(checkpoint->due(), &interruptToken());
        goesOn = session.step(&due.token()) || (due.token().cancelled() && !interruptToken().cancelled());
    }
    if (Clock::now() >= checkpoint->due()) checkpoint->save(session);
    return goesOn;
}

// Whether an estimate of the error, which takes two thirds of the time that finishing the picture takes, leaves most of
// a time budget to samples.
bool hasTimeToEstimate(const Schedule& schedule) {
    constexpr double kMostOfBudget = 0.15;
    return schedule.reserved() <= kMostOfBudget * schedule.budget();
}

// Whether the render has neither all that was asked for nor used up its time.
bool hasWork(Session& session) {
    return session.schedule().next(session.film().passes(), session.mapPassesDone()).has_value();
}

// Runs passes until the render is done or interrupted, or the picture is good enough. Whether it is whole: an interrupt
// that comes after the last sample takes nothing from it.
bool run(Session& session, PictureFinisher& finisher, const RenderOptions& o, CheckpointWriter* checkpoint) {
    NoiseThreshold threshold(o.noiseThreshold.value_or(0));
    Progress progress(std::filesystem::path(o.scene).filename().string(), 1000,
                      o.quiet ? ProgressMode::Quiet : ProgressMode::Auto);
    if (session.hasPicture()) setSomethingToSave(true);  // that of a checkpoint
    while (step(session, checkpoint)) {
        if (session.hasPicture()) setSomethingToSave(true);
        progress.set(int64_t(session.progress() * 1000));
        if (threshold.isDue(session.samplesDone()) && hasTimeToEstimate(session.schedule())) {
            const double error = finisher.errorOf(session.picture()).whole;
            threshold.estimated(session.samplesDone(), error);
            logDebug(fmt::format("--noise-threshold {:g}: {:.4f} after {} spp; {:.0f} spp needed", *o.noiseThreshold,
                                 error, session.samplesDone(), *threshold.samplesNeeded()));
            if (threshold.reached()) break;
        }
        progress.setNote(session.status() +
                         (threshold.error() ? fmt::format(", error {:.3f}", *threshold.error()) : ""));
        if (session.schedule().wantsReserve(session.film().passes(), session.mapPassesDone())) {
            if (checkpoint) checkpoint->save(session);
            finisher.measure(session, checkpoint ? checkpoint->seconds() : 0);
        }
    }
    const bool whole = threshold.reached() || !interruptToken().cancelled() || !hasWork(session);
    if (whole) progress.set(1000);
    return whole;
}

// Inputs besides the render parameters that change the bits of the picture.
Checkpoint::Identity othersOf(const RenderOptions& o, const std::string& weightsHash) {
    Checkpoint::Identity others;
    for (const std::string& replaced : o.overrides.parameters)
        others.emplace_back("-D " + replaced.substr(0, replaced.find('=')), replaced);
    if (!o.overrides.lookAt.empty())
        others.emplace_back("--lookat", fmt::format("{}", fmt::join(o.overrides.lookAt, " ")));
    if (o.overrides.fov) others.emplace_back("--fov", fmt::format("{}", *o.overrides.fov));
    if (!usesMaps(o.params.integrator)) return others;
    const RenderParams& p = o.params;
    others.insert(others.end(), {{"--map-denoiser", o.mapDenoiser},
                                 {"--weights", weightsHash},
                                 {"--precision", o.precision},
                                 {"--projection", o.projection},
                                 {"--oracle-spp", std::to_string(o.oracleSamples)},
                                 {"--spacing", fmt::format("{}", p.firstSpacing)},
                                 {"--gather-samples", std::to_string(p.gatherSamples.value_or(0))},
                                 {"--time", fmt::format("{}", p.seconds)}});
    return others;
}

// Sets what --noise-threshold needs.
void estimateErrors(RenderParams& params, double threshold) {
    params.variance = params.independentHalves = true;
    // Enough for any error that can be wanted.
    constexpr int kMostSamples = 1 << 20;
    if (threshold > 0 && !params.spp && params.seconds == 0) params.spp = kMostSamples;
}

// A scene that is rendered to one or, with several cameras, to several pictures.
class SceneRender {
  public:
    // Loads o.scene. start: when the time of the first picture began.
    SceneRender(RenderOptions& o, const CLI::App& command, Clock::time_point start)
        : o_(o),
          start_(start),
          scene_(loadScene(o)),
          world_(o.frames.empty() ? SameWorld() : SameWorld(*scene_)),
          params_(paramsFor(command)),
          denoiser_(denoiserFor()),
          chosen_(usesMaps(params_.integrator) ? chooseMapDenoiser(o, params_.indirect) : ChosenMapDenoiser()) {
        stats_.timer("load").add(Clock::now() - start);
        params_.denoise = denoiser_.denoise;
        o.overrides.cropFilm(scene_->settings);
        const auto build = Clock::now();
        session_.emplace(*scene_, params_, chosen_.mapDenoiser, &stats_, start);
        stats_.timer("build").add(Clock::now() - build);
        memory_.afterBuilding(*scene_);
    }

    // Renders o.outputs. frame: of an animation.
    RenderEnd render(const std::optional<FramePosition>& frame) {
        PictureWriter writer(scene_->settings, o_.outputs, hasAovs(), o_.display, o_.scene);
        PictureFinisher finisher(filtersFor(params_, denoiser_), writer, stats_, o_.noiseThreshold.has_value());
        const auto rendering = Clock::now();
        setSomethingToSave(false);
        std::optional<Checkpoint> checkpoint;
        if (!o_.checkpoint.empty() || !o_.resume.empty()) checkpoint.emplace(identity(frame));
        if (!o_.resume.empty()) {
            checkpoint->resume(*session_, o_.resume);
            logInfo(
                fmt::format("goes on from {}: {}{}", o_.resume, session_->status(),
                            hasWork(*session_) ? "" : "; that is all that is asked for, --spp or --time adds more"));
        }
        std::optional<CheckpointWriter> saving;
        if (!o_.checkpoint.empty())
            saving.emplace(*checkpoint, o_.checkpoint,
                           std::chrono::duration_cast<Clock::duration>(durationOf("--every", o_.every)));
        std::unique_ptr<TevDisplay> viewer;
        if (!o_.displayServer.empty()) viewer = showInTev(o_, *session_, scene_->settings);
        const bool interrupted = !run(*session_, finisher, o_, saving ? &*saving : nullptr);
        if (saving) saving->saveLast(*session_);
        if (viewer) viewer->stopTaking();
        stats_.timer("render").add(Clock::now() - rendering);

        ExrMetadata metadata{{"drc:version", DRC_VERSION},
                             {"drc:command", processInfo().commandLine},
                             {"drc:seed", std::to_string(params_.seed)},
                             {"drc:integrator", params_.integrator},
                             {"drc:map_denoiser", usesMaps(params_.integrator) ? o_.mapDenoiser : ""},
                             {"drc:weights", chosen_.weightsHash},
                             {"drc:spp", std::to_string(session_->samplesDone())},
                             {"drc:passes", std::to_string(session_->mapPassesDone())}};
        if (interrupted) {
            metadata["drc:interrupted"] = "true";
            writer.divertFromBetterPictures(session_->samplesDone());
        }
        memory_.afterRendering(*session_, stats_);
        if (o_.frames.empty()) session_->endSampling();
        memory_.beforeFinishing();
        LayeredPicture finished = finisher.finish(session_->picture(), metadata);
        memory_.afterFinishing();
        if (!writer.outputs().empty())
            logInfo(fmt::format("{}{}: {} in {:.1f} s", interrupted ? "interrupted; " : "",
                                fmt::join(writer.outputs(), ", "), session_->status(),
                                std::chrono::duration<double>(Clock::now() - start_).count()));
        if (viewer) viewer->finish(tev::pictureOf(std::move(finished), scene_->settings.film));
        if (!writer.allInPlace()) {
            if (saving && saving->saved())
                logInfo(fmt::format("the same command with --resume {} writes the picture anew", saving->path()));
            return RenderEnd::NotInPlace;
        }
        return interrupted ? RenderEnd::Interrupted : RenderEnd::Whole;
    }

    // Goes on with the camera of o.scene, if its world is that of this scene. Otherwise false, and nothing has changed.
    bool moveCamera(Clock::time_point start) {
        const std::unique_ptr<Scene> camera = world_.cameraIn(o_.scene, *scene_, o_.overrides.loadOptions());
        if (!camera) return false;
        keepFrom(scene_->files, filesOf(o_));
        start_ = start;
        scene_->settings.outputFile = camera->settings.outputFile;
        session_->moveCamera(camera->camera, camera->settings.film);
        logDebug(o_.scene + " keeps the scene and what has been learnt of it: its camera alone is another one");
        return true;
    }

    void report() {
        if (!o_.timing.empty()) writeTiming(o_.timing, stats_);
        if (!o_.stats) return;
        // All cores but one wait then: what more of them cannot shorten.
        const std::chrono::duration<double> life = Clock::now() - processInfo().start;
        const double serial = life.count() - parallelSeconds();
        stats_.timer("serial").add(
            std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(std::max(0.0, serial))));
        memory_.report(stats_);
        fmt::print("{}", stats_.report());
    }

  private:
    bool hasAovs() const { return o_.aovs || scene_->settings.auxiliaryLayers; }

    RenderParams paramsFor(const CLI::App& command) {
        if (o_.spacing) o_.params.firstSpacing = *o_.spacing / float(scene_->settings.film.height);
        if (hasAovs()) o_.params.gBuffer = o_.params.parts = o_.params.variance = true;
        if (o_.noiseThreshold) estimateErrors(o_.params, *o_.noiseThreshold);
        RenderParams params = asUsage([&] { return resolved(o_.params, *scene_); });
        if (o_.noiseThreshold && !hasHalves(params.integrator))
            throw UsageError("--noise-threshold: with --integrator " + params.integrator +
                             " the error cannot be estimated; it can with drc, path and direct");
        refuseIdleOptions(command, params.integrator);
        return params;
    }
    Checkpoint::Identity identity(const std::optional<FramePosition>& frame) {
        // For all frames of the scene: to read large files again and again takes long.
        if (filesIdentity_.empty()) filesIdentity_ = identityOfFiles(*scene_);
        Checkpoint::Identity others = othersOf(o_, chosen_.weightsHash);
        others.insert(others.end(), filesIdentity_.begin(), filesIdentity_.end());
        if (frame) {
            const Checkpoint::Identity place = frameIdentity(*frame, o_.scene);
            others.insert(others.end(), place.begin(), place.end());
        }
        return identityOf(scene_->settings, params_, others);
    }
    ChosenDenoiser denoiserFor() const {
        ChosenDenoiser denoiser =
            chooseDenoiser(o_.params.denoise, params_, [&] { return findOidn(OidnSearch::ofProcess(o_.oidnLibrary)); });
        if (!o_.oidnLibrary.empty() && !denoiser.oidn)
            throw UsageError("--oidn-library: needs --denoise oidn or oidn-direct, or auto where that is not surface");
        return denoiser;
    }

    RenderOptions& o_;
    Clock::time_point start_;
    Stats stats_;
    MemoryTable memory_;
    std::unique_ptr<Scene> scene_;
    SameWorld world_;
    RenderParams params_;
    ChosenDenoiser denoiser_;
    ChosenMapDenoiser chosen_;
    std::optional<Session> session_;
    Checkpoint::Identity filesIdentity_;
};

// Renders one frame after the other, and returns how that has ended.
RenderEnd renderFrames(RenderOptions& o, FrameSequence& frames, const CLI::App& command) {
    std::optional<FramePosition> resumed;
    if (!o.resume.empty()) {
        resumed = framePositionIn(o.resume);
        if (resumed.has_value() != frames.isAnimation())
            throw Error(fmt::format("--resume {}: it is of {}", o.resume,
                                    resumed ? fmt::format("frame {} of an animation; give its --frames", resumed->frame)
                                            : "one picture, not of an animation; leave out --frames"));
    }
    if (resumed) frames.skipTo(resumed->loaded);
    FramePosition position{frames.number(), frames.number()};
    auto scene = std::make_unique<SceneRender>(o, command, processInfo().start);
    if (resumed && resumed->frame > resumed->loaded) {
        // The learnt state is that of a camera moved from the loaded frame to this one, so move it again.
        frames.skipTo(resumed->frame);
        if (!scene->moveCamera(processInfo().start))
            throw Error(fmt::format("--resume {}: frames {} and {} no longer differ in the camera alone", o.resume,
                                    resumed->loaded, resumed->frame));
        position.frame = frames.number();
    }
    for (bool first = true;; first = false) {
        const RenderEnd end = scene->render(frames.isAnimation() ? std::optional(position) : std::nullopt);
        if (first) scene->report();
        if (end == RenderEnd::Whole) frames.finished();
        if (end != RenderEnd::Whole || !frames.isAnimation()) return end;
        if (interruptToken().cancelled()) return RenderEnd::Interrupted;
        setSomethingToSave(false);
        o.resume.clear();
        if (!frames.next()) return end;
        position.frame = frames.number();
        filesOf(o);  // for what it refuses
        const auto start = Clock::now();
        if (scene->moveCamera(start)) continue;
        scene.reset();  // two scenes may not fit into memory
        scene = std::make_unique<SceneRender>(o, command, start);
        position.loaded = position.frame;
    }
}

void render(RenderOptions o, const CLI::App& command) {
    setLogLevel(o.quiet ? LogLevel::Quiet : o.verbose ? LogLevel::Verbose : LogLevel::Normal);
    setThreadCount(o.threads);
    installInterruptHandler();
    // A reader that leaves its pipe is an error of writing to it, and no reason to lose the other pictures.
    std::signal(SIGPIPE, SIG_IGN);
    setSomethingToSave(false);
    o.overrides.check();
    for (const std::string& path : o.outputs) {
        asUsage([&] { outputKind(path); });
        checkOutput("-o", path);
    }
    if (!o.outputs.empty()) refuseDisplayOptionsWithoutPng(command, o.outputs);
    if (!o.timing.empty()) checkOutput("--timing", o.timing);
    if (!o.checkpoint.empty()) checkOutput("--checkpoint", o.checkpoint);
    asUsage([&] { durationOf("--every", o.every); });
    filesOf(o);  // for what it refuses
    FrameSequence frames(o);
    const RenderEnd end = renderFrames(o, frames, command);
    if (end == RenderEnd::NotInPlace) exitCode() = 1;
    if (end == RenderEnd::Interrupted) exitCode() = 128 + interruptSignal();
}

}  // namespace

void addRenderCommand(CLI::App& app) {
    auto* command = app.add_subcommand("render", "Render a scene");
    auto o = std::make_shared<RenderOptions>();
    addRenderOptions(*command, *o);
    command->callback([o, command] { render(*o, *command); });
}

}  // namespace drc
