// Chooses the denoiser of a picture, and the filters that finish it.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "integrators/render_params.h"
#include "reconstruct/denoised_error.h"
#include "reconstruct/open_image_denoise.h"
#include "reconstruct/picture_filter.h"

namespace drc {

struct ChosenDenoiser {
    Denoise denoise = Denoise::Off;          // never Automatic
    std::unique_ptr<OpenImageDenoise> oidn;  // not null if denoise is Oidn or OidnDirect
};

// Decides what --denoise auto stands for: the surface filter with integrators that have map passes; else Open Image
// Denoise, if it is found. Logs the denoiser in one line, unless none was wanted; if auto finds none, a warning says
// how to get it. wanted: from the command line. params: resolved. libraries: called if Open Image Denoise is wanted.
// Throws Error if it is wanted by name, or its library is named, and it cannot be used.
ChosenDenoiser chooseDenoiser(Denoise wanted, const RenderParams& params,
                              const std::function<OidnLibraries()>& libraries);

// Like the function above, with the default search for libraries: resolves the parameters and sets params.denoise.
ChosenDenoiser chooseDenoiser(RenderParams& params, const RenderSettings& settings);

struct PictureFilters {
    std::vector<std::shared_ptr<const PictureFilter>> filters;
    // Greatest share of a time budget that these filters may take, if a cheaper set comes after them.
    double mostOfBudget = 0;
    // Whether these filters were asked for, so that the user is told if cheaper ones replace them.
    bool wanted = true;
    // Expected time of one core per pixel of a large picture, so that filters that are far too expensive are not even
    // measured; 0: unknown.
    double secondsPerPixel = 0;

    // The name of the last filter, for example "oidn high".
    std::string name() const { return filters.empty() ? "nothing" : filters.back()->name(); }
};

// The wanted filters, then cheaper ones that replace them when time is short; never empty. params: resolved. chosen
// must outlive the filters.
std::vector<PictureFilters> filtersFor(const RenderParams& params, const ChosenDenoiser& chosen);

// The filters of a picture that is watched while it refines: the fastest one while the camera moves.
class LiveFilters {
  public:
    // cancel: raised when the present picture will not be shown. Token and denoiser must outlive the filters.
    LiveFilters(const ChosenDenoiser& denoiser, const CancelToken& cancel);
    void apply(LayeredPicture& picture, bool moving) const;
    // Estimates the error of the picture as it is filtered at rest. picture: unfiltered, with half buffers.
    DenoisedError errorOf(const LayeredPicture& picture) const;

  private:
    std::unique_ptr<const PictureFilter> moving_, still_;  // null: pictures stay as they are
};

}  // namespace drc
