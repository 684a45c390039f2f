#include "pbrt/render_settings_v4.h"

#include <fmt/core.h>

#include "base/limits.h"
#include "base/log.h"
#include "image/white_balance.h"
#include "pbrt/render_settings_params.h"
#include "pbrt/spectrum.h"

namespace drc::pbrt {

namespace {

// Balances for light of the temperature "whitebalance" (kelvin): daylight, or a black body below the daylight locus.
std::optional<RgbMatrix> whiteBalanceOf(const ParamSet& params) {
    constexpr float kLowest = 1000, kCoolestDaylight = 4000, kHighest = 25000;
    const float kelvin = params.getFloat("whitebalance", 0);
    if (kelvin == 0) return std::nullopt;
    if (!(kelvin >= kLowest && kelvin <= kHighest))
        params.failAt(*params.find("whitebalance", {ParamType::Float}),
                      fmt::format("must be a temperature from {:g} to {:g} kelvin, or 0 for none", kLowest, kHighest));
    return whiteBalance(kelvin < kCoolestDaylight ? blackbodyToRgb(kelvin) : daylight(kelvin));
}

}  // namespace

void applyFilmV4(const std::string& type, const ParamSet& params, RenderSettings& settings) {
    checkKnown({"gbuffer", "rgb", "spectral"}, "film", type, params.pos());
    if (type == "spectral")
        warn(params.pos(), "film 'spectral' is not supported yet; the picture is written as film 'rgb' has it");
    if (type == "gbuffer")
        warn(params.pos(),
             "of film 'gbuffer' EXR files get albedo, normal, depth and variance, under the names of --aovs; its other "
             "channels are not supported yet");
    settings.auxiliaryLayers = type == "gbuffer";
    applyFrame(params, settings);
    applyPixelBounds(params, settings);
    // pbrt also multiplies by the exposure time, see exposureTimeV4(). In pbrt-v4's first versions, the film had it as
    // a parameter.
    settings.filmScale = params.getPositiveFloat("iso", 100) / 100 * params.getPositiveFloat("exposuretime", 1);
    const std::string sensor = params.getString("sensor", "cie1931");
    if (sensor != "cie1931")
        warn(params.find("sensor", {ParamType::String})->valuePos,
             "the sensor '" + sensor + "' is not supported yet; 'cie1931' is used");
    settings.whiteBalance = whiteBalanceOf(params);
    settings.transparentFilm = params.getBool("transparent", false);
    // This limit applies to luminance, so samples that are bright in only one channel are clamped slightly later than
    // in pbrt.
    settings.maxSampleLuminance = params.getPositiveFloat("maxcomponentvalue", kInfinity);
    params.ignore({"savefp16"});
    if (type == "gbuffer") params.ignore({"coordinatesystem"});
    if (type == "spectral") params.ignore({"lambdamax", "lambdamin", "nbuckets"});
    params.warnUnused();
}

void applySamplerV4(const std::string& type, const ParamSet& params, RenderSettings& settings) {
    checkKnown({"halton", "independent", "paddedsobol", "pmj02bn", "sobol", "stratified", "zsobol"}, "sampler", type,
               params.pos());
    settings.sampler = type;
    settings.samplesPerPixel = type == "stratified" ? samplesOfStratified(params)
                                                    : positiveOf(params, "pixelsamples", type == "independent" ? 4 : 16,
                                                                 limits::kSamplesPerPixel);
    params.ignore({"jitter", "randomization", "seed"});
    params.warnUnused();
    logDebug("sampler '" + type + "': Owen-scrambled Sobol points are used, as for every sampler");
}

namespace {

const IntegratorKnobs kKnobs = {
    {"ambientocclusion", {"cossample", "maxdistance"}},
    {"bdpt", {"visualizestrategies", "visualizeweights"}},
    {"function", {"function", "imagefilename"}},
    {"lightpath", {}},
    {"mlt", {"bootstrapsamples", "chains", "largestepprobability", "mutationsperpixel", "sigma"}},
    {"path", {}},
    {"randomwalk", {}},
    {"simplepath", {"samplebsdf", "samplelights"}},
    {"simplevolpath", {}},
    {"sppm", {"photonsperiteration", "radius", "seed"}},
    {"volpath", {}},
};

}  // namespace

void applyIntegratorV4(const std::string& type, const ParamSet& params, RenderSettings& settings) {
    settings.integrator = type;
    settings.maxDepth = maxDepthOf(params);
    acceptChoiceOfLights(params, "lightsampler", {"bvh", "exhaustive", "power", "uniform"}, type);
    if (params.getBool("regularize", false))
        warn(params.find("regularize", {ParamType::Bool})->pos,
             "parameter 'regularize' of " + params.owner() + " is not supported yet; no surface is made rougher");
    acceptKnobs(kKnobs, type, params);
}

}  // namespace drc::pbrt
