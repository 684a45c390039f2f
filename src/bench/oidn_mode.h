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
    // 1280x720 on two cores of Zen 3: high 13.9 s, balanced-raw 2.0 s, fast-raw 1.1 s. high-raw is the same filter as
    // balanced-raw there, bit for bit.
    double microseconds;
};

// From the most expensive to the cheapest.
std::span<const OidnMode> oidnModes();
// The mode of that name; null if there is none.
const OidnMode* findOidnMode(const std::string& name);

// The mode of "path+oidn" for a budget in seconds, a number of pixels and of threads: the first of the measured modes
// that takes at most a quarter of the budget, else the cheapest of them. By errors at 1280x720 on two cores, with 10
// and 30 s, in three interiors (docs/measuring.md), balanced-raw is best or equal to the best in all but one of the
// six; what high costs is worth more as samples there. That high is best from 60 s on has not been measured.
const OidnMode& bestOidnMode(double seconds, double pixels, int threads);

}  // namespace drc
