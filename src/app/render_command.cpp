#include <fmt/core.h>

#include <filesystem>

#include "app/checkpoint.h"
#include "app/command.h"
#include "app/display_options.h"
#include "app/display_server.h"
#include "app/memory_table.h"
#include "app/models.h"
#include "app/picture_finisher.h"
#include "app/render_options.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/progress.h"
#include "cache/network_map_denoiser.h"
#include "pbrt/scene_file.h"
#include "render/deadline.h"
#include "render/noise_threshold.h"
#include "scene/crop_window.h"
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

std::unique_ptr<Scene> loadScene(RenderOptions& o) {
    pbrt::LoadOptions load;
    if (!o.resolution.empty()) load.resolution = parseResolution(o.resolution);
    load.overrides = o.overrides;
    std::optional<CropWindow> crop;
    try {
        if (!o.crop.empty()) crop = cropWindowOf(o.crop);
    } catch (const Error& error) {
        throw Error(std::string("--crop: ") + error.what());
    }
    auto scene = pbrt::loadPbrtFile(o.scene, load);
    if (crop) std::copy(crop->begin(), crop->end(), scene->settings.cropWindow);
    if (o.outputs.empty()) o.outputs = filmOutputs(scene->settings);
    return scene;
}

void writeTiming(const std::string& path, Stats& stats) {
    const auto seconds = [&](const char* timer) { return stats.timer(timer).seconds(); };
    writeFileAtomically(
        path, fmt::format("{{\"load_seconds\": {:.4f}, \"render_seconds\": {:.4f}, \"denoise_seconds\": "
                          "{:.4f}, \"write_seconds\": {:.4f}}}\n",
                          seconds("load") + seconds("build"), seconds("render"), seconds("denoise"), seconds("write")));
}

// Saves the state of a render in a file, so often. What cannot be saved is no reason to stop: there is the last one.
class CheckpointWriter {
  public:
    CheckpointWriter(const Checkpoint& checkpoint, std::string path, Clock::duration every)
        : checkpoint_(checkpoint), path_(std::move(path)), every_(every) {}
    Clock::time_point due() const { return last_ + every_; }
    void save(const Session& session) {
        const auto start = Clock::now();
        try {
            checkpoint_.save(session, path_);
            logDebug(fmt::format("--checkpoint: saved {} in {:.2f} s", path_,
                                 std::chrono::duration<double>(Clock::now() - start).count()));
        } catch (const Error& error) {
            logWarning(std::string("--checkpoint: ") + error.what() + "; the render goes on");
        }
        last_ = Clock::now();
    }

  private:
    const Checkpoint& checkpoint_;
    std::string path_;
    Clock::duration every_;
    Clock::time_point last_ = Clock::now();
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
    if (Clock::now() >= checkpoint->due() || interruptToken().cancelled()) checkpoint->save(session);
    return goesOn;
}

// Whether an estimate of the error, which takes two thirds of the time that finishing the picture takes, leaves most of
// a time budget to samples.
bool hasTimeToEstimate(const Schedule& schedule) {
    constexpr double kMostOfBudget = 0.15;
    return schedule.reserved() <= kMostOfBudget * schedule.budget();
}

// Runs passes until the render is done or interrupted, or the picture is good enough.
void run(Session& session, PictureFinisher& finisher, const RenderOptions& o, CheckpointWriter* checkpoint) {
    NoiseThreshold threshold(o.noiseThreshold.value_or(0));
    Progress progress(std::filesystem::path(o.scene).filename().string(), 1000,
                      o.quiet ? ProgressMode::Quiet : ProgressMode::Auto);
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
        if (session.schedule().wantsReserve(session.film().passes(), session.mapPassesDone()))
            finisher.measure(session);
    }
    if (!interruptToken().cancelled()) progress.set(1000);
}

// What else than the parameters of a render its bits depend on.
Checkpoint::Identity othersOf(const RenderOptions& o, const std::string& weightsHash) {
    Checkpoint::Identity others;
    for (const std::string& replaced : o.overrides)
        others.emplace_back("-D " + replaced.substr(0, replaced.find('=')), replaced);
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

void render(RenderOptions o, const CLI::App& command) {
    const auto start = processInfo().start;
    MemoryTable memory;
    setLogLevel(o.quiet ? LogLevel::Quiet : o.verbose ? LogLevel::Verbose : LogLevel::Normal);
    setThreadCount(o.threads);
    installInterruptHandler();
    setSomethingToSave(false);
    for (const std::string& path : o.outputs) {
        outputKind(path);
        checkOutput("-o", path);
    }
    if (!o.outputs.empty()) refuseDisplayOptionsWithoutPng(command, o.outputs);
    if (!o.timing.empty()) checkOutput("--timing", o.timing);
    if (!o.checkpoint.empty()) checkOutput("--checkpoint", o.checkpoint);
    const std::chrono::duration<double> every = durationOf("--every", o.every);

    Stats stats;
    const auto scene = loadScene(o);
    stats.timer("load").add(Clock::now() - start);
    for (const std::string& path : o.outputs) checkOutput("-o", path);
    if (o.spacing) o.params.firstSpacing = *o.spacing / float(scene->settings.film.height);
    if (o.aovs) o.params.gBuffer = o.params.parts = o.params.variance = true;
    if (o.noiseThreshold) estimateErrors(o.params, *o.noiseThreshold);
    RenderParams params = resolved(o.params, *scene);
    if (o.noiseThreshold && !hasHalves(params.integrator))
        throw Error("--noise-threshold: with --integrator " + params.integrator +
                    " the error cannot be estimated; it can with drc, path and direct");
    refuseIdleOptions(command, params.integrator);
    const ChosenDenoiser denoiser =
        chooseDenoiser(o.params.denoise, params, [&] { return findOidn(OidnSearch::ofProcess(o.oidnLibrary)); });
    if (!o.oidnLibrary.empty() && !denoiser.oidn)
        throw Error("--oidn-library: needs --denoise oidn or oidn-direct, or auto where that is not surface");
    params.denoise = denoiser.denoise;
    ChosenMapDenoiser chosen;
    if (usesMaps(params.integrator)) chosen = chooseMapDenoiser(o, params.indirect);

    const auto build = Clock::now();
    Session session(*scene, params, chosen.mapDenoiser, &stats, start);
    PictureWriter writer(scene->settings, o.outputs, o.aovs, o.display);
    PictureFinisher finisher(filtersFor(params, denoiser), writer, stats, o.noiseThreshold.has_value());
    memory.afterBuilding(*scene);
    const auto rendering = Clock::now();
    stats.timer("build").add(rendering - build);
    std::optional<Checkpoint> checkpoint;
    if (!o.checkpoint.empty() || !o.resume.empty())
        checkpoint.emplace(identityOf(*scene, params, othersOf(o, chosen.weightsHash)));
    if (!o.resume.empty()) {
        checkpoint->resume(session, o.resume);
        logInfo(fmt::format("goes on from {}: {}", o.resume, session.status()));
    }
    std::optional<CheckpointWriter> saving;
    if (!o.checkpoint.empty())
        saving.emplace(*checkpoint, o.checkpoint, std::chrono::duration_cast<Clock::duration>(every));
    std::unique_ptr<TevDisplay> viewer;
    if (!o.displayServer.empty()) viewer = showInTev(o, session, scene->settings);
    run(session, finisher, o, saving ? &*saving : nullptr);
    if (viewer) viewer->stopTaking();
    stats.timer("render").add(Clock::now() - rendering);

    const bool interrupted = interruptToken().cancelled();
    ExrMetadata metadata{{"drc:version", DRC_VERSION},
                         {"drc:command", processInfo().commandLine},
                         {"drc:seed", std::to_string(params.seed)},
                         {"drc:integrator", params.integrator},
                         {"drc:map_denoiser", usesMaps(params.integrator) ? o.mapDenoiser : ""},
                         {"drc:weights", chosen.weightsHash},
                         {"drc:spp", std::to_string(session.samplesDone())},
                         {"drc:passes", std::to_string(session.mapPassesDone())}};
    if (interrupted) {
        metadata["drc:interrupted"] = "true";
        writer.divertFromBetterPictures(session.samplesDone());
    }
    memory.afterRendering(session, stats);
    session.endSampling();
    memory.beforeFinishing();
    LayeredPicture finished = finisher.finish(session.picture(), metadata);
    memory.afterFinishing();
    std::string names;
    for (const std::string& path : writer.outputs()) names += (names.empty() ? "" : ", ") + path;
    logInfo(fmt::format("{}{}: {} in {:.1f} s", interrupted ? "interrupted; " : "", names, session.status(),
                        std::chrono::duration<double>(Clock::now() - start).count()));
    if (viewer) viewer->finish(tev::pictureOf(std::move(finished), scene->settings.film));
    if (!o.timing.empty()) writeTiming(o.timing, stats);
    if (o.stats) {
        memory.report(stats);
        fmt::print("{}", stats.report());
    }
}

}  // namespace

void addRenderCommand(CLI::App& app) {
    auto* command = app.add_subcommand("render", "Render a scene");
    auto o = std::make_shared<RenderOptions>();
    addRenderOptions(*command, *o);
    command->callback([o, command] { render(*o, *command); });
}

}  // namespace drc
