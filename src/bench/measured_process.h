// Runs a program to its end and measures it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/parallel.h"

namespace drc {

struct ProcessUse {
    double seconds = 0;        // wall clock, from before the start to after the end
    double cpuSeconds = 0;     // user and system, of the program and of children that it waited for
    double peakMegabytes = 0;  // largest resident set of any of them, in 10^6 bytes; not below our own at the start
    int exitCode = 0;          // 128 + signal if a signal ended it
    bool stopped = false;      // we ended it, at the limit or on `cancel`
    std::string output;        // the end of its standard output and error together
};

// argv[0] is looked up in PATH. The program leads a process group of its own; after `limitSeconds`, or when `cancel` is
// raised, the group is asked to end, and killed two seconds later. The program reads nothing from the terminal. Throws
// Error if it cannot be started at all.
ProcessUse runMeasured(const std::vector<std::string>& argv, std::optional<double> limitSeconds = {},
                       const CancelToken* cancel = nullptr);

// The last line of a program's output that is not blank, trimmed: where programs usually report errors. If the output
// ends with a line of a scene's file and a caret below it, as our own errors do, the line before these two.
std::string lastLine(const std::string& output);

}  // namespace drc
