#include "render/picture_filters.h"

#include <fmt/core.h>

#include "base/error.h"
#include "base/log.h"
#include "integrators/integrator.h"
#include "reconstruct/oidn_picture_filter.h"
#include "reconstruct/surface_picture_filter.h"

namespace drc {
namespace {

// Greatest shares of a time budget for finishing the picture. Filters that were asked for may take most of it. Quality
// high is worth a small share, and balanced up to two fifths: with a budget of 10 s, fast increased the error by 10 to
// 30 % (docs/decisions/reconstruction-filters.md).
constexpr double kWanted = 0.7, kHigh = 0.1, kBalanced = 0.4;

bool isOidn(Denoise denoise) { return denoise == Denoise::Oidn || denoise == Denoise::OidnDirect; }

struct Mode {
    OidnSettings settings;
    bool unlessClean;
    double mostOfBudget;
    bool wanted;
    double microseconds;  // time of one core per pixel
};

std::vector<Mode> oidnModes(const RenderParams& params) {
    constexpr OidnAuxiliaries kRaw = OidnAuxiliaries::Raw, kPrefiltered = OidnAuxiliaries::Prefiltered;
    const std::optional<bool> prefilter = params.oidnPrefilter;
    if (!params.oidnQuality && !prefilter)
        // The times were measured at 1280x720 with version 2.5 on Zen 3; the time of high is that without prefiltering,
        // the cheaper case.
        return {{{OidnQuality::High, kPrefiltered}, true, kHigh, false, 12},
                {{OidnQuality::Balanced, kRaw}, true, kBalanced, false, 4.4},
                {{OidnQuality::Fast, kRaw}, true, kWanted, true, 2.5}};
    const OidnQuality quality = params.oidnQuality.value_or(OidnQuality::High);
    const bool raw = prefilter && !*prefilter;
    std::vector<Mode> modes{{{quality, raw ? kRaw : kPrefiltered}, !prefilter, kWanted, true, 0}};
    for (const OidnQuality cheaper : {OidnQuality::Balanced, OidnQuality::Fast})
        if (!raw || cheaper > quality) modes.push_back({{cheaper, kRaw}, !prefilter, kWanted, true, 0});
    return modes;
}

}  // namespace

ChosenDenoiser chooseDenoiser(Denoise wanted, const RenderParams& params,
                              const std::function<OidnLibraries()>& libraries) {
    const bool automatic = wanted == Denoise::Automatic && !traitsOf(params.integrator).maps;
    ChosenDenoiser chosen{automatic ? Denoise::Off : params.denoise, nullptr};
    if (chosen.denoise == Denoise::Surface) logInfo("denoiser: surface filter");
    if (!automatic && !isOidn(chosen.denoise)) return chosen;
    const OidnLibraries found = libraries();
    try {
        chosen.oidn = std::make_unique<OpenImageDenoise>(found);
    } catch (const Error& error) {
        if (!automatic || !found.namedBy.empty()) throw;
        logWarning(std::string("the picture will not be denoised: ") + error.what());
        return chosen;
    }
    if (automatic) chosen.denoise = Denoise::Oidn;
    const int version = chosen.oidn->version();
    logInfo(fmt::format("denoiser: Open Image Denoise {}.{}.{} ({})", version / 10000, version / 100 % 100,
                        version % 100, chosen.oidn->file()));
    return chosen;
}

ChosenDenoiser chooseDenoiser(RenderParams& params, const RenderSettings& settings) {
    const Denoise wanted = params.denoise;
    params = resolved(params, settings);
    ChosenDenoiser chosen = chooseDenoiser(wanted, params, [] { return findOidn(OidnSearch::ofProcess("")); });
    params.denoise = chosen.denoise;
    return chosen;
}

std::vector<PictureFilters> filtersFor(const RenderParams& params, const ChosenDenoiser& chosen) {
    const bool maps = traitsOf(params.integrator).maps;
    const auto correction = std::make_shared<SurfacePictureFilter>(false, params.correct);
    std::vector<PictureFilters> candidates;
    if (chosen.oidn)
        for (const Mode& mode : oidnModes(params)) {
            PictureFilters candidate{{}, mode.mostOfBudget, mode.wanted, 1e-6 * mode.microseconds};
            if (maps) candidate.filters.push_back(correction);
            candidate.filters.push_back(std::make_shared<OidnPictureFilter>(
                *chosen.oidn, mode.settings, mode.unlessClean, chosen.denoise == Denoise::OidnDirect));
            candidates.push_back(std::move(candidate));
        }
    if (chosen.denoise == Denoise::Surface)
        candidates.push_back({{std::make_shared<SurfacePictureFilter>(true, params.correct)}, kWanted, true, 0});
    if (maps && params.correct) candidates.push_back({{correction}, kWanted, true, 0});
    candidates.push_back({{}, kWanted, true, 0});
    return candidates;
}

LiveFilters::LiveFilters(const ChosenDenoiser& denoiser, const CancelToken& cancel) {
    if (!denoiser.oidn) return;
    const auto filter = [&](OidnQuality quality) {
        return std::make_unique<OidnPictureFilter>(*denoiser.oidn, OidnSettings{quality, OidnAuxiliaries::Raw}, true,
                                                   false, &cancel);
    };
    moving_ = filter(OidnQuality::Fast);
    still_ = filter(OidnQuality::Balanced);
}

void LiveFilters::apply(LayeredPicture& picture, bool moving) const {
    if (const auto& filter = moving ? moving_ : still_) filter->apply(picture);
}

DenoisedError LiveFilters::errorOf(const LayeredPicture& picture) const {
    return estimateDenoisedError(picture, [&](LayeredPicture& half) { apply(half, false); });
}

}  // namespace drc
