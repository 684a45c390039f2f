// The data of bench_result.h as JSON: one file for each run while a comparison is going on, and all of it at the end.
#pragma once
#include <optional>
#include <string>

#include "bench/bench_result.h"

namespace drc {

// Values that were not measured are null.
std::string toJson(const BenchReport& report);

// A run, with the key of what made it: the command line and the states of the program and of the scene's file, so that
// a later comparison knows whether the run is still valid.
std::string toJson(const BenchRun& run, const std::string& key);
// None if the text is damaged or has another key.
std::optional<BenchRun> runFromJson(const std::string& text, const std::string& key);

}  // namespace drc
