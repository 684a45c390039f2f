// A way to make a picture that `drc bench` compares: one of ours, or another program by its adapter.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/adapter.h"
#include "bench/oidn_mode.h"

namespace drc {

// What one run of a method is to do.
struct BenchJob {
    std::string scene, output, timing;
    int width = 0, height = 0, threads = 0, seed = 0;
    Budget budget;
};

// What all of our own methods have in common.
struct OwnProgram {
    std::string path;         // of drc
    int directSpp = 16;       // samples a pixel of direct light where the budget is tasks
    std::string oidnLibrary;  // empty: where the system finds it
};

class BenchMethod {
  public:
    // By its name: INTEGRATOR (path, bdpt, direct, drc), drc:MAP-DENOISER (none, gaussian, oracle), drc:WEIGHTS (a
    // network's name, or a file), the name of an adapter; each with +DENOISER (off, surface, oidn, oidn-direct; an
    // adapter's own). Ours take oidn and oidn-direct with a mode of oidn_mode.h, as path+oidn:balanced-raw; without one
    // they take the best for the budget. Or NAME=OPTIONS, the options being those of `drc render`, divided at blanks.
    // findAdapter: what there is of a name. Throws Error that says what would be right.
    BenchMethod(const std::string& text, const std::function<std::optional<Adapter>(const std::string&)>& findAdapter);

    const std::string& name() const { return name_; }
    const std::optional<Adapter>& adapter() const { return adapter_; }
    // Ours keep seconds, and tasks if they have maps, else spp.
    bool keeps(BudgetUnit unit) const;
    // Of Open Image Denoise for a job of ours that asks for it by name; else null.
    const OidnMode* oidnMode(const BenchJob& job) const;
    // For a budget that it keeps.
    std::vector<std::string> command(const BenchJob& job, const OwnProgram& own) const;

  private:
    std::string name_, denoiser_;
    const OidnMode* oidnMode_ = nullptr;  // the one that the name asks for
    std::vector<std::string> options_;    // of drc render
    bool hasMaps_ = false;
    std::optional<Adapter> adapter_;
};

}  // namespace drc
