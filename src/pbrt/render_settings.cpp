#include "pbrt/render_settings.h"

#include <fmt/core.h>

#include <bit>
#include <map>

#include "base/limits.h"
#include "base/log.h"
#include "pbrt/render_settings_params.h"

namespace drc::pbrt {
void applyFilm(const std::string& type, const ParamSet& params, RenderSettings& settings) {
    checkKnown({"image"}, "film", type, params.pos());
    applyFrame(params, settings);
    settings.filmScale = params.getFloat("scale", 1);
    settings.maxSampleLuminance = params.getFloat("maxsampleluminance", kInfinity);
    if (!(settings.filmScale >= 0)) params.failAt(*params.find("scale", {ParamType::Float}), "must not be negative");
    if (!(settings.maxSampleLuminance > 0))
        params.failAt(*params.find("maxsampleluminance", {ParamType::Float}), "must be positive");
    params.warnUnused();
}

void applySampler(const std::string& type, const ParamSet& params, RenderSettings& settings) {
    checkKnown({"02sequence", "halton", "lowdiscrepancy", "maxmindist", "random", "sobol", "stratified"}, "sampler",
               type, params.pos());
    settings.sampler = type;
    if (type == "stratified") {
        settings.samplesPerPixel = samplesOfStratified(params);
    } else {
        settings.samplesPerPixel =
            positiveOf(params, "pixelsamples", type == "random" ? 4 : 16, limits::kSamplesPerPixel);
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
    settings.maxDepth = maxDepthOf(params);
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
    applyPixelBounds(params, settings);
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
    checkKnown({"bvh", "kdtree"}, "accelerator", type, params.pos());
    params.ignoreAll();
}

}  // namespace drc::pbrt
