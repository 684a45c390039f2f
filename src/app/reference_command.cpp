#include <filesystem>

#include "app/command.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "cache/training_examples.h"
#include "pbrt/scene_file.h"

namespace drc {
namespace {

struct ReferenceOptions {
    std::vector<std::string> scenes;
    std::string directory;
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

void writeReferences(const ReferenceOptions& options) {
    setThreadCount(options.threads);
    installInterruptHandler();
    if (options.quiet) setLogLevel(LogLevel::Quiet);
    std::error_code failed;
    std::filesystem::create_directories(options.directory, failed);
    if (failed) throw Error(options.directory + ": " + failed.message());

    ExampleSettings settings = options.examples;
    settings.layout = MapLayout(projectionFromName(options.projection), options.size);
    Progress progress("examples", int64_t(options.scenes.size()) * settings.viewpoints,
                      options.quiet ? ProgressMode::Quiet : ProgressMode::Auto);
    int total = 0;
    for (const std::string& path : options.scenes) {
        const std::string name = sceneName(path);
        const std::string shard = options.directory + "/" + name + ".safetensors";
        if (std::filesystem::exists(shard)) {  // an interrupted run goes on where it was
            progress.add(settings.viewpoints);
            continue;
        }
        progress.setNote(name);
        const auto scene = pbrt::loadPbrtFile(path);
        const Accel accel(*scene);
        const LightSampler lights(*scene);
        const PathTracer tracer(*scene, accel, lights);
        settings.seed = hashCombine(options.examples.seed, std::hash<std::string>{}(name));
        const ExampleSet examples = makeExamples(tracer, settings, &progress, &interruptToken());
        if (interruptToken().cancelled()) throw Error("interrupted; run the same command again to go on");
        if (examples.count == 0) {
            logWarning(path + ": no light reaches what the camera sees; no examples");
            continue;
        }
        writeExamples(shard, examples, settings, name);
        total += examples.count;
    }
    progress.finish();
    logInfo(fmt::format("{} examples written to {}", total, options.directory));
}

}  // namespace

void addReferenceCommand(CLI::App& app) {
    auto* command = app.add_subcommand("reference", "Write examples for the network to learn from");
    auto o = std::make_shared<ReferenceOptions>();
    command->add_option("SCENE", o->scenes, "Scene files, pbrt-v3 or pbrt-v4")->required();
    command->add_option("-o,--output", o->directory, "Folder for one safetensors file a scene; those there are kept")
        ->required();
    command->add_option("--viewpoints", o->examples.viewpoints, "Maps a scene")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command->add_option("--spp", o->examples.targetSamples, "Samples a texel of the target")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command->add_option("--inputs", o->examples.inputs, "One-sample realisations of each map")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command->add_option("--projection", o->projection, "equal-area or latlong")->capture_default_str();
    command->add_option("--map-size", o->size, "Texels along each side")
        ->capture_default_str()
        ->check(CLI::Range(4, 256));
    command->add_option("--seed", o->examples.seed, "Seed of all random numbers")->capture_default_str();
    command->add_option("--nthreads", o->threads, "Threads; 0: one a core")->capture_default_str();
    command->add_flag("--quiet", o->quiet, "Say nothing but errors");
    command->footer("Example: drc reference rooms/*/scene.pbrt --viewpoints 160 --spp 64 -o examples");
    command->callback([o] { writeReferences(*o); });
}

}  // namespace drc
