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
    std::unique_ptr<OpenImageDenoise> oidn;  // if it is Oidn or OidnDirect
};

// Decides what --denoise auto stands for: the surface filter with integrators that have map passes; else Open Image
// Denoise, if it is found. Says in one line which denoiser is used, unless it was told to use none; where auto finds
// none, a warning says how to get it. wanted: as the command line gave it. params: resolved. libraries: called if Open
// Image Denoise is wanted. Throws Error if it is wanted by name, or its library is named, and it cannot be used.
ChosenDenoiser chooseDenoiser(Denoise wanted, const RenderParams& params,
                              const std::function<OidnLibraries()>& libraries);

// Chooses without a word from the caller about libraries: resolves the parameters, and sets RenderParams::denoise.
ChosenDenoiser chooseDenoiser(RenderParams& params, const RenderSettings& settings);

struct PictureFilters {
    std::vector<std::shared_ptr<const PictureFilter>> filters;
    // Largest share of a time budget that they may take, if a cheaper set comes after them.
    double mostOfBudget = 0;
    // Whether they were asked for, so that the user is told if cheaper ones replace them.
    bool wanted = true;
    // The time that one core may be expected to take for a pixel of a large picture, so that what is far too expensive
    // need not be tried; 0: not known.
    double secondsPerPixel = 0;

    // As "oidn high"; of the last one.
    std::string name() const { return filters.empty() ? "nothing" : filters.back()->name(); }
};

// The wanted filters, then cheaper ones that replace them when time is short; never empty. params: resolved, with the
// chosen denoiser, which must outlive the filters.
std::vector<PictureFilters> filtersFor(const RenderParams& params, const ChosenDenoiser& chosen);

// The filters of a picture that is watched while it refines: while the camera moves, the one that takes the least time.
class LiveFilters {
  public:
    // cancel: raised when the present picture will not be shown. It and the denoiser must outlive the filters.
    LiveFilters(const ChosenDenoiser& denoiser, const CancelToken& cancel);
    void apply(LayeredPicture& picture, bool moving) const;
    // Estimates the error of the picture at rest. picture: unfiltered, with half buffers.
    DenoisedError errorOf(const LayeredPicture& picture) const;

  private:
    std::unique_ptr<const PictureFilter> moving_, still_;  // null: pictures stay as they are
};

}  // namespace drc
