#include <fmt/ranges.h>

#include <csignal>
#include <filesystem>

#include "app/command.h"
#include "app/display_options.h"
#include "app/display_server.h"
#include "app/exit_code.h"
#include "app/map_denoiser_choice.h"
#include "app/memory_table.h"
#include "app/render_files.h"
#include "app/usage_error.h"
#include "base/atomic_file.h"
#include "base/checksum.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/mapped_file.h"
#include "base/parallel_time.h"
#include "base/progress.h"
#include "pbrt/kept_contents.h"
#include "render/cells_file.h"
#include "render/frame_checkpoint.h"
#include "render/frame_number.h"
#include "render/frame_sequence.h"
#include "render/frame_window.h"
#include "render/render_run.h"
#include "render/same_world.h"
#include "render/scene_geometry.h"

namespace drc {
namespace {

using Clock = std::chrono::steady_clock;

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
    Interrupted,  // the pictures have fewer samples than they should
    NotInPlace,   // a picture is not where the user wanted it
};

// Inputs besides the render parameters that change the bits of the picture. p: resolved parameters.
Identity othersOf(const RenderOptions& o, const RenderParams& p, const std::string& weightsHash) {
    Identity others;
    for (const std::string& replaced : o.overrides.parameters)
        others.emplace_back("-D " + replaced.substr(0, replaced.find('=')), replaced);
    if (!o.overrides.lookAt.empty())
        others.emplace_back("--lookat", fmt::format("{}", fmt::join(o.overrides.lookAt, " ")));
    if (namesCellsFile(o)) {
        others.emplace_back("--cells file", fmt::format("{:016x}", checksum(MappedFile(o.cells).bytes())));
        others.emplace_back("--freeze-cells", p.freezeCells ? "on" : "off");
    }
    if (o.overrides.fov) others.emplace_back("--fov", fmt::format("{}", *o.overrides.fov));
    if (!traitsOf(p.integrator).maps) return others;
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

// Sets the parameters that --noise-threshold needs.
void estimateErrors(RenderParams& params, double threshold) {
    params.variance = params.independentHalves = true;
    // More samples than any threshold needs in practice, so that the threshold alone ends the render.
    constexpr int kMostSamples = 1 << 20;
    if (threshold > 0 && !params.spp && params.seconds == 0) params.spp = kMostSamples;
}

// A loaded scene, and the data that its frames share.
struct LoadedScene {
    Stats stats;
    MemoryTable memory;
    std::unique_ptr<const Scene> scene;
    SameWorld world;
    pbrt::KeptContents kept;  // for the next frame
    RenderParams params;
    ChosenDenoiser denoiser;
    std::string weightsHash;
    std::optional<Session> session;
    Identity files;  // of the scene's files, once a checkpoint needs it: reading large files takes long
};

bool hasAovs(const RenderOptions& o, const RenderSettings& settings) { return o.aovs || settings.auxiliaryLayers; }

// The number of the present frame.
int frameOf(const RenderOptions& o) { return o.frame.value_or(frameNumberOf(o.scene).value_or(0)); }

// The render parameters, including what other options and the scene's file require.
RenderParams paramsOf(const RenderOptions& o, const RenderSettings& settings, const CLI::App& command) {
    RenderParams params = o.params;
    if (o.spacing) params.firstSpacing = *o.spacing / float(settings.film.height);
    params.frame = frameOf(o);
    if (hasAovs(o, settings) || o.temporal) params.gBuffer = params.parts = params.variance = params.surfaces = true;
    if (o.noiseThreshold) estimateErrors(params, *o.noiseThreshold);
    params = asUsage([&] { return resolved(params, settings); });
    if (params.surfaces && traitsOf(params.integrator).halves) params.independentHalves = true;
    if (o.noiseThreshold && !traitsOf(params.integrator).halves)
        throw UsageError("--noise-threshold: with --integrator " + params.integrator +
                         " the error cannot be estimated; it can with drc, path and direct");
    if (o.temporal && !traitsOf(params.integrator).halves)
        throw UsageError("--temporal: with --integrator " + params.integrator +
                         " frames cannot be compared; they can with drc, path and direct");
    refuseIdleOptions(command, params.integrator);
    return params;
}

// Reads the cells that --cells names, unless the frame goes on with those of the frame before.
void useCells(const RenderOptions& o, const Scene& scene, const SessionRemains& remains, RenderParams& params) {
    params.cells = o.cells != "off";
    if (!namesCellsFile(o)) {
        if (params.freezeCells) throw UsageError("--freeze-cells: there is nothing to freeze without --cells FILE");
        return;
    }
    if (params.cellSize > 0) throw UsageError("--cell-size: cells that --cells names have the size of their file");
    if (remains.cells && !params.freezeCells) return;
    CellCollection cells = loadCells("--cells " + o.cells, o.cells, cellsIdentity(scene, params));
    if (cells.lightScale != scene.sensor.settings.filmScale || cells.origin != scene.origin)
        throw Error(fmt::format("--cells {}: they are of a film of scale {:g}, here {:g}", o.cells, cells.lightScale,
                                scene.sensor.settings.filmScale));
    params.startCells = std::make_shared<const CellCollection>(std::move(cells));
}

ChosenDenoiser chosenDenoiser(const RenderOptions& o, const RenderParams& params) {
    return chooseDenoiser(o.params.denoise, params, [&] { return findOidn(OidnSearch::ofProcess(o.oidnLibrary)); });
}

// Loads the scene of the present frame, and prepares it. start: beginning of the frame's time budget. before: the frame
// before, of which all that serves this frame is kept; null: none.
std::unique_ptr<LoadedScene> load(RenderOptions& o, const CLI::App& command, Clock::time_point start,
                                  std::unique_ptr<LoadedScene> before) {
    auto loaded = std::make_unique<LoadedScene>();
    SessionRemains remains;
    if (before) {
        remains = before->session->takeRemains();
        loaded->kept = std::move(before->kept);
        before.reset();  // two scenes may not fit into memory
    }
    std::unique_ptr<Scene> scene = loadScene(o, o.frames.empty() ? nullptr : &loaded->kept);
    o.overrides.cropFilm(scene->sensor.settings);
    if (!o.frames.empty()) loaded->world = SameWorld(*scene);
    RenderParams& params = loaded->params;
    params = paramsOf(o, scene->sensor.settings, command);
    loaded->denoiser = chosenDenoiser(o, params);
    if (!o.oidnLibrary.empty() && !loaded->denoiser.oidn)
        throw UsageError("--oidn-library: needs --denoise oidn or oidn-direct, or auto where that is not surface");
    useCells(o, *scene, remains, params);
    if (traitsOf(params.integrator).maps) loaded->weightsHash = chooseMapDenoiser(o, params.indirect);
    loaded->stats.timer("load").add(Clock::now() - start);
    params.denoise = loaded->denoiser.denoise;
    const auto build = Clock::now();
    loaded->scene = std::move(scene);
    loaded->session.emplace(*loaded->scene, loaded->scene->sensor, params, &loaded->stats, start, std::move(remains));
    loaded->stats.timer("build").add(Clock::now() - build);
    loaded->memory.afterBuilding(*loaded->scene);
    return loaded;
}

// Continues with the camera of the present frame, if the frame has the world of the loaded scene. Otherwise returns
// false and changes nothing.
bool moveCamera(LoadedScene& loaded, const RenderOptions& o) {
    const std::unique_ptr<Scene> camera = loaded.world.cameraIn(o.scene, *loaded.scene, o.overrides.loadOptions());
    if (!camera) return false;
    keepFrom(loaded.scene->files, filesOf(o));
    loaded.params.frame = frameOf(o);
    loaded.session->setFrame(loaded.params.frame);
    loaded.session->moveCamera(camera->sensor.camera, camera->sensor.settings.film);
    logDebug(o.scene + " keeps the scene and what has been learnt of it: its camera alone is another one");
    return true;
}

// The identity of the present picture for checkpoints. frame: position in an animation; none: a single picture.
Identity identity(LoadedScene& loaded, const RenderOptions& o, const std::optional<FramePosition>& frame) {
    if (loaded.files.empty()) loaded.files = checkpointFiles(*loaded.scene);
    Identity others = othersOf(o, loaded.params, loaded.weightsHash);
    others.insert(others.end(), loaded.files.begin(), loaded.files.end());
    if (frame) {
        const Identity place = frameIdentity(*frame, o.scene);
        others.insert(others.end(), place.begin(), place.end());
    }
    return identityOf(loaded.session->sensor().settings, loaded.params, others);
}

// Runs the session, with a progress bar. Returns whether its picture is whole.
bool run(LoadedScene& loaded, const RenderOptions& o, PictureFinisher& finisher, CheckpointWriter* checkpoint) {
    Session& session = *loaded.session;
    Progress progress(std::filesystem::path(o.scene).filename().string(), 1000,
                      o.quiet ? ProgressMode::Quiet : ProgressMode::Auto);
    setSomethingToSave(session.hasPicture());  // true if a checkpoint was loaded
    const bool whole = runPasses(session, finisher,
                                 {.cancel = &interruptToken(),
                                  .checkpoint = checkpoint,
                                  .noiseThreshold = o.noiseThreshold,
                                  .passDone = [&](double share, const std::string& status) {
                                      if (session.hasPicture()) setSomethingToSave(true);
                                      progress.set(int64_t(share * 1000));
                                      progress.setNote(status);
                                  }});
    if (whole) progress.set(1000);
    return whole;
}

ExrMetadata metadataOf(const LoadedScene& loaded, const RenderOptions& o) {
    const Session& session = *loaded.session;
    return {{"drc:version", DRC_VERSION},
            {"drc:command", processInfo().commandLine},
            {"drc:seed", std::to_string(loaded.params.seed)},
            {kFrameNumber, std::to_string(loaded.params.frame)},
            {"drc:integrator", loaded.params.integrator},
            {"drc:map_denoiser", traitsOf(loaded.params.integrator).maps ? o.mapDenoiser : ""},
            {"drc:weights", loaded.weightsHash},
            {"drc:spp", std::to_string(session.samplesDone())},
            {"drc:passes", std::to_string(session.mapPassesDone())}};
}

// The frames of --temporal, which are written after those that follow them.
class LateFrames {
  public:
    void add(const LoadedScene& loaded, const RenderOptions& o, ExrMetadata metadata, bool interrupted) {
        const Session& session = *loaded.session;
        const FrameGeometry geometry = geometryOf(*loaded.scene, session.sensor());
        if (interrupted) metadata["drc:interrupted"] = "true";
        if (!denoiser_) denoiser_ = chosenDenoiser(o, loaded.params);
        const auto finish = [this, o, metadata, geometry, interrupted, settings = session.sensor().settings,
                             params = loaded.params, samples = session.samplesDone()](LayeredPicture picture) {
            PictureWriter writer(settings, o.outputs, hasAovs(o, settings), o.display, o.scene);
            writer.setGeometry(geometry);
            if (interrupted) writer.divertFromBetterPictures(samples);
            PictureFinisher finisher(filtersFor(params, *denoiser_), writer);
            finisher.finish(std::move(picture), metadata);
            logInfo(fmt::format("{}{}: {} spp, averaged with {} frames before and after",
                                interrupted ? "interrupted; " : "", fmt::join(writer.outputs(), ", "), samples,
                                FrameWindow::kRadius));
            allInPlace_ = allInPlace_ && writer.allInPlace();
            if (!interrupted && writer.allInPlace()) FrameList::finished(writer.outputs());
        };
        // A snapshot, since the film is the next frame's soon.
        window_.add(session.snapshot(), geometry, session.sensor().settings.film, o.scene, finish);
    }
    // Writes the frames that are left. Returns whether all frames are where the user wanted them.
    bool end() {
        window_.end();
        return allInPlace_;
    }

  private:
    FrameWindow window_;
    std::optional<ChosenDenoiser> denoiser_;  // its own, since frames outlive the scene that they were rendered of
    bool allInPlace_ = true;
};

// Renders the present frame and writes its pictures. frame: position in an animation; none: a single picture. start:
// beginning of the frame's time.
// late: takes the frame where it is to be averaged with its neighbours, and written later; null: it is written now.
RenderEnd renderFrame(LoadedScene& loaded, const RenderOptions& o, const std::optional<FramePosition>& frame,
                      Clock::time_point start, LateFrames* late) {
    Session& session = *loaded.session;
    const RenderSettings& settings = session.sensor().settings;
    PictureWriter writer(settings, o.outputs, hasAovs(o, settings), o.display, o.scene);
    writer.setGeometry(geometryOf(*loaded.scene, session.sensor()));
    PictureFinisher finisher(filtersFor(loaded.params, loaded.denoiser), writer, &loaded.stats,
                             o.noiseThreshold.has_value());
    const auto rendering = Clock::now();
    std::optional<Checkpoint> checkpoint;
    if (!o.checkpoint.empty() || !o.resume.empty()) checkpoint.emplace(identity(loaded, o, frame));
    if (!o.resume.empty()) {
        checkpoint->resume(session, o.resume);
        logInfo(fmt::format("goes on from {}: {}{}", o.resume, session.status(),
                            hasWork(session) ? "" : "; that is all that is asked for, --spp or --time adds more"));
    }
    std::optional<CheckpointWriter> saving;
    if (!o.checkpoint.empty())
        saving.emplace(*checkpoint, o.checkpoint,
                       std::chrono::duration_cast<Clock::duration>(durationOf("--every", o.every)));
    std::unique_ptr<TevDisplay> viewer;
    if (!o.displayServer.empty()) viewer = showInTev(o, session, settings);
    const bool interrupted = !run(loaded, o, finisher, saving ? &*saving : nullptr);
    if (saving) saving->saveLast(session);
    if (viewer) viewer->stopTaking();
    loaded.stats.timer("render").add(Clock::now() - rendering);

    ExrMetadata metadata = metadataOf(loaded, o);
    if (late) {
        if (interrupted && !session.hasPicture()) return RenderEnd::Interrupted;
        late->add(loaded, o, std::move(metadata), interrupted);
        return interrupted ? RenderEnd::Interrupted : RenderEnd::Whole;
    }
    if (interrupted) {
        metadata["drc:interrupted"] = "true";
        writer.divertFromBetterPictures(session.samplesDone());
    }
    loaded.memory.afterRendering(session, loaded.stats);
    if (o.frames.empty()) session.endSampling();
    loaded.memory.beforeFinishing();
    LayeredPicture finished = finisher.finish(session.picture(), metadata);
    loaded.memory.afterFinishing();
    if (!writer.outputs().empty())
        logInfo(fmt::format("{}{}: {} in {:.1f} s", interrupted ? "interrupted; " : "",
                            fmt::join(writer.outputs(), ", "), session.status(),
                            std::chrono::duration<double>(Clock::now() - start).count()));
    if (viewer) viewer->finish(tev::pictureOf(std::move(finished), settings.film));
    if (!writer.allInPlace()) {
        if (saving && saving->saved())
            logInfo(fmt::format("the same command with --resume {} writes the picture anew", saving->path()));
        return RenderEnd::NotInPlace;
    }
    return interrupted ? RenderEnd::Interrupted : RenderEnd::Whole;
}

void report(LoadedScene& loaded, const RenderOptions& o) {
    Stats& stats = loaded.stats;
    if (!o.timing.empty()) writeTiming(o.timing, stats);
    if (!o.stats) return;
    // The time outside of parallel sections, which more cores cannot shorten.
    const std::chrono::duration<double> life = Clock::now() - processInfo().start;
    const double serial = life.count() - parallelSeconds();
    stats.timer("serial").add(
        std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(std::max(0.0, serial))));
    loaded.memory.report(stats);
    fmt::print("{}", stats.report());
}

// Renders the frames one after the other, and returns how the last one has ended. late: as in renderFrame().
RenderEnd renderFrames(RenderOptions& o, FrameSequence& frames, const CLI::App& command, LateFrames* late) {
    std::optional<FramePosition> resumed;
    if (!o.resume.empty()) {
        resumed = framePositionIn(o.resume);
        if (resumed.has_value() != frames.isAnimation())
            throw Error(fmt::format("--resume {}: it is of {}", o.resume,
                                    resumed ? fmt::format("frame {} of an animation; give its --frames", resumed->frame)
                                            : "one picture, not of an animation; leave out --frames"));
    }
    if (resumed) frames.skipTo(resumed->loaded, o.resume);
    FramePosition position{frames.number(), frames.number()};
    auto start = processInfo().start;
    std::unique_ptr<LoadedScene> loaded = load(o, command, start, nullptr);
    if (resumed && resumed->frame > resumed->loaded) {
        // The learnt state is that of a camera moved from the loaded frame to this one, so move it again.
        frames.skipTo(resumed->frame, o.resume);
        if (!moveCamera(*loaded, o))
            throw Error(fmt::format("--resume {}: frames {} and {} no longer differ in the camera alone", o.resume,
                                    resumed->loaded, resumed->frame));
        position.frame = frames.number();
    }
    for (bool first = true;; first = false) {
        const RenderEnd end =
            renderFrame(*loaded, o, frames.isAnimation() ? std::optional(position) : std::nullopt, start, late);
        if (first) report(*loaded, o);
        if (end == RenderEnd::Whole && !late) frames.finished();
        if (end != RenderEnd::Whole || !frames.isAnimation()) return end;
        if (interruptToken().cancelled()) return RenderEnd::Interrupted;
        setSomethingToSave(false);
        o.resume.clear();
        if (!frames.next()) return end;
        position.frame = frames.number();
        filesOf(o);  // throws if the frame's outputs collide with other files
        start = Clock::now();
        if (moveCamera(*loaded, o)) continue;
        loaded = load(o, command, start, std::move(loaded));
        position.loaded = position.frame;
    }
}

// Renders all frames and writes their pictures, also those before a frame that cannot be rendered.
RenderEnd renderAll(RenderOptions& o, FrameSequence& frames, const CLI::App& command) {
    if (!o.temporal) return renderFrames(o, frames, command, nullptr);
    LateFrames late;
    try {
        const RenderEnd end = renderFrames(o, frames, command, &late);
        return !late.end() && end == RenderEnd::Whole ? RenderEnd::NotInPlace : end;
    } catch (...) {
        late.end();
        throw;
    }
}

void render(RenderOptions o, const CLI::App& command) {
    setLogLevel(o.quiet ? LogLevel::Quiet : o.verbose ? LogLevel::Verbose : LogLevel::Normal);
    setThreadCount(o.threads);
    installInterruptHandler();
    // Without the signal, a reader that leaves its pipe causes a write error, and the other pictures are not lost.
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
    filesOf(o);  // throws if outputs collide with other files
    FrameSequence frames(o, o.frames);
    const RenderEnd end = renderAll(o, frames, command);
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
