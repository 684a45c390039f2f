// The laboratory is the part of drc that is written in Python (lab/): comparisons of renderers, and pages. Here it is
// found and started.
#pragma once
#include <string>
#include <vector>

namespace drc {

// Replaces this process by a command of the laboratory, which takes over its terminal, its signals and its exit status.
// Throws Error, in one line, if there is no Python or no laboratory. Modules that Python lacks are reported by the
// laboratory itself.
[[noreturn]] void becomeLaboratory(const std::string& command, const std::vector<std::string>& arguments);

// Runs a command of the laboratory to its end, and returns its exit status; if that is not 0, it has said why. "check"
// does nothing but find out whether all modules are there. Throws Error as becomeLaboratory does.
int runLaboratory(const std::string& command, const std::vector<std::string>& arguments = {});

}  // namespace drc
