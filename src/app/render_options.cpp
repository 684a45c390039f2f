#include "app/render_options.h"

#include <fmt/ranges.h>

#include "app/display_options.h"
#include "app/option_checks.h"
#include "app/option_choice.h"
#include "app/usage_error.h"
#include "base/limits.h"
#include "integrators/integrator.h"
#include "view/stream_sender.h"

namespace drc {
namespace {

// The headings in --help of the options that only one integrator has.
constexpr const char* kMapGroup = "Radiance maps, with --integrator drc-maps alone";
constexpr const char* kCellGroup = "Radiance cells, with --integrator drc alone";

CLI::Validator streamAddress() {
    return {[](std::string& text) -> std::string {
                try {
                    parseStreamAddress(text);
                    return "";
                } catch (const Error& error) {
                    return error.what();
                }
            },
            "HOST:PORT|unix:PATH"};
}

void addAmounts(CLI::App& command, RenderOptions& o) {
    addChoice<Quality>(
        command, "--quality", o.params.quality,
        {{"draft", Quality::Draft}, {"standard", Quality::Standard}, {"high", Quality::High}},
        "draft, standard or high: sets the camera samples a pixel, and the map passes of drc-maps. Default: standard");
    command.add_flag_callback(
        "--quick", [&o] { o.params.quality = Quality::Draft; }, "The same as --quality draft, under pbrt's name");
    command
        .add_option(
            "--time", o.params.seconds,
            "Seconds for the whole run, including reading and writing. What is given beside it by --spp, --passes or "
            "--indirect-tasks is the most that is done: the run ends earlier if all of that is")
        ->check(secondsOfWork());
    command.add_option("--spp", o.params.spp, "Camera samples a pixel; with drc on average")
        ->check(wholeNumberIn(1, limits::kSamplesPerPixel));
    command
        .add_option(
            "--noise-threshold", o.noiseThreshold,
            "Stop where the denoised picture's relative error is estimated to be this, as 0.03; --time or --spp "
            "is then the most that is done, without them there is no bound. The estimate is the metadata "
            "drc:error, and with --aovs a layer. 0: only estimate")
        ->check(numberFrom(0));
    command.add_option("--max-depth", o.params.maxDepth, "Maximum length of paths, in non-specular bounces")
        ->check(wholeNumberFrom(1));
    command
        .add_option("--clamp", o.params.clamp,
                    "Upper bound on the luminance of a sample, which makes the picture biased; 0: no bound")
        ->capture_default_str()
        ->check(numberFrom(0));
    addSeedOption(command, o.params.seed, "Seed of all random numbers, together with the frame's number");
    command
        .add_option("--frame", o.frame,
                    "Number of the frame in its animation: frames of different numbers have different noise, and a "
                    "frame has the same whenever it is rendered. Default: the number at the end of the scene file's "
                    "name, as in shot.0007.pbrt, or 0")
        ->check(wholeNumberIn(0, 999999999));
}

void addFilm(CLI::App& command, RenderOptions& o) {
    command.add_option(
        "-o,--output,--outfile", o.outputs,
        "Picture to write, .exr or .png; may be repeated. Default: an EXR and a PNG, named by the scene's film");
    addSceneOverrides(command, o.overrides);
    command.add_flag("--aovs", o.aovs,
                     "Also write to EXR files the inputs of denoisers: the G-buffer (albedo, normal, depth), the "
                     "variance and the number of samples of each pixel; and what compositing and filters over time "
                     "need: Position, Depth, IndexOB, IndexMA, and two half buffers");
    addDisplayOptions(command, o.display);
}

void addMaps(CLI::App& command, RenderOptions& o) {
    const std::string group = command.option_defaults()->get_group();
    command.option_defaults()->group(kMapGroup);
    command.add_option("--passes", o.params.mapPasses, "Number of map passes, which trace radiance maps")
        ->check(wholeNumberFrom(0));
    command
        .add_option("--indirect-tasks", o.params.mapTasks,
                    "The same in the paper's unit: squares of ten by ten cells of the grid of maps")
        ->check(wholeNumberFrom(0));
    command
        .add_option(
            "--map-denoiser,--enhancer", o.mapDenoiser,
            "What removes the noise of radiance maps: network, gaussian, none, or oracle, which traces many samples "
            "a texel instead")
        ->capture_default_str()
        ->check(CLI::IsMember({"network", "gaussian", "none", "oracle"}));
    command.add_option("--oracle-spp", o.oracleSamples, "Samples a texel of the oracle's maps")
        ->capture_default_str()
        ->check(wholeNumberFrom(1));
    command.add_option(
        "--weights", o.weights,
        "The network: one that comes with the program (drc-fast, drc, paper-k64), or a safetensors file of "
        "weights. Default: drc");
    command.add_option("--precision", o.precision, "Precision of the network: auto, fp32 or bf16")
        ->capture_default_str()
        ->check(CLI::IsMember({"auto", "fp32", "bf16"}));
    command
        .add_option(
            "--projection", o.projection,
            "Projection of the maps: equal-area, latlong, or auto, which takes the one that the network was trained on")
        ->capture_default_str()
        ->check(CLI::IsMember({"auto", "equal-area", "latlong"}));
    command.add_option("--spacing", o.spacing, "Pixels between the maps of the first map pass; 1: a map at each pixel")
        ->check(CLI::Range(1.f, 10000.f));
    addChoice<Interpolation>(
        command, "--interpolation", o.params.indirect.interpolation,
        {{"geometry", Interpolation::Geometry}, {"distance", Interpolation::Distance}},
        "How a pixel weights the maps around it: by geometry, or by distance alone (for comparison). "
        "Default: geometry");
    command
        .add_option("--gather-samples", o.params.gatherSamples,
                    "Directions that a camera sample of a map pass gathers from the maps")
        ->check(wholeNumberFrom(1));
    command.add_flag(
        "--uncorrected", [&o](int64_t) { o.params.correct = false; },
        "Do not correct the maps' errors by path-traced samples");
    command.option_defaults()->group(group);
}

void addCells(CLI::App& command, RenderOptions& o) {
    const std::string group = command.option_defaults()->get_group();
    command.option_defaults()->group(kCellGroup);
    command
        .add_option("--cells", o.cells,
                    "on, off, with which drc is the path tracer, or a file of drc cells to begin with")
        ->capture_default_str();
    command.add_flag("--freeze-cells", o.params.freezeCells,
                     "Learn nothing beyond the file of --cells: a frame then has the same bits in any order of frames "
                     "and on any machine");
    command
        .add_option("--cell-size", o.params.cellSize,
                    "Edge of the smallest cells at first, in the scene's units. Default: by the distances that the "
                    "picture shows")
        ->check(numberAbove(0));
    command.option_defaults()->group(group);
}

}  // namespace

void addRenderOptions(CLI::App& command, RenderOptions& o) {
    command.add_option("SCENE", o.scene, "Scene file in the format of pbrt-v3 or pbrt-v4, or - for standard input")
        ->required();
    std::vector<std::string> integrators = integratorNames();
    integrators.push_back("scene");
    command
        .add_option("--integrator", o.params.integrator,
                    fmt::format("What renders the picture: {}, or scene, which takes what the scene file asks for",
                                fmt::join(integratorNames(), ", ")))
        ->capture_default_str()
        ->check(CLI::IsMember(integrators));
    addFilm(command, o);
    addAmounts(command, o);
    addChoice<Denoise>(command, "--denoise", o.params.denoise,
                       {{"auto", Denoise::Automatic},
                        {"off", Denoise::Off},
                        {"surface", Denoise::Surface},
                        {"oidn", Denoise::Oidn},
                        {"oidn-direct", Denoise::OidnDirect}},
                       "auto: surface with drc-maps, else oidn if it is found, else off; oidn: Intel's Open Image "
                       "Denoise on the whole "
                       "picture; oidn-direct: the same on the direct light of drc-maps alone; surface: averages the "
                       "layers of drc-maps along "
                       "surfaces, as far as their noise requires; off: nothing. Default: auto");
    addChoice<std::optional<OidnQuality>>(command, "--oidn-quality", o.params.oidnQuality,
                                          {{"auto", std::nullopt},
                                           {"high", OidnQuality::High},
                                           {"balanced", OidnQuality::Balanced},
                                           {"fast", OidnQuality::Fast}},
                                          "Quality of Open Image Denoise: high, balanced, fast, or auto: high, or "
                                          "what --time leaves time for. Default: auto");
    addChoice<std::optional<bool>>(
        command, "--oidn-prefilter", o.params.oidnPrefilter, {{"auto", std::nullopt}, {"on", true}, {"off", false}},
        "Whether Open Image Denoise filters albedo and normal first: on, off, or auto: where they are noisy and there "
        "is time for it. Default: auto");
    command.add_option("--oidn-library", o.oidnLibrary,
                       "libOpenImageDenoise.so, or a folder that has it. Default: $DRC_OIDN, else the one that "
                       "scripts/quickstart fetched, the system's, or that of a Python package (pip install pyoidn)");
    addThreadsOption(command, o.threads);
    command.add_option("--timing", o.timing,
                       "JSON file to write, with the seconds of reading, rendering, denoising and writing");
    CLI::Option* checkpoint = command.add_option(
        "--checkpoint", o.checkpoint,
        "File to save the render's state in now and then, and at its end, also if it is interrupted, so that it can go "
        "on later by --resume, with more samples too");
    command.add_option("--every", o.every, "How often: 60s, 5m, 1h")->capture_default_str()->needs(checkpoint);
    command.add_option("--resume", o.resume,
                       "Goes on from a checkpoint of the same scene and settings, to the same bits as if it had not "
                       "stopped; --spp, --time and --nthreads may differ");
    command
        .add_option(
            "--frames", o.frames,
            "File with the further frames of an animation, or - for standard input: lines of a scene file and, "
            "after a tab, the picture to write. Where they differ in the camera alone, scene and radiance cells "
            "are kept. --time is for each frame; a line on standard output tells that its picture is there")
        ->excludes("--lookat")
        ->excludes("--frame")
        ->excludes("--timing");
    command
        .add_flag("--temporal", o.temporal,
                  "With --frames: average each frame with the two before and the two after it where they show the same "
                  "surfaces in the same light, before it is denoised, so that the animation does not flicker. A frame "
                  "is written when the second one after it is rendered")
        ->needs("--frames")
        ->excludes("--checkpoint")
        ->excludes("--resume")
        ->excludes("--noise-threshold");
    command
        .add_option(
            "--display-server", o.displayServer,
            "HOST:PORT at which tev, the image viewer, listens, or unix:PATH of another program's socket: shows "
            "the picture there while it refines, and when it is finished. tev's own port is 14158")
        ->check(streamAddress())
        ->excludes("--temporal");
    command.add_flag("--stats", o.stats, "Print counts and times at the end");
    command.add_flag("--quiet", o.quiet, "Print only warnings and errors");
    command.add_flag("-v,--verbose", o.verbose, "Print more messages");
    addCells(command, o);
    addMaps(command, o);
    command.footer(
        "Exit codes: 0 the pictures are whole and in their place; 130 (Ctrl-C), 143 (SIGTERM) or 129 (SIGHUP)\n"
        "interrupted, pictures that there are have fewer samples; 1 an error, which is said.\n\n"
        "Example: drc render scene.pbrt --time 30 -o picture.png -o picture.exr");
}

void refuseIdleOptions(const CLI::App& command, const std::string& integrator) {
    const auto refuse = [&](const char* group, const char* things, const char* owner) {
        if (integrator == owner) return;
        std::vector<std::string> given;
        for (const CLI::Option* option : command.get_options())
            if (option->get_group() == group && option->count() > 0) given.push_back(option->get_name());
        if (given.empty()) return;
        throw UsageError(fmt::format("{}: integrator {} has no {}; only --integrator {} has", fmt::join(given, ", "),
                                     integrator, things, owner));
    };
    refuse(kMapGroup, "radiance maps", "drc-maps");
    refuse(kCellGroup, "radiance cells", "drc");
}

}  // namespace drc
