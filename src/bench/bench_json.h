// bench_result.h as JSON: one file a run while a comparison goes on, and all of it when it is done.
#pragma once
#include <optional>
#include <string>

#include "bench/bench_result.h"

namespace drc {

// What is not measured is null.
std::string toJson(const BenchReport& report);

// A run with what made it. `key` tells whether it is still what would be measured today: the command line and the
// states of the program and of the scene's file.
std::string toJson(const BenchRun& run, const std::string& key);
// Nothing if the text is damaged or has another key.
std::optional<BenchRun> runFromJson(const std::string& text, const std::string& key);

}  // namespace drc
