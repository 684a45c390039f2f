#include "report/plot_axis.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace drc {
namespace {

constexpr double kSliver = 0.03;
constexpr double kExact = 1e-9;
constexpr size_t kMostTicks = 8;

// The smallest of 1, 2 and 5 times a power of ten that is at least x.
double roundUp(double x) {
    const double decade = std::pow(10, std::floor(std::log10(x)));
    for (const double factor : {1, 2, 5})
        if (factor * decade >= x * (1 - kExact)) return factor * decade;
    return 10 * decade;
}
// The largest of them that is at most x.
double roundDown(double x) {
    const double decade = std::pow(10, std::floor(std::log10(x) + kExact));
    for (const double factor : {5, 2})
        if (factor * decade <= x * (1 + kExact)) return factor * decade;
    return decade;
}

// The products of `factors` and powers of ten that lie between low and high.
std::vector<double> ticksBetween(double low, double high, std::initializer_list<double> factors) {
    std::vector<double> ticks;
    for (int decade = int(std::floor(std::log10(low) + kExact)); std::pow(10, decade) <= high * (1 + kExact); ++decade)
        for (const double factor : factors) {
            const double tick = factor * std::pow(10, decade);
            if (tick >= low * (1 - kExact) && tick <= high * (1 + kExact)) ticks.push_back(tick);
        }
    return ticks;
}

}  // namespace

double PlotAxis::place(double value) const {
    const auto scale = [&](double v) { return logarithmic ? std::log10(std::max(v, low)) : v; };
    return std::clamp((scale(value) - scale(low)) / (scale(high) - scale(low)), 0.0, 1.0);
}

PlotAxis linearAxis(double low, double high) {
    // The axis begins at zero, also if a sliver of the data lies below it that is not worth a tick.
    if (low > -kSliver * (high - low)) low = std::min(0.0, high);
    if (!(high > low)) high = low + 1;
    const double step = roundUp((high - low) / 5);
    PlotAxis axis{step * std::floor(low / step), step * std::ceil(high / step), false, {}};
    for (int i = 0; axis.low + i * step < axis.high + step / 2; ++i) axis.ticks.push_back(axis.low + i * step);
    return axis;
}

PlotAxis decadeAxis(double low, double high) {
    const int first = int(std::floor(std::log10(low))), last = std::max(first + 1, int(std::ceil(std::log10(high))));
    PlotAxis axis{std::pow(10, first), std::pow(10, last), true, {}};
    const int step = 1 + (last - first) / 7;
    for (int decade = first; decade <= last; decade += step) axis.ticks.push_back(std::pow(10, decade));
    return axis;
}

PlotAxis logarithmicAxis(double low, double high) {
    PlotAxis axis{roundDown(low), roundUp(high), true, {}};
    if (axis.high < axis.low * (1 + kExact)) axis.high = roundUp(1.5 * axis.low);
    axis.ticks = ticksBetween(axis.low, axis.high, {1, 2, 5});
    if (axis.ticks.size() > kMostTicks) axis.ticks = ticksBetween(axis.low, axis.high, {1});
    return axis.ticks.size() > kMostTicks ? decadeAxis(low, high) : axis;
}

std::string tickText(double value) {
    if (std::abs(value) < 1e-12) return "0";
    const int decade = int(std::floor(std::log10(std::abs(value)) + kExact));
    if (decade >= -3 && decade < 5) return fmt::format("{:.4g}", value);
    constexpr const char* kRaised[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                       "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string power = "10";
    for (const char c : std::to_string(decade)) power += c == '-' ? "\u207b" : kRaised[c - '0'];
    const std::string factor = fmt::format("{:.3g}", value / std::pow(10, decade));
    return factor == "1" ? power : factor + "\u00b7" + power;
}

}  // namespace drc
