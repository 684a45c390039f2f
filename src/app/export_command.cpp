// `drc export`: scenes for programs that do not read pbrt's format as DRC does.
#include <memory>
#include <optional>

#include "app/command.h"
#include "app/usage_error.h"
#include "base/atomic_file.h"
#include "base/distinct_files.h"
#include "base/limits.h"
#include "pbrt/scene_copy.h"
#include "pbrt/scene_file.h"
#include "pbrt/scene_json.h"

namespace drc {
namespace {

struct ExportOptions {
    std::string scene, output = "/dev/stdout", meshes, resolution, integrator;
    bool asJson = false, asPbrt = false;
    int spp = 0, maxDepth = 0;
};

void checkExport(const ExportOptions& options, const CLI::App& command) {
    if (options.asJson == options.asPbrt) throw UsageError("drc export: give one of --json and --pbrt");
    for (const char* name : {"--resolution", "--spp", "--integrator", "--max-depth"})
        if (options.asJson && command.count(name) > 0)
            throw UsageError(std::string(name) + ": the settings are replaced with --pbrt only");
    if (options.asPbrt && !options.meshes.empty()) throw UsageError("--meshes: meshes are written with --json only");
    if (command.count("--max-depth") > 0 && options.integrator.empty())
        throw UsageError("--max-depth: it is for --integrator; give both");
}

// Throws Error if the output or a mesh would replace a file of the scene.
void keepApart(const std::vector<std::string>& ofScene, const ExportOptions& options,
               const std::vector<std::string>& meshes = {}) {
    DistinctFiles files;
    files.reads("the scene", options.scene);
    for (const std::string& path : ofScene) files.reads("the scene's file", path);
    files.writes("--output", options.output);
    for (const std::string& path : meshes)
        if (!path.empty()) files.writes("--meshes", path);
}

void exportJson(const ExportOptions& options, AtomicFile& file) {
    pbrt::SceneListing listing;
    pbrt::LoadOptions load;
    load.listing = &listing;
    const auto scene = pbrt::loadPbrtFile(options.scene, load);
    std::vector<std::string> paths;
    if (!options.meshes.empty()) paths = pbrt::meshPaths(listing, options.meshes);
    keepApart(scene->files, options, paths);
    std::vector<pbrt::MeshFile> meshes;
    if (!options.meshes.empty()) meshes = pbrt::writeMeshFiles(listing, options.meshes);
    pbrt::writeSceneJson(listing, meshes, [&](std::string_view text) { file.write(text); });
}

void exportPbrt(const ExportOptions& options, const CLI::App& command, AtomicFile& file) {
    pbrt::CopySettings settings;
    if (!options.resolution.empty()) settings.resolution = parseResolution(options.resolution);
    if (options.spp > 0) settings.spp = options.spp;
    settings.integrator = options.integrator;
    if (command.count("--max-depth") > 0) settings.maxDepth = options.maxDepth;
    keepApart(pbrt::copyScene(options.scene, settings, [&](std::string_view text) { file.write(text); }), options);
}

void exportScene(const ExportOptions& options, const CLI::App& command) {
    checkExport(options, command);
    keepApart({}, options);
    AtomicFile file(options.output);
    if (options.asJson)
        exportJson(options, file);
    else
        exportPbrt(options, command, file);
    file.commit();
}

}  // namespace

void addExportCommand(CLI::App& app) {
    auto* command = app.add_subcommand("export", "Write a scene for other programs: as JSON, or for pbrt itself");
    auto options = std::make_shared<ExportOptions>();
    command->add_option("SCENE", options->scene, "Scene file, pbrt-v3 or pbrt-v4")->required();
    command->add_flag("--json", options->asJson,
                      "Write every camera, shape, light, material and texture with its parameters, its transformation "
                      "and its place in the file");
    command->add_option("--meshes", options->meshes,
                        "With --json: write triangle meshes to PLY files in this folder, in world space");
    command->add_flag("--pbrt", options->asPbrt,
                      "Write one pbrt file without includes, with absolute paths and these settings:");
    command->add_option("--resolution", options->resolution, "With --pbrt: size of the film, as 1280x720");
    command->add_option("--spp", options->spp, "With --pbrt: samples per pixel, of the sampler 'halton'")
        ->check(CLI::Range(1, limits::kSamplesPerPixel));
    command->add_option("--integrator", options->integrator, "With --pbrt: type of the integrator");
    command->add_option("--max-depth", options->maxDepth, "With --integrator: its 'maxdepth'")
        ->check(CLI::NonNegativeNumber);
    command->add_option("-o,--output", options->output, "File to write; default: standard output");
    command->footer(
        "Examples:\n"
        "  drc export --json scene.pbrt --meshes meshes -o scene.json\n"
        "  drc export --pbrt scene.pbrt --resolution 640x360 --spp 64 --integrator path -o copy.pbrt");
    command->callback([options, command] { exportScene(*options, *command); });
}

}  // namespace drc
