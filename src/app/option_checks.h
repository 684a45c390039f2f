// Checks of values on the command line, with messages that say what would be right.
#pragma once
#include <CLI/CLI.hpp>

namespace drc {

// A whole number in [low, high].
CLI::Validator wholeNumberIn(long low, long high);
// A whole number that is at least `least`.
CLI::Validator wholeNumberFrom(long least);
// A seed: an unsigned whole number of 64 bits.
CLI::Validator seedNumber();
// A finite number. Has no description of its own, so that the option can name its values.
CLI::Validator finiteNumber();
// A finite number above `bound`, or with `inclusive` at least `bound`.
CLI::Validator numberAbove(double bound, bool inclusive = false);
inline CLI::Validator numberFrom(double least) { return numberAbove(least, true); }
// A number in [low, high].
CLI::Validator numberIn(double low, double high);
// A number in (low, high).
CLI::Validator numberBetween(double low, double high);
// A budget in seconds: above 0, and below what clocks can add to the present time.
CLI::Validator secondsOfWork();

// Adds --nthreads. More threads than a machine has only wait for each other, and each takes memory, so their number is
// bounded.
CLI::Option* addThreadsOption(CLI::App& command, int& threads);
// Adds --seed.
CLI::Option* addSeedOption(CLI::App& command, uint64_t& seed, const std::string& description);

}  // namespace drc
