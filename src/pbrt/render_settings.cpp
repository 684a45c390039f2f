#include "pbrt/render_settings.h"

#include <algorithm>
#include <cmath>

#include "pbrt/registry.h"

namespace drc::pbrt {
namespace {

constexpr int kMaxResolution = 1 << 16;

int positive(const ParamSet& params, std::string_view name, int fallback, int most) {
    const int value = params.getInt(name, fallback);
    if (value < 1 || value > most)
        params.failAt(*params.find(name, {ParamType::Integer}),
                      "must be from 1 to " + std::to_string(most) + ", not " + std::to_string(value));
    return value;
}

void checkName(std::initializer_list<std::string_view> known, const std::string& kind, const std::string& name,
               const SourcePos& pos) {
    if (std::find(known.begin(), known.end(), name) == known.end())
        fail(pos, "unknown " + kind + " '" + name + "'" + suggestion(name, known));
}

}  // namespace

void applyFilm(const std::string& type, const ParamSet& params, RenderSettings& settings) {
    checkName({"image"}, "film", type, params.pos());
    settings.film.width = positive(params, "xresolution", settings.film.width, kMaxResolution);
    settings.film.height = positive(params, "yresolution", settings.film.height, kMaxResolution);
    settings.outputFile = params.getString("filename", settings.outputFile);
    settings.filmScale = params.getFloat("scale", 1);
    settings.maxSampleLuminance = params.getFloat("maxsampleluminance", kInfinity);
    params.ignore({"diagonal"});  // millimetres; for the realistic camera alone
    if (const Param* window = params.find("cropwindow", {ParamType::Float})) {
        if (window->numbers.size() != 4) params.failAt(*window, "must have four values of type 'float'");
        float crop[4];
        for (size_t i = 0; i < 4; ++i) crop[i] = std::clamp(float(window->numbers[i]), 0.f, 1.f);
        // As pbrt does, either order of the two edges.
        for (int axis = 0; axis < 2; ++axis) {
            settings.cropWindow[2 * axis] = std::min(crop[2 * axis], crop[2 * axis + 1]);
            settings.cropWindow[2 * axis + 1] = std::max(crop[2 * axis], crop[2 * axis + 1]);
            if (settings.cropWindow[2 * axis] == settings.cropWindow[2 * axis + 1]) params.failAt(*window, "is empty");
        }
    }
    params.warnUnused();
}

void applySampler(const std::string& type, const ParamSet& params, RenderSettings& settings) {
    checkName({"02sequence", "halton", "lowdiscrepancy", "maxmindist", "random", "sobol", "stratified"}, "sampler",
              type, params.pos());
    constexpr int kMost = 1 << 24;
    settings.sampler = type;
    if (type == "stratified") {
        const int64_t samples = int64_t(positive(params, "xsamples", 4, 4096)) * positive(params, "ysamples", 4, 4096);
        settings.samplesPerPixel = int(std::min<int64_t>(samples, kMost));
    } else {
        settings.samplesPerPixel = positive(params, "pixelsamples", 16, kMost);
    }
    // How the samples are laid out is ours to choose.
    params.ignore({"dimensions", "jitter", "samplepixelcenter"});
    params.warnUnused();
}

void applyIntegrator(const std::string& type, const ParamSet& params, RenderSettings& settings) {
    settings.integrator = type;
    settings.maxDepth = params.getInt("maxdepth", 5);
    if (settings.maxDepth < 0) params.failAt(*params.find("maxdepth", {ParamType::Integer}), "must not be negative");
    settings.rrThreshold = params.getFloat("rrthreshold", 1);
    settings.lightStrategy = params.getString("lightsamplestrategy", type == "bdpt" ? "power" : "spatial");
    params.notBuilt({"pixelbounds"});
    // Each integrator of pbrt's and of the original DRC's has knobs of its own; none of them changes the result.
    params.ignoreAll();
}

void checkAccelerator(const std::string& type, const ParamSet& params) {
    checkName({"bvh", "kdtree"}, "accelerator", type, params.pos());
    params.ignoreAll();
}

}  // namespace drc::pbrt
