// Where the shipped weights are.
#pragma once
#include <string>

namespace drc {

// Shipped networks. With a given number of maps the first makes the better picture; in a given time the second, as it
// leaves time for more maps (benchmarks/equal_time.py).
inline constexpr const char* kBestNetwork = "drc";
inline constexpr const char* kFastNetwork = "drc-fast";

// The path of the weights that are meant. `weights`: a file, or the name of a shipped network; if empty, the
// environment's DRC_WEIGHTS takes its place, else the shipped network `otherwise`. Shipped networks lie in models/
// beside the program, above it, or in share/drc. Throws Error that lists what was tried, and which networks there are.
std::string findWeights(const std::string& weights, const std::string& otherwise = kBestNetwork);

}  // namespace drc
