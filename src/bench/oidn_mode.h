// How path tracing with Open Image Denoise is given its best: the modes of the denoiser, and which of them a budget
// pays for.
#pragma once
#include <span>
#include <string>

namespace drc {

struct OidnMode {
    const char* name;     // as in "path+oidn:balanced-raw"; raw: albedo and normal are not filtered first
    const char* quality;  // of drc render --oidn-quality
    bool prefilter;       // of drc render --oidn-prefilter
    // That one core takes for a pixel, in the whole picture; NaN: not measured. Measured with version 2.5 at 1280x720
    // on two cores: high 9 s, balanced-raw 1.4 s. high-raw is the same filter as balanced-raw there, bit by bit.
    double microseconds;
};

// From the most expensive to the cheapest.
std::span<const OidnMode> oidnModes();
// Null if there is none of that name.
const OidnMode* findOidnMode(const std::string& name);

// The mode of "path+oidn" for a budget in seconds, a size in pixels and so many threads: the first of the measured
// modes that takes no more than a fifth of the budget, else the cheapest of them. What denoising takes is lost for
// samples, and the error of a denoised path-traced picture falls more slowly than with their number, so that a fifth of
// the time costs less than a fifth of the error; what the expensive mode gains has to be more than that. The share is a
// choice, to be replaced by a table of errors per budget when these are measured.
const OidnMode& bestOidnMode(double seconds, double pixels, int threads);

}  // namespace drc
