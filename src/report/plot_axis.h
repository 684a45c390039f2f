// The axis of a plot: the position of values on it, and its ticks.
#pragma once
#include <string>
#include <vector>

namespace drc {

struct PlotAxis {
    double low = 0, high = 1;
    bool logarithmic = false;
    std::vector<double> ticks;  // increasing, from low to high

    // Position of a value: 0 at low, 1 at high. Values outside are clamped.
    double place(double value) const;
};

// A linear axis with round ends around the values from low to high. It begins at zero if no value is far below zero.
PlotAxis linearAxis(double low, double high);

// A logarithmic axis for positive values, from one power of ten to another.
PlotAxis decadeAxis(double low, double high);

// A logarithmic axis for positive values with tighter ends: 1, 2 or 5 times a power of ten. Ticks are at the same
// numbers, or at powers of ten only if those would be too many.
PlotAxis logarithmicAxis(double low, double high);

// The label of a tick: "0", "0.02", "2000", "2·10⁻⁵".
std::string tickText(double value);

}  // namespace drc
