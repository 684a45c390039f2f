// Where the shipped weights are.
#pragma once
#include <string>

namespace drc {

// Of the shipped networks, what renders use by default: the one that predicts maps best (models/drc.md).
inline constexpr const char* kDefaultNetwork = "drc";

// The path of the weights that are meant. `weights`: a file, or the name of a shipped network; if empty, the
// environment's DRC_WEIGHTS takes its place, else the default network. Shipped networks lie in models/ beside the
// program, above it, or in share/drc. Throws Error that lists what was tried, and which networks there are.
std::string findWeights(const std::string& weights);

}  // namespace drc
