#include "pbrt/render_settings.h"

#include <bit>

#include "base/limits.h"
#include "base/log.h"
#include "pbrt/render_settings_params.h"

namespace drc::pbrt {

void applyFilm(const std::string& type, const ParamSet& params, RenderSettings& settings) {
    checkKnown({"image"}, "film", type, params.pos());
    applyFrame(params, settings);
    settings.filmScale = params.getNonNegativeFloat("scale", 1);
    settings.transparentFilm = params.getBool("transparent", false);
    settings.maxSampleLuminance = params.getPositiveFloat("maxsampleluminance", kInfinity);
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
        // As in pbrt, the count is rounded up to a power of two, for which these samplers work best.
        if (type != "random" && type != "halton")
            settings.samplesPerPixel = int(std::bit_ceil(unsigned(settings.samplesPerPixel)));
    }
    // The renderer chooses the sampling pattern itself.
    params.ignore({"dimensions", "jitter", "samplepixelcenter"});
    params.warnUnused();
    logDebug("sampler '" + type + "': Owen-scrambled Sobol points are used, as for every sampler");
}

namespace {

const IntegratorKnobs kKnobs = {
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
    params.getFloat("rrthreshold", 1);
    if (params.has("rrthreshold"))
        logDebug("integrator '" + type + "': 'rrthreshold' is not needed: paths end by their own throughput");
    acceptChoiceOfLights(params, "lightsamplestrategy", {"power", "spatial", "uniform"}, type);
    applyPixelBounds(params, settings);
    acceptKnobs(kKnobs, type, params);
}

void checkAccelerator(const std::string& type, const ParamSet& params) {
    checkKnown({"bvh", "kdtree"}, "accelerator", type, params.pos());
    params.ignoreAll();
}

}  // namespace drc::pbrt
