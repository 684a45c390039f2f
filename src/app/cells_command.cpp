// `drc cells`: files of radiance cells, which the frames of a shot share.
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "app/command.h"
#include "app/exit_code.h"
#include "app/option_checks.h"
#include "app/scene_overrides.h"
#include "app/usage_error.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/limits.h"
#include "base/log.h"
#include "base/progress.h"
#include "render/cell_training.h"
#include "render/cells_file.h"
#include "render/frame_list.h"
#include "render/picture_writer.h"
#include "render/same_world.h"

namespace drc {
namespace {

struct TrainOptions {
    std::string scene, frames, part, output;
    SceneOverrides overrides;
    RenderParams params;
    CellTraining training;
    int threads = 0;
    bool quiet = false;
};

// "2/5": the second of five.
void readPart(const std::string& text, CellTraining& training) {
    const size_t slash = text.find('/');
    const auto number = [&](size_t begin, size_t end) {
        const std::string digits = text.substr(begin, end - begin);
        const bool isNumber = !digits.empty() && digits.size() <= 4 &&
                              std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
        return isNumber ? std::stoi(digits) : 0;
    };
    const int part = slash == std::string::npos ? 0 : number(0, slash);
    const int parts = slash == std::string::npos ? 0 : number(slash + 1, text.size());
    if (part < 1 || part > parts || parts > CellTraining::kMostParts)
        throw UsageError(
            fmt::format("--part {}: must be as 2/5, the second of five parts, of which there are at most {}", text,
                        CellTraining::kMostParts));
    training.part = part - 1;
}

// The cameras of the scene and of the frames after it.
std::vector<Sensor> sensorsOf(const TrainOptions& o, const Scene& scene) {
    std::vector<Sensor> sensors{scene.sensor};
    if (o.frames.empty()) return sensors;
    const SameWorld world(scene);
    FrameList list(o.frames);
    while (const std::optional<FrameFiles> frame = list.next()) {
        const std::unique_ptr<Scene> camera = world.cameraIn(frame->scene, scene, o.overrides.loadOptions());
        if (!camera)
            throw Error(fmt::format("{}: its world is not that of {}; cells are of one world, so train them for each",
                                    frame->scene, o.scene));
        sensors.push_back(camera->sensor);
    }
    return sensors;
}

// Says what a file of cells has.
std::string summary(const CellCollection& cells) {
    return fmt::format("{} cells of {} deposits, the finest {:g} wide", cells.cells.size(), cells.deposits,
                       cells.size / float(1 << cells.refined));
}

void train(TrainOptions o) {
    setLogLevel(o.quiet ? LogLevel::Quiet : LogLevel::Normal);
    setThreadCount(o.threads);
    installInterruptHandler();
    o.overrides.check();
    if (!o.part.empty()) readPart(o.part, o.training);
    checkOutput("-o", o.output);
    const std::unique_ptr<const Scene> scene = o.overrides.load(o.scene);
    const RenderParams params = asUsage([&] { return resolved(o.params, scene->sensor.settings); });
    const Identity identity = cellsIdentity(*scene, params);
    Progress progress(std::filesystem::path(o.scene).filename().string(), 1000,
                      o.quiet ? ProgressMode::Quiet : ProgressMode::Auto);
    o.training.cancel = &interruptToken();
    o.training.visited = [&](double share, double error) {
        progress.set(int64_t(share * 1000));
        progress.setNote(fmt::format("error of the cells {:.3f}", error));
    };
    CellCollection cells = trainCells(*scene, sensorsOf(o, *scene), params, o.training);
    progress.finish();
    if (const size_t dropped = cells.bound())
        logWarning(fmt::format("{} cells with the fewest deposits are left out: a file keeps {}", dropped,
                               CellCollection::kMostCells));
    saveCells(o.output, cells, identity);
    logInfo(fmt::format("{}{}: {}", interruptToken().cancelled() ? "interrupted; " : "", o.output, summary(cells)));
    if (interruptToken().cancelled()) exitCode() = 128 + interruptSignal();
}

void merge(const std::vector<std::string>& files, const std::string& output) {
    checkOutput("-o", output);
    const Identity identity = identityOfCells(files[0], files[0]);
    CellCollection all;
    for (const std::string& file : files) {
        const CellCollection cells = loadCells(file, file, identity);
        if (file == files[0]) {
            all = cells;
            continue;
        }
        if (!all.sameGrid(cells))
            throw Error(fmt::format("{}: its cells are {:g} wide, those of {} {:g}; give all parts one --cell-size",
                                    file, cells.size, files[0], all.size));
        all.add(cells);
    }
    if (const size_t dropped = all.bound())
        logWarning(fmt::format("{} cells with the fewest deposits are left out: a file keeps {}", dropped,
                               CellCollection::kMostCells));
    saveCells(output, all, identity);
    logInfo(fmt::format("{}: {}", output, summary(all)));
}

void info(const std::string& file) {
    const Identity identity = identityOfCells(file, file);
    const CellCollection cells = loadCells(file, file, identity);
    fmt::print("{}\n  cells      {}\n  deposits   {}\n  size       {:g}, {} nested sizes\n", file, cells.cells.size(),
               cells.deposits, cells.size / float(1 << cells.refined), cells.sizes);
    size_t others = 0;
    for (const auto& [name, value] : identity) {
        if (name.starts_with(kIdentityFile))
            ++others;
        else
            fmt::print("  {} = {}\n", name, value);
    }
    fmt::print("  and {} files that the scene names\n", others);
}

void addTrain(CLI::App& cells) {
    auto* command = cells.add_subcommand("train", "Learn the light of a scene, for all cameras of a shot");
    auto o = std::make_shared<TrainOptions>();
    command->add_option("SCENE", o->scene, "pbrt-v3 or pbrt-v4 scene file")->required();
    command->add_option("-o,--output", o->output, "File of the cells")->required();
    command->add_option("--frames", o->frames,
                        "List of further frames, as drc render --frames has it; they must differ in the camera alone");
    addSceneOverrides(*command, o->overrides);
    command->add_option("--time", o->training.seconds, "Seconds of training")->check(secondsOfWork());
    command->add_option("--spp", o->training.spp, "Samples of each pixel of a small film at each camera")
        ->check(wholeNumberIn(1, limits::kSamplesPerPixel));
    command->add_option("--part", o->part, "I/N: one of N parts with samples of their own, for drc cells merge");
    command
        ->add_option("--cell-size", o->params.cellSize,
                     "Edge of the smallest cells, in the scene's units. Default: by the distances that the cameras "
                     "show")
        ->check(numberAbove(0));
    command->add_option("--max-depth", o->params.maxDepth, "Maximum length of paths, in non-specular bounces")
        ->check(wholeNumberFrom(1));
    addSeedOption(*command, o->params.seed, "Seed of all random numbers");
    addThreadsOption(*command, o->threads);
    command->add_flag("--quiet", o->quiet, "Print only warnings and errors");
    command->footer(
        "Without --time and --spp it ends when the cells' error hardly falls any more. An interrupted training is "
        "written.\nExample: drc cells train shot-001.pbrt --frames rest.txt --time 60 -o shot.cells");
    command->callback([o] { train(*o); });
}

}  // namespace

void addCellsCommand(CLI::App& app) {
    auto* cells = app.add_subcommand("cells", "Train, merge and describe files of radiance cells");
    cells->require_subcommand(1);
    addTrain(*cells);
    auto* merging = cells->add_subcommand("merge", "Add up files of cells of one scene, in any order");
    auto files = std::make_shared<std::vector<std::string>>();
    auto output = std::make_shared<std::string>();
    merging->add_option("FILE", *files, "Files of cells, each of samples of its own")->required();
    merging->add_option("-o,--output", *output, "File of the sum")->required();
    merging->callback([files, output] { merge(*files, *output); });
    auto* describing = cells->add_subcommand("info", "Print what a file of cells has, and what it is of");
    auto file = std::make_shared<std::string>();
    describing->add_option("FILE", *file, "File of cells")->required();
    describing->callback([file] { info(*file); });
}

}  // namespace drc
