#include <cmath>
#include <filesystem>

#include "app/command.h"
#include "app/models.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/progress.h"
#include "cache/network_enhancer.h"
#include "image/image_io.h"
#include "pbrt/scene_file.h"
#include "render/open_image_denoise.h"
#include "render/renderer.h"

namespace drc {
namespace {

struct RenderOptions {
    std::string scene;
    std::vector<std::string> outputs;
    std::string integrator = "drc";
    std::string enhancer = "network";
    std::string quality = "standard";
    std::string weights;
    std::string precision = "auto";
    std::string projection = "auto";
    std::string resolution;
    std::vector<float> crop;
    std::optional<int> spp, passes, tasks, maxDepth, gatherSamples;
    std::optional<float> spacing;
    double time = 0;
    int oracleSamples = 64;
    int threads = 0;
    uint64_t seed = 0;
    float clamp = 0;
    std::string interpolation = "geometry";
    bool uncorrected = false;
    std::string denoise;  // empty: not asked for
    std::string oidnLibrary;
    std::string timing;
    bool aovs = false;
    bool usesOidn() const { return denoise == "oidn" || denoise == "oidn-direct"; }
    bool stats = false, quiet = false, verbose = false;
};

struct Quality {
    const char* name;
    int spp, passes, gatherSamples, pathSpp;
};
constexpr Quality kQualities[] = {{"draft", 16, 7, 4, 16}, {"standard", 64, 10, 4, 128}, {"high", 256, 16, 8, 1024}};

enum class OutputKind { Exr, Png };

OutputKind outputKind(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = char(std::tolower(c));
    if (extension == ".exr") return OutputKind::Exr;
    if (extension == ".png") return OutputKind::Png;
    throw Error("-o " + path + ": pictures are written as .exr or .png");
}

// Before the work, not after it: a folder that is missing or may not be written to.
void checkFolder(const std::string& option, const std::string& path) {
    const auto folder = std::filesystem::absolute(path).parent_path();
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
        throw Error(option + " " + path + ": there is no folder " + folder.string());
}

void checkOutput(const std::string& path) {
    outputKind(path);
    checkFolder("-o", path);
}

std::string integratorName(Integrator integrator) {
    switch (integrator) {
        case Integrator::Drc:
            return "drc";
        case Integrator::Path:
            return "path";
        case Integrator::Bdpt:
            return "bdpt";
        case Integrator::Direct:
            return "direct";
    }
    return "";
}

Integrator chooseIntegrator(const std::string& wanted, const RenderSettings& settings) {
    if (wanted == "drc") return Integrator::Drc;
    if (wanted == "path") return Integrator::Path;
    if (wanted == "direct") return Integrator::Direct;
    if (wanted == "bdpt") return Integrator::Bdpt;
    // The file's own.
    if (settings.integrator == "iispt") return Integrator::Drc;
    if (settings.integrator == "directlighting") return Integrator::Direct;
    if (settings.integrator == "bdpt") return Integrator::Bdpt;
    // Of "volpath" no more is left: media have warnings of their own.
    if (settings.integrator != "path" && settings.integrator != "volpath")
        logWarning("the scene's integrator '" + settings.integrator + "' is rendered as 'path'");
    return Integrator::Path;
}

struct ChosenEnhancer {
    std::shared_ptr<const Enhancer> enhancer;
    std::string weightsHash;
};

ChosenEnhancer chooseEnhancer(const RenderOptions& o, IndirectSettings& indirect) {
    const auto setProjection = [&](const std::string& ownOfNetwork) {
        const std::string& name = o.projection != "auto" ? o.projection
                                  : ownOfNetwork.empty() ? projectionName(Projection::EqualArea)
                                                         : ownOfNetwork;
        indirect.capture.layout = MapLayout(projectionFromName(name), indirect.capture.layout.size());
    };
    setProjection("");
    if (o.enhancer == "gaussian") return {makeGaussianEnhancer(1), ""};
    if (o.enhancer == "none") return {makeIdentityEnhancer(), ""};
    if (o.enhancer == "oracle") {
        indirect.capture.samplesPerTexel = o.oracleSamples;
        return {makeIdentityEnhancer(), ""};
    }
    const auto weights = UNetWeights::load(findWeights(o.weights));
    setProjection(weights->projection());
    std::optional<Precision> precision;
    if (o.precision != "auto") precision = o.precision == "fp32" ? Precision::Fp32 : Precision::Bf16;
    return {makeNetworkEnhancer(weights, indirect.capture.layout, precision), weights->hash()};
}

RenderParams makeParams(const RenderOptions& o, const Scene& scene) {
    RenderParams p;
    p.integrator = chooseIntegrator(o.integrator, scene.settings);
    p.seed = o.seed;
    const Quality* quality = &kQualities[1];
    for (const Quality& q : kQualities)
        if (o.quality == q.name) quality = &q;
    p.spp = o.spp.value_or(o.integrator == "scene" ? scene.settings.samplesPerPixel
                           : p.integrator == Integrator::Path || p.integrator == Integrator::Bdpt ? quality->pathSpp
                                                                                                  : quality->spp);
    p.passes = quality->passes;
    if (o.time <= 0) p.indirect.gatherSamples = quality->gatherSamples;
    if (o.gatherSamples) p.indirect.gatherSamples = *o.gatherSamples;
    if (o.tasks) p.passes = passesForTasks(*o.tasks, scene.settings.film.width, scene.settings.film.height);
    if (o.passes) p.passes = *o.passes;
    if (o.maxDepth)
        p.path.maxDepth = *o.maxDepth;
    else if (o.integrator == "scene")
        p.path.maxDepth = scene.settings.maxDepth;
    p.path.clamp = std::min(scene.settings.maxSampleLuminance, o.clamp > 0 ? o.clamp : kInfinity);
    p.correct = !o.uncorrected;
    p.denoise = o.denoise.empty() || o.denoise == "surface";
    if ((o.denoise == "surface" || o.denoise == "oidn-direct") && p.integrator != Integrator::Drc)
        throw Error("--denoise " + o.denoise + ": it filters the layers of --integrator drc, which others do not have");
    if (!o.oidnLibrary.empty() && !o.usesOidn()) throw Error("--oidn-library: needs --denoise oidn or oidn-direct");
    // Of what a pixel shows a few samples tell enough.
    constexpr int kShownSweeps = 16;
    if (o.aovs || o.usesOidn()) p.shownSweeps = kShownSweeps;
    p.noise = o.aovs;
    if (o.interpolation == "distance") p.indirect.interpolation = Interpolation::Distance;
    if (o.spacing) p.firstSpacing = *o.spacing / float(scene.settings.film.height);
    return p;
}

// Time to finish, encode and write the pictures, from measurements on slow cores.
double writeSeconds(const RenderOptions& o, const RenderParams& params, size_t pixels) {
    const bool layers = params.integrator == Integrator::Drc;
    // Filters run when the picture is taken, on all cores: of each of three layers twice, and of the correction.
    const int filtered = layers ? (params.denoise ? 6 : 0) + (params.correct ? 1 : 0) : 0;
    double seconds = 0.05 + double(pixels) * 2.1e-6 * filtered / threadCount();
    if (o.usesOidn()) seconds += 0.3 + double(pixels) * 14e-6 / threadCount();
    for (const std::string& path : o.outputs)
        seconds += double(pixels) * (outputKind(path) == OutputKind::Exr ? (layers ? 9e-7 : 4e-7) : 2.5e-7);
    return seconds;
}

void writePictures(const RenderOptions& o, const Scene& scene, const RenderedImage& picture,
                   const ExrMetadata& metadata) {
    const PixelRegion region = scene.settings.region();
    const ExrWindow window{region.x0, region.y0, scene.settings.film.width, scene.settings.film.height};
    for (const std::string& path : o.outputs) {
        if (outputKind(path) == OutputKind::Png) {
            writePng(path, picture.beauty);
            continue;
        }
        std::vector<ExrLayer> layers{{"", &picture.beauty}};
        if (picture.direct) layers.push_back({"direct", &*picture.direct});
        if (picture.indirect) layers.push_back({"indirect", &*picture.indirect});
        if (o.aovs) {  // by the names of Blender's Cycles
            layers.push_back({"Denoising Albedo", &picture.shown->albedo});
            layers.push_back({"Denoising Normal", &picture.shown->normal});
            layers.push_back({"Denoising Depth", &picture.shown->depth});
            layers.push_back({"Denoising Variance", &picture.noise->variance});
            layers.push_back({"Debug Sample Count", &picture.noise->samples});
        }
        writeExr(path, layers, metadata, window);
    }
}

RenderedImage denoised(RenderedImage picture, const OpenImageDenoise& oidn, bool directAlone) {
    Image& noisy = directAlone ? *picture.direct : picture.beauty;
    noisy = oidn.denoised(noisy, picture.shown->albedo, picture.shown->normal);
    if (!directAlone) return picture;
    for (size_t i = 0; i < noisy.data().size(); ++i)
        picture.beauty.data()[i] = std::max(0.f, noisy.data()[i] + picture.indirect->data()[i]);
    return picture;
}

void writeTiming(const std::string& path, Stats& stats) {
    const auto seconds = [&](const char* timer) { return stats.timer(timer).seconds(); };
    writeFileAtomically(path, fmt::format("{{\"load_seconds\": {:.4f}, \"render_seconds\": {:.4f}, \"write_seconds\": "
                                          "{:.4f}}}\n",
                                          seconds("load") + seconds("build"), seconds("render"), seconds("write")));
}

void render(RenderOptions o) {
    const auto start = processInfo().start;
    setLogLevel(o.quiet ? LogLevel::Quiet : o.verbose ? LogLevel::Verbose : LogLevel::Normal);
    setThreadCount(o.threads);
    installInterruptHandler();
    for (const std::string& path : o.outputs) checkOutput(path);
    if (!o.timing.empty()) checkFolder("--timing", o.timing);

    Stats stats;
    pbrt::LoadOptions load;
    if (!o.resolution.empty()) load.resolution = parseResolution(o.resolution);
    const auto scene = pbrt::loadPbrtFile(o.scene, load);
    stats.timer("load").add(std::chrono::steady_clock::now() - start);
    if (!o.crop.empty()) std::copy(o.crop.begin(), o.crop.end(), scene->settings.cropWindow);
    if (o.outputs.empty()) {
        const std::string stem = std::filesystem::path(scene->settings.outputFile).stem().string();
        o.outputs = {stem + ".exr", stem + ".png"};
        for (const std::string& path : o.outputs) checkOutput(path);
    }

    RenderParams params = makeParams(o, *scene);
    std::optional<OpenImageDenoise> oidn;
    if (o.usesOidn()) oidn.emplace(o.oidnLibrary);
    ChosenEnhancer chosen;
    if (params.integrator == Integrator::Drc) chosen = chooseEnhancer(o, params.indirect);
    if (o.time > 0) {
        const double reserve = writeSeconds(o, params, scene->settings.region().count());
        params.deadline = start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                      std::chrono::duration<double>(o.time - reserve));
    }
    const auto build = std::chrono::steady_clock::now();
    Renderer renderer(*scene, params, chosen.enhancer, &stats);
    stats.timer("build").add(std::chrono::steady_clock::now() - build);
    if (params.deadline && std::chrono::steady_clock::now() >= *params.deadline)
        throw Error(fmt::format("--time {:g}: reading the scene alone took {:.1f} s", o.time,
                                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()));

    const auto rendering = std::chrono::steady_clock::now();
    {
        Progress progress(std::filesystem::path(o.scene).filename().string(), 1000,
                          o.quiet ? ProgressMode::Quiet : ProgressMode::Auto);
        while (renderer.step(&interruptToken())) {
            progress.set(int64_t(renderer.progress() * 1000));
            progress.setNote(renderer.status());
        }
        if (!interruptToken().cancelled()) progress.set(1000);
    }

    const auto writing = std::chrono::steady_clock::now();
    stats.timer("render").add(writing - rendering);
    writePictures(o, *scene, oidn ? denoised(renderer.image(), *oidn, o.denoise == "oidn-direct") : renderer.image(),
                  {{"drc:version", DRC_VERSION},
                   {"drc:command", processInfo().commandLine},
                   {"drc:seed", std::to_string(o.seed)},
                   {"drc:integrator", integratorName(params.integrator)},
                   {"drc:enhancer", params.integrator == Integrator::Drc ? o.enhancer : ""},
                   {"drc:weights", chosen.weightsHash},
                   {"drc:spp", std::to_string(renderer.samplesDone())},
                   {"drc:passes", std::to_string(renderer.passesDone())}});
    stats.timer("write").add(std::chrono::steady_clock::now() - writing);
    std::string names;
    for (const std::string& path : o.outputs) names += (names.empty() ? "" : ", ") + path;
    logInfo(fmt::format("{}{}: {} in {:.1f} s", interruptToken().cancelled() ? "interrupted; " : "", names,
                        renderer.status(),
                        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()));
    if (!o.timing.empty()) writeTiming(o.timing, stats);
    if (o.stats) fmt::print("{}", stats.report());
}

}  // namespace

void addRenderCommand(CLI::App& app) {
    auto* command = app.add_subcommand("render", "Render a scene");
    auto o = std::make_shared<RenderOptions>();
    command->add_option("SCENE", o->scene, "Scene file, pbrt-v3 or pbrt-v4")->required();
    command->add_option("-o,--output", o->outputs,
                        "Picture to write, .exr or .png; may be repeated. Default: by the scene's film");
    command->add_option("--integrator", o->integrator, "drc, path, bdpt, direct, or scene: what the file asks for")
        ->capture_default_str()
        ->check(CLI::IsMember({"drc", "path", "bdpt", "direct", "scene"}));
    command->add_option("--quality", o->quality, "draft, standard or high: sets spp and passes")
        ->capture_default_str()
        ->check(CLI::IsMember({"draft", "standard", "high"}));
    command
        ->add_option("--time", o->time,
                     "Seconds for the whole run, reading and writing included; overrides spp and passes")
        ->check(CLI::PositiveNumber);
    command->add_option("--spp", o->spp, "Samples a pixel, of paths or of direct light")->check(CLI::PositiveNumber);
    command->add_option("--passes", o->passes, "Passes of radiance maps")->check(CLI::NonNegativeNumber);
    command->add_option("--indirect-tasks", o->tasks, "The same in the paper's unit: squares of ten by ten cells")
        ->check(CLI::NonNegativeNumber);
    command->add_option("--resolution", o->resolution, "WIDTHxHEIGHT in pixels, instead of the file's");
    command->add_option("--crop", o->crop, "x0 x1 y0 y1 in [0,1]: the part of the film to render")
        ->expected(4)
        ->check(CLI::Range(0.0, 1.0));
    command->add_option("--enhancer", o->enhancer, "network, gaussian, none, or oracle: many samples a texel")
        ->capture_default_str()
        ->check(CLI::IsMember({"network", "gaussian", "none", "oracle"}));
    command->add_option("--oracle-spp", o->oracleSamples, "Samples a texel of the oracle")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command->add_option(
        "--weights", o->weights,
        "The network: one that comes with the program (drc-fast, drc, paper-k64), or a file of weights, "
        "safetensors. Default: drc");
    command->add_option("--precision", o->precision, "Of the network: auto, fp32 or bf16")
        ->capture_default_str()
        ->check(CLI::IsMember({"auto", "fp32", "bf16"}));
    command
        ->add_option("--projection", o->projection,
                     "Of the maps: equal-area, latlong, or auto: what the network was trained on")
        ->capture_default_str()
        ->check(CLI::IsMember({"auto", "equal-area", "latlong"}));
    command->add_option("--spacing", o->spacing, "Pixels between the maps of the first pass; 1: a map at each pixel")
        ->check(CLI::Range(1.f, 10000.f));
    command
        ->add_option("--interpolation", o->interpolation,
                     "What weighs a pixel's maps: geometry, or their distance alone (for comparison)")
        ->capture_default_str()
        ->check(CLI::IsMember({"geometry", "distance"}));
    command->add_option("--gather-samples", o->gatherSamples, "Directions that a camera sample gathers from a pass")
        ->check(CLI::PositiveNumber);
    command->add_option("--max-depth", o->maxDepth, "Longest path, in non-specular bounces")
        ->check(CLI::PositiveNumber);
    command->add_option("--clamp", o->clamp, "Largest luminance of a path sample (biased); 0: none")
        ->capture_default_str();
    command->add_option("--seed", o->seed, "Seed of all random numbers")->capture_default_str();
    command->add_option("--nthreads", o->threads, "Threads; 0: one a core")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
    command->add_flag("--uncorrected", o->uncorrected, "Leave out the correction of the maps by path-traced samples");
    command
        ->add_option("--denoise", o->denoise,
                     "surface: average drc's layers along surfaces as far as their noise asks for it; oidn: Intel's "
                     "Open Image Denoise; oidn-direct: the same on the direct layer alone; or off. Default: surface "
                     "with drc, else off")
        ->check(CLI::IsMember({"off", "surface", "oidn", "oidn-direct"}));
    command->add_option("--oidn-library", o->oidnLibrary,
                        "libOpenImageDenoise.so, where the system does not find it by itself");
    command->add_flag(
        "--aovs", o->aovs,
        "Write what denoisers want to EXR files: albedo, normal and depth of what each pixel shows, variance "
        "and number of its samples");
    command->add_option("--timing", o->timing, "File to write seconds of reading, rendering and writing to, as JSON");
    command->add_flag("--stats", o->stats, "Print counts and times when done");
    command->add_flag("--quiet", o->quiet, "Say nothing but warnings and errors");
    command->add_flag("-v,--verbose", o->verbose, "Say more");
    command->footer("Example: drc render scene.pbrt --time 30 -o picture.png -o picture.exr");
    command->callback([o] { render(*o); });
}

}  // namespace drc
