// Checks of numbers on the command line, with messages that say what would be right.
#pragma once
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace drc {

// A whole number that is at least `least`.
inline CLI::Validator wholeNumberFrom(long least) {
    return {[least](std::string& text) -> std::string {
                long value = 0;
                if (CLI::detail::lexical_cast(text, value) && value >= least && value <= 2147483647) return "";
                return fmt::format("{} is not a whole number of at least {}", text, least);
            },
            fmt::format("INT >= {}", least)};
}

// A finite number above `bound`, or with `inclusive` at least `bound`.
inline CLI::Validator numberAbove(double bound, bool inclusive = false) {
    return {[=](std::string& text) -> std::string {
                double value = 0;
                if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) &&
                    (value > bound || (inclusive && value == bound)))
                    return "";
                return fmt::format("{} is not a number {} {:g}", text, inclusive ? "of at least" : "above", bound);
            },
            fmt::format("NUMBER {} {:g}", inclusive ? ">=" : ">", bound)};
}
inline CLI::Validator numberFrom(double least) { return numberAbove(least, true); }

// A number in [low, high].
inline CLI::Validator numberIn(double low, double high) {
    return {[=](std::string& text) -> std::string {
                double value = 0;
                if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return "";
                return fmt::format("{} is not a number from {:g} to {:g}", text, low, high);
            },
            fmt::format("NUMBER in [{:g}, {:g}]", low, high)};
}

}  // namespace drc
