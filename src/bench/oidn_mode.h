// The modes of Open Image Denoise, and which of them is best for a budget, so that path tracing with it is a fair
// opponent.
#pragma once
#include <span>
#include <string>

namespace drc {

struct OidnMode {
    const char* name;     // as in "path+oidn:balanced-raw"; raw: albedo and normal are not filtered first
    const char* quality;  // of drc render --oidn-quality
    bool prefilter;       // of drc render --oidn-prefilter
    // The time that one core takes for a pixel of the whole picture; NaN: not measured. Measured with version 2.5 at
    // 1280x720 on two cores: high 9 s, balanced-raw 1.4 s. high-raw is the same filter as balanced-raw there, bit for
    // bit.
    double microseconds;
};

// From the most expensive to the cheapest.
std::span<const OidnMode> oidnModes();
// The mode of that name; null if there is none.
const OidnMode* findOidnMode(const std::string& name);

// The mode of "path+oidn" for a budget in seconds, a number of pixels and of threads: the first of the measured modes
// that takes at most a fifth of the budget, else the cheapest of them. Time for denoising is lost for samples, but the
// error of a denoised path-traced picture falls more slowly than their number grows, so that a fifth of the time costs
// less than a fifth of the error; an expensive mode has to gain more than that. The share is a choice, to be replaced
// by a table of errors for each budget when these are measured.
const OidnMode& bestOidnMode(double seconds, double pixels, int threads);

}  // namespace drc
