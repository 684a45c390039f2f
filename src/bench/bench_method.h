// A method that `drc bench` compares: one of our own, or another program with an adapter.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/adapter.h"
#include "bench/oidn_mode.h"

namespace drc {

// The task of one run of a method.
struct BenchJob {
    std::string scene, output, timing;
    int width = 0, height = 0, threads = 0, seed = 0;
    Budget budget;
};

// Settings that all of our own methods share.
struct OwnProgram {
    std::string path;         // of drc
    int directSpp = 16;       // samples a pixel of direct light if the budget is in tasks
    std::string oidnLibrary;  // empty: the one that the system finds
};

class BenchMethod {
  public:
    // Makes the method that `text` names: INTEGRATOR (one of integratorNames()), drc-maps:MAP-DENOISER (none, gaussian,
    // oracle), drc-maps:WEIGHTS (a network's name, or a file), or the name of an adapter; each with +DENOISER (off,
    // oidn, of drc-maps also surface and oidn-direct; an adapter's own). Without one, drc and drc-maps are denoised as
    // by default, and the others are not. Ours take oidn and oidn-direct with a mode of oidn_mode.h, as
    // path+oidn:balanced-raw; without one they take the best mode for the budget. Or NAME=OPTIONS, with options of
    // `drc render` separated by blanks. findAdapter: returns the adapter of a name, if there is one. Throws Error that
    // says what would be right.
    BenchMethod(const std::string& text, const std::function<std::optional<Adapter>(const std::string&)>& findAdapter);

    const std::string& name() const { return name_; }
    const std::optional<Adapter>& adapter() const { return adapter_; }
    // Whether the method can keep a budget in this unit. Ours keep seconds, and tasks if they have map passes, else
    // spp.
    bool keeps(BudgetUnit unit) const;
    // The mode of Open Image Denoise for a job of ours that asks for it by name; else null.
    const OidnMode* oidnMode(const BenchJob& job) const;
    // The command line of a job, for a budget that the method keeps.
    std::vector<std::string> command(const BenchJob& job, const OwnProgram& own) const;

  private:
    std::string name_, denoiser_;
    const OidnMode* oidnMode_ = nullptr;  // the mode that the name asks for
    std::vector<std::string> options_;    // of drc render
    bool hasMaps_ = false;
    std::optional<Adapter> adapter_;
};

}  // namespace drc
