// Chooses the denoiser of a picture, and the filters that finish it.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "integrators/render_params.h"
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

}  // namespace drc
