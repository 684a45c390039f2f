#include "app/option_checks.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <thread>

namespace drc {
namespace {

// The largest value of the options that are whole numbers without a bound of their own.
constexpr long kMostInt = std::numeric_limits<int>::max();
// A year.
constexpr double kMostSeconds = 366.0 * 24 * 3600;

bool isNumber(const std::string& text, double& value) {
    return CLI::detail::lexical_cast(text, value) && std::isfinite(value);
}

// More threads than this only wait for each other; the bound is generous because files of settings travel between
// machines.
long mostThreads() { return std::max(256L, 2 * long(std::thread::hardware_concurrency())); }

}  // namespace

CLI::Validator wholeNumberIn(long low, long high) {
    return {[=](std::string& text) -> std::string {
                long value = 0;
                if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return "";
                return fmt::format("{} is not a whole number from {} to {}", text, low, high);
            },
            fmt::format("INT in [{}, {}]", low, high)};
}

CLI::Validator wholeNumberFrom(long least) {
    return {[least](std::string& text) -> std::string {
                long value = 0;
                const bool isInt = CLI::detail::lexical_cast(text, value);
                if (isInt && value > kMostInt) return fmt::format("{} is too large: at most {}", text, kMostInt);
                if (isInt && value >= least) return "";
                return fmt::format("{} is not a whole number of at least {}", text, least);
            },
            fmt::format("INT >= {}", least)};
}

CLI::Validator seedNumber() {
    return {[](std::string& text) -> std::string {
                uint64_t value = 0;
                const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
                if (failure == std::errc() && end == text.data() + text.size()) return "";
                return fmt::format("{} is not a whole number from 0 to 2^64 - 1", text);
            },
            "INT >= 0"};
}

CLI::Validator finiteNumber() {
    return {[](std::string& text) -> std::string {
                double value = 0;
                return isNumber(text, value) ? "" : text + " is not a number";
            },
            ""};
}

CLI::Validator numberAbove(double bound, bool inclusive) {
    return {[=](std::string& text) -> std::string {
                double value = 0;
                if (isNumber(text, value) && (value > bound || (inclusive && value == bound))) return "";
                return fmt::format("{} is not a number {} {:g}", text, inclusive ? "of at least" : "above", bound);
            },
            fmt::format("NUMBER {} {:g}", inclusive ? ">=" : ">", bound)};
}

CLI::Validator numberIn(double low, double high) {
    return {[=](std::string& text) -> std::string {
                double value = 0;
                if (isNumber(text, value) && value >= low && value <= high) return "";
                return fmt::format("{} is not a number from {:g} to {:g}", text, low, high);
            },
            fmt::format("NUMBER in [{:g}, {:g}]", low, high)};
}

CLI::Validator numberBetween(double low, double high) {
    return {[=](std::string& text) -> std::string {
                double value = 0;
                if (isNumber(text, value) && value > low && value < high) return "";
                return fmt::format("{} is not a number between {:g} and {:g}", text, low, high);
            },
            ""};
}

CLI::Validator secondsOfWork() {
    return {[](std::string& text) -> std::string {
                double value = 0;
                if (!isNumber(text, value) || value <= 0) return text + " is not a number of seconds above 0";
                return value <= kMostSeconds ? "" : text + " is too long: at most a year, in seconds";
            },
            "SECONDS > 0"};
}

CLI::Option* addThreadsOption(CLI::App& command, int& threads) {
    return command
        .add_option("--nthreads", threads,
                    "Number of threads; 0: one for each core that the affinity mask and the control group give")
        ->capture_default_str()
        ->check(wholeNumberIn(0, mostThreads()));
}

CLI::Option* addSeedOption(CLI::App& command, uint64_t& seed, const std::string& description) {
    return command.add_option("--seed", seed, description)->capture_default_str()->check(seedNumber());
}

}  // namespace drc
