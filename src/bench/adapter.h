// Renderers other than ours, as `drc bench` runs them: what an adapter file (integrations/README.md) says of one.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_result.h"

namespace drc {

// One run's values of the placeholders.
struct AdapterValues {
    std::string scene, output, timing, denoiser;
    int width = 0, height = 0, threads = 0, seed = 0;
    double amount = 0;  // of the budget's unit
};

struct Adapter {
    std::string name, about, install;
    std::string folder;              // of its file, absolute
    std::vector<std::string> check;  // empty: nothing to check
    std::vector<std::string> denoisers;
    std::map<BudgetUnit, std::vector<std::string>> commands;

    bool denoises(const std::string& denoiser) const;
    // The command line for a run; nothing if the program cannot keep such a budget.
    std::optional<std::vector<std::string>> command(BudgetUnit unit, const AdapterValues& values) const;
};

// path: an adapter file, or a folder with adapter.json in it. Throws Error, naming the file and the key, on what is no
// JSON, is missing, is of a wrong type or unknown: keys and placeholders.
Adapter readAdapter(const std::string& path);

}  // namespace drc
