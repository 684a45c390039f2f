#include "app/render_options.h"

#include <fmt/ranges.h>

#include "app/option_checks.h"
#include "render/integrator.h"

namespace drc {
namespace {

// An option of a few words, each with what it stands for.
template <class T>
CLI::Option* addChoice(CLI::App& command, const std::string& name, T& value,
                       const std::vector<std::pair<std::string, T>>& choices, const std::string& description) {
    std::vector<std::string> names;
    for (const auto& choice : choices) names.push_back(choice.first);
    return command
        .add_option_function<std::string>(
            name,
            [&value, choices](const std::string& text) {
                for (const auto& [choice, meaning] : choices)
                    if (choice == text) value = meaning;
            },
            description)
        ->check(CLI::IsMember(names));
}

void addAmounts(CLI::App& command, RenderOptions& o) {
    addChoice<Quality>(command, "--quality", o.params.quality,
                       {{"draft", Quality::Draft}, {"standard", Quality::Standard}, {"high", Quality::High}},
                       "draft, standard or high: sets spp and passes. Default: standard");
    command.add_flag_callback(
        "--quick", [&o] { o.params.quality = Quality::Draft; }, "The same as --quality draft, as pbrt spells it");
    command
        .add_option("--time", o.params.seconds,
                    "Seconds for the whole run, reading and writing included; overrides spp and passes")
        ->check(numberAbove(0));
    command.add_option("--spp", o.params.spp, "Camera samples a pixel, of paths or of direct light")
        ->check(wholeNumberFrom(1));
    command.add_option("--passes", o.params.mapPasses, "Passes of radiance maps")->check(wholeNumberFrom(0));
    command
        .add_option("--indirect-tasks", o.params.mapTasks, "The same in the paper's unit: squares of ten by ten cells")
        ->check(wholeNumberFrom(0));
    command.add_option("--max-depth", o.params.maxDepth, "Longest path, in non-specular bounces")
        ->check(wholeNumberFrom(1));
    command.add_option("--clamp", o.params.clamp, "Largest luminance of a sample (biased); 0: none")
        ->capture_default_str()
        ->check(numberFrom(0));
    command.add_option("--seed", o.params.seed, "Seed of all random numbers")->capture_default_str();
}

void addFilm(CLI::App& command, RenderOptions& o) {
    command.add_option("-o,--output,--outfile", o.outputs,
                       "Picture to write, .exr or .png; may be repeated. Default: by the scene's film");
    command.add_option("--resolution", o.resolution, "WIDTHxHEIGHT in pixels, instead of the file's");
    command.add_option("--crop,--cropwindow", o.crop, "x0 x1 y0 y1 in [0,1]: the part of the film to render")
        ->expected(4);
    command
        .add_option("-D", o.overrides,
                    "NAME=VALUE: a parameter of the file's film, sampler or integrator, as film.xresolution=640; may "
                    "be repeated")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command.add_flag("--aovs", o.aovs,
                     "Write what denoisers want to EXR files: albedo, normal and depth of what each pixel shows, "
                     "variance and number of its samples");
}

void addMaps(CLI::App& command, RenderOptions& o) {
    command
        .add_option("--map-denoiser,--enhancer", o.mapDenoiser,
                    "network, gaussian, none, or oracle: many samples a texel")
        ->capture_default_str()
        ->check(CLI::IsMember({"network", "gaussian", "none", "oracle"}));
    command.add_option("--oracle-spp", o.oracleSamples, "Samples a texel of the oracle")
        ->capture_default_str()
        ->check(wholeNumberFrom(1));
    command.add_option("--weights", o.weights,
                       "The network: one that comes with the program (drc-fast, drc, paper-k64), or a file of weights, "
                       "safetensors. Default: drc");
    command.add_option("--precision", o.precision, "Of the network: auto, fp32 or bf16")
        ->capture_default_str()
        ->check(CLI::IsMember({"auto", "fp32", "bf16"}));
    command
        .add_option("--projection", o.projection,
                    "Of the maps: equal-area, latlong, or auto: what the network was trained on")
        ->capture_default_str()
        ->check(CLI::IsMember({"auto", "equal-area", "latlong"}));
    command.add_option("--spacing", o.spacing, "Pixels between the maps of the first pass; 1: a map at each pixel")
        ->check(CLI::Range(1.f, 10000.f));
    addChoice<Interpolation>(command, "--interpolation", o.params.indirect.interpolation,
                             {{"geometry", Interpolation::Geometry}, {"distance", Interpolation::Distance}},
                             "What weighs a pixel's maps: geometry, or their distance alone (for comparison). Default: "
                             "geometry");
    command
        .add_option("--gather-samples", o.params.gatherSamples, "Directions that a camera sample gathers from a pass")
        ->check(wholeNumberFrom(1));
    command.add_flag(
        "--uncorrected", [&o](int64_t) { o.params.correct = false; },
        "Leave out the correction of the maps by path-traced samples");
}

}  // namespace

void addRenderOptions(CLI::App& command, RenderOptions& o) {
    command.add_option("SCENE", o.scene, "Scene file, pbrt-v3 or pbrt-v4")->required();
    std::vector<std::string> integrators = integratorNames();
    integrators.push_back("scene");
    command
        .add_option("--integrator", o.params.integrator, "drc, path, bdpt, direct, or scene: what the file asks for")
        ->capture_default_str()
        ->check(CLI::IsMember(integrators));
    addFilm(command, o);
    addAmounts(command, o);
    addMaps(command, o);
    addChoice<Denoise>(command, "--denoise", o.params.denoise,
                       {{"off", Denoise::Off},
                        {"surface", Denoise::Surface},
                        {"oidn", Denoise::Oidn},
                        {"oidn-direct", Denoise::OidnDirect}},
                       "surface: average drc's layers along surfaces as far as their noise asks for it; oidn: Intel's "
                       "Open Image Denoise; oidn-direct: the same on direct light alone; or off. Default: surface with "
                       "drc, else off");
    addChoice<OidnQuality>(
        command, "--oidn-quality", o.params.oidn.quality,
        {{"high", OidnQuality::High}, {"balanced", OidnQuality::Balanced}, {"fast", OidnQuality::Fast}},
        "Of Open Image Denoise: high, balanced or fast. Default: high");
    addChoice<bool>(command, "--oidn-prefilter", o.params.oidn.prefilter, {{"on", true}, {"off", false}},
                    "Whether Open Image Denoise filters albedo and normal first. Default: on");
    command.add_option("--oidn-library", o.oidnLibrary,
                       "libOpenImageDenoise.so, where the system does not find it by itself");
    command.add_option("--nthreads", o.threads, "Threads; 0: one a core")
        ->capture_default_str()
        ->check(wholeNumberFrom(0));
    command.add_option("--timing", o.timing,
                       "File to write seconds of reading, rendering, denoising and writing to, as JSON");
    command.add_flag("--stats", o.stats, "Print counts and times when done");
    command.add_flag("--quiet", o.quiet, "Say nothing but warnings and errors");
    command.add_flag("-v,--verbose", o.verbose, "Say more");
    command.footer("Example: drc render scene.pbrt --time 30 -o picture.png -o picture.exr");
}

}  // namespace drc
