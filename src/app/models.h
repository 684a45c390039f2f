// Where the shipped weights are.
#pragma once
#include <string>

namespace drc {

// Path of the default network: what `weights` names if it is not empty, else the environment's DRC_WEIGHTS, else
// models/ beside the program, above it, or in share/drc. Throws Error that lists what was tried.
std::string findWeights(const std::string& weights);

}  // namespace drc
