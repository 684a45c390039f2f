// Finds the weights of networks.
#pragma once
#include <string>

namespace drc {

// The shipped network that renders use by default: the one that predicts maps best (models/drc.md).
inline constexpr const char* kDefaultNetwork = "drc";

// The path of a network's weights. `weights`: a file, or the name of a shipped network; if empty, the environment
// variable DRC_WEIGHTS replaces it, else the default network. Shipped networks lie in models/ beside the program, above
// it, or in share/drc. Throws Error, which lists the places that were tried or the networks that exist.
std::string findWeights(const std::string& weights);

}  // namespace drc
