// Other renderers, as `drc bench` runs them: the contents of an adapter file (integrations/README.md).
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_result.h"

namespace drc {

// The values of the placeholders for one run.
struct AdapterValues {
    std::string scene, output, timing, denoiser;
    int width = 0, height = 0, threads = 0, seed = 0;
    double amount = 0;  // in the budget's unit
};

struct Adapter {
    std::string name, about, install;
    std::string folder;              // of its file, absolute
    std::vector<std::string> check;  // empty: nothing to check
    std::vector<std::string> denoisers;
    std::map<BudgetUnit, std::vector<std::string>> commands;

    bool denoises(const std::string& denoiser) const;
    // The command line for a run; none if the program cannot keep such a budget.
    std::optional<std::vector<std::string>> command(BudgetUnit unit, const AdapterValues& values) const;
};

// path: an adapter file, or a folder that contains adapter.json. Throws Error, naming the file and the key, if it is
// not JSON, or if a key or placeholder is missing, unknown or of a wrong type.
Adapter readAdapter(const std::string& path);

}  // namespace drc
