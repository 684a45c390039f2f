#include <chrono>
#include <filesystem>

#include "app/command.h"
#include "app/exit_code.h"
#include "app/option_checks.h"
#include "app/usage_error.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/progress.h"
#include "maps/example_shard.h"
#include "maps/training_examples.h"
#include "neural/safetensors.h"
#include "pbrt/scene_file.h"

namespace drc {
namespace {

struct ReferenceOptions {
    std::vector<std::string> scenes;
    std::string directory;
    std::string layout = "shard";
    std::string projection = "equal-area";
    ExampleSettings examples;
    int size = 32;
    int threads = 0;
    bool quiet = false;
};

// "a/room-0001/scene.pbrt" is called "room-0001".
std::string sceneName(const std::string& path) {
    const std::filesystem::path p = std::filesystem::absolute(path);
    return p.stem() == "scene" ? p.parent_path().filename().string() : p.stem().string();
}

uint64_t hashText(const std::string& text) { return hashBytes(text.data(), text.size()); }

// Progress of a run over all its scenes.
class Tally {
  public:
    void add(bool example) { ++(example ? examples_ : none_); }
    std::string str() const {
        const double hours = std::chrono::duration<double, std::ratio<3600>>(Clock::now() - start_).count();
        return fmt::format("{} examples, {:.0f} an hour, {} viewpoints without one", examples_, examples_ / hours,
                           none_);
    }

  private:
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start_ = Clock::now();
    int examples_ = 0, none_ = 0;
};

class ReferenceRun {
  public:
    explicit ReferenceRun(const ReferenceOptions& options)
        : options_(options),
          settings_(options.examples),
          iispt_(options.layout == "iispt"),
          progress_("examples", viewpointsLeft(), options.quiet ? ProgressMode::Quiet : ProgressMode::Auto) {
        settings_.layout = MapLayout(projectionFromName(options.projection), options.size);
        if (!iispt_) return;
        settings_.layout = MapLayout(Projection::LatLong, 32);
        settings_.inputs = 1;
    }

    void run() {
        int failed = 0;
        for (const std::string& path : options_.scenes) {
            try {
                forgetWarnings();
                write(path);
            } catch (const Error& error) {
                logError(error.what());
                ++failed;
            }
            if (interruptToken().cancelled()) {
                progress_.finish();
                logInfo("interrupted; run the same command again to go on");
                exitCode() = 128 + interruptSignal();
                return;
            }
        }
        progress_.finish();
        logInfo(fmt::format("{}: {}", options_.directory, tally_.str()));
        if (failed) throw Error(fmt::format("{} of {} scenes failed", failed, options_.scenes.size()));
    }

  private:
    std::string outputPath(const std::string& scene) const {
        return options_.directory + "/" + sceneName(scene) + (iispt_ ? "" : kShardExtension);
    }
    // An upper bound: unfinished shards have fewer left.
    int64_t viewpointsLeft() const {
        int64_t left = 0;
        for (const std::string& scene : options_.scenes)
            if (!isFinishedShard(outputPath(scene))) left += options_.examples.viewpoints();
        return left;
    }

    void write(const std::string& path) {
        const std::string name = sceneName(path);
        ExampleSettings settings = settings_;
        settings.seed = hashCombine(settings_.seed, hashText(name));
        ShardHeader header = shardHeader(settings, name, hashText(readFile(path)));
        header.seed = settings_.seed;  // as the user gave it
        const std::string output = outputPath(path);
        if (!iispt_ && isFinishedShard(output)) {
            ExampleShardWriter(output, header);  // refuses one that was made with other settings
            return;
        }
        progress_.setNote(name);
        const auto scene = pbrt::loadPbrtFile(path);
        const Accel accel(*scene);
        const LightSampler lights(*scene);
        PathSettings paths;
        paths.broadAlpha = broadAlpha(settings.layout);
        const PathTracer tracer(*scene, accel, lights, paths);
        const auto done = [&](bool example) {
            tally_.add(example);
            progress_.setNote(name + ": " + tally_.str());
            progress_.add();
        };
        if (iispt_) {
            progress_.add(writeExamples(tracer, settings, IisptWriter(output, header), done, &interruptToken()));
            return;
        }
        ExampleShardWriter shard(output, header);
        progress_.add(shard.next());
        writeExamples(tracer, settings, shard, done, &interruptToken());
    }

    const ReferenceOptions& options_;
    ExampleSettings settings_;
    bool iispt_;
    Progress progress_;
    Tally tally_;
};

void writeReferences(const ReferenceOptions& options) {
    setThreadCount(options.threads);
    installInterruptHandler();
    if (options.quiet) setLogLevel(LogLevel::Quiet);
    std::error_code failed;
    std::filesystem::create_directories(options.directory, failed);
    if (failed) throw Error(options.directory + ": " + failed.message());
    ReferenceRun(options).run();
}

}  // namespace

void addReferenceCommand(CLI::App& app) {
    auto* command = app.add_subcommand("reference", "Write examples for the network to learn from");
    auto o = std::make_shared<ReferenceOptions>();
    command->add_option("SCENE", o->scenes, "Scene files, pbrt-v3 or pbrt-v4")->required();
    command
        ->add_option(
            "-o,--output", o->directory,
            "Folder for one file (or folder) a scene. Those there are kept, and unfinished ones are gone on with")
        ->required();
    auto* spread = command->add_option("--viewpoints", o->examples.spread, "Maps a scene, spread over the film")
                       ->capture_default_str()
                       ->check(CLI::Range(1, 1 << 28));
    command->add_option("--tiles", o->examples.tiles, "N: a map in each cell of an N x N grid over the film")
        ->check(CLI::Range(1, 1 << 14))
        ->excludes(spread);
    command->add_option("--spp", o->examples.targetSamples, "Samples a texel of the target")
        ->capture_default_str()
        ->check(CLI::Range(2, 65535));
    auto* inputs = command->add_option("--inputs", o->examples.inputs, "One-sample realisations of each map")
                       ->capture_default_str()
                       ->check(CLI::Range(1, limits::kExampleInputs));
    auto* projection = command->add_option("--projection", o->projection, "equal-area or latlong")
                           ->capture_default_str()
                           ->check(CLI::IsMember({"equal-area", "latlong"}));
    auto* size = command->add_option("--map-size", o->size, "Texels along each side")
                     ->capture_default_str()
                     ->check(CLI::Range(4, limits::kExampleMapSize));
    command
        ->add_option("--layout", o->layout,
                     "shard, or iispt: a folder of PFM files a scene, as the authors' programs read and write them")
        ->capture_default_str()
        ->check(CLI::IsMember({"shard", "iispt"}));
    addSeedOption(*command, o->examples.seed, "Seed of all random numbers");
    addThreadsOption(*command, o->threads);
    command->add_flag("--quiet", o->quiet, "Say nothing but errors");
    command->footer(
        "An interrupted run ends with 130 (Ctrl-C), 143 (SIGTERM) or 129 (SIGHUP), and goes on where it was when the\n"
        "same command is given again.\n"
        "Example: drc reference rooms/*/scene.pbrt --tiles 12 --spp 64 -o examples");
    command->callback([=] {
        if (o->layout == "iispt" && (*inputs || *projection || *size))
            throw UsageError(
                "--layout iispt has one input and latlong maps of 32 x 32: leave out --inputs, --projection and "
                "--map-size");
        writeReferences(*o);
    });
}

}  // namespace drc
