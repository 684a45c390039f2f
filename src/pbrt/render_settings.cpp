#include "pbrt/render_settings.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "base/log.h"
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
    settings.film.diagonal = params.getFloat("diagonal", settings.film.diagonal);
    if (!(settings.film.diagonal > 0)) params.failAt(*params.find("diagonal", {ParamType::Float}), "must be positive");
    if (!(settings.filmScale >= 0)) params.failAt(*params.find("scale", {ParamType::Float}), "must not be negative");
    if (!(settings.maxSampleLuminance > 0))
        params.failAt(*params.find("maxsampleluminance", {ParamType::Float}), "must be positive");
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
        settings.samplesPerPixel = positive(params, "pixelsamples", type == "random" ? 4 : 16, kMost);
        // As in pbrt: these are good at powers of two alone.
        if (type != "random" && type != "halton")
            settings.samplesPerPixel = int(std::bit_ceil(unsigned(settings.samplesPerPixel)));
    }
    // How the samples are laid out is ours to choose.
    params.ignore({"dimensions", "jitter", "samplepixelcenter"});
    params.warnUnused();
    logDebug("sampler '" + type + "': Owen-scrambled Sobol points are used, as for every sampler");
}

namespace {

// The knobs of pbrt-v3's integrators that are for their own algorithms: nothing here has use for them.
const std::map<std::string_view, std::vector<std::string_view>> kIntegratorKnobs = {
    {"ambientocclusion", {"cossample", "nsamples"}},
    {"ao", {"cossample", "nsamples"}},
    {"bdpt", {"visualizestrategies", "visualizeweights"}},
    {"directlighting", {"strategy"}},
    {"mlt", {"bootstrapsamples", "chains", "largestepprobability", "mutationsperpixel", "sigma"}},
    {"path", {}},
    {"sppm", {"imagewritefrequency", "iterations", "numiterations", "photonsperiteration", "radius"}},
    {"volpath", {}},
    {"whitted", {}},
};

}  // namespace

void applyIntegrator(const std::string& type, const ParamSet& params, RenderSettings& settings) {
    settings.integrator = type;
    settings.maxDepth = params.getInt("maxdepth", 5);
    if (settings.maxDepth < 0) params.failAt(*params.find("maxdepth", {ParamType::Integer}), "must not be negative");
    settings.rrThreshold = params.getFloat("rrthreshold", 1);
    if (params.has("rrthreshold"))
        logDebug("integrator '" + type + "': 'rrthreshold' is not needed: paths end by their own throughput");
    settings.lightStrategy = params.getString("lightsamplestrategy", type == "bdpt" ? "power" : "spatial");
    if (const Param* strategy = params.find("lightsamplestrategy", {ParamType::String})) {
        if (settings.lightStrategy != "uniform" && settings.lightStrategy != "power" &&
            settings.lightStrategy != "spatial")
            params.failAt(*strategy, "must be 'uniform', 'power' or 'spatial', not '" + settings.lightStrategy + "'");
        logDebug("integrator '" + type + "': lights are chosen by what they can bring to a point, not by '" +
                 settings.lightStrategy + "'");
    }
    if (const Param* bounds = params.find("pixelbounds", {ParamType::Integer})) {
        if (bounds->numbers.size() != 4) params.failAt(*bounds, "must have four values of type 'integer'");
        PixelRegion& r = settings.pixelBounds.emplace();
        r = {int(bounds->numbers[0]), int(bounds->numbers[2]), int(bounds->numbers[1]), int(bounds->numbers[3])};
        if (r.width() < 1 || r.height() < 1)
            params.failAt(*bounds, "is empty: it must be x0 x1 y0 y1 in pixels, with x0 < x1 and y0 < y1");
    }
    const auto knobs = kIntegratorKnobs.find(type);
    if (knobs == kIntegratorKnobs.end()) {
        // Of an integrator that is not pbrt's own nothing is known.
        params.ignoreAll();
        return;
    }
    for (const std::string_view name : knobs->second) {
        if (!params.has(name)) continue;
        params.ignore({name});
        logDebug(fmt::format("integrator '{}': '{}' has no effect", type, name));
    }
    params.warnUnused();
}

void checkAccelerator(const std::string& type, const ParamSet& params) {
    checkName({"bvh", "kdtree"}, "accelerator", type, params.pos());
    params.ignoreAll();
}

}  // namespace drc::pbrt
