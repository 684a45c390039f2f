// Where the shipped weights are.
#pragma once
#include <string>

namespace drc {

// The path of the weights that are meant. `weights`: a file, or the name of a shipped network ("drc-fast"); if empty,
// the environment's DRC_WEIGHTS takes its place, else the default network. Shipped networks lie in models/ beside the
// program, above it, or in share/drc. Throws Error that lists what was tried, and which networks there are.
std::string findWeights(const std::string& weights);

}  // namespace drc
