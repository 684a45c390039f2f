// The axis of a plot: where a value stands on it, and where its ticks are.
#pragma once
#include <string>
#include <vector>

namespace drc {

struct PlotAxis {
    double low = 0, high = 1;
    bool logarithmic = false;
    std::vector<double> ticks;  // increasing, from low to high

    // 0 at low, 1 at high; what is outside is clamped.
    double place(double value) const;
};

// With round ends around all values from low to high. It begins at nought if no value is much below it.
PlotAxis linearAxis(double low, double high);

// Of positive values; from a power of ten to another.
PlotAxis decadeAxis(double low, double high);

// Of positive values; its ends fit closer: 1, 2 or 5 times a power of ten. So do the ticks, or, where those are too
// many, powers of ten.
PlotAxis logarithmicAxis(double low, double high);

// "0", "0.02", "2000", "2·10⁻⁵".
std::string tickText(double value);

}  // namespace drc
