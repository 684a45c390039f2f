#include "bench/oidn_mode.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drc {
namespace {

constexpr double kNotMeasuredCost = std::numeric_limits<double>::quiet_NaN();
constexpr double kMostShare = 0.25;

constexpr OidnMode kModes[] = {{"high", "high", true, 30},
                               {"balanced", "balanced", true, kNotMeasuredCost},
                               {"high-raw", "high", false, kNotMeasuredCost},
                               {"balanced-raw", "balanced", false, 4.4},
                               {"fast-raw", "fast", false, 2.5}};

}  // namespace

std::span<const OidnMode> oidnModes() { return kModes; }

const OidnMode* findOidnMode(const std::string& name) {
    const auto found =
        std::find_if(std::begin(kModes), std::end(kModes), [&](const OidnMode& m) { return name == m.name; });
    return found == std::end(kModes) ? nullptr : &*found;
}

const OidnMode& bestOidnMode(double seconds, double pixels, int threads) {
    const OidnMode* cheapest = nullptr;
    for (const OidnMode& mode : kModes) {
        if (std::isnan(mode.microseconds)) continue;
        cheapest = &mode;
        if (mode.microseconds * 1e-6 * pixels / std::max(1, threads) <= kMostShare * seconds) break;
    }
    return *cheapest;
}

}  // namespace drc
