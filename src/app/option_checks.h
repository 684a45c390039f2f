// Checks of numbers on the command line: each says in a few words what would be right.
#pragma once
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace drc {

// A whole number from `least` on.
inline CLI::Validator wholeNumberFrom(long least) {
    return {[least](std::string& text) -> std::string {
                long value = 0;
                if (CLI::detail::lexical_cast(text, value) && value >= least && value <= 2147483647) return "";
                return fmt::format("{} is no whole number from {} on", text, least);
            },
            fmt::format("INT >= {}", least)};
}

// A finite number above `bound`, or from it on.
inline CLI::Validator numberAbove(double bound, bool inclusive = false) {
    return {[=](std::string& text) -> std::string {
                double value = 0;
                if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) &&
                    (value > bound || (inclusive && value == bound)))
                    return "";
                return fmt::format("{} is no number {} {:g}", text, inclusive ? "from" : "above", bound) +
                       (inclusive ? " on" : "");
            },
            fmt::format("NUMBER {} {:g}", inclusive ? ">=" : ">", bound)};
}
inline CLI::Validator numberFrom(double least) { return numberAbove(least, true); }

}  // namespace drc
