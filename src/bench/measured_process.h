// Runs a program to its end, and says what it took.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/parallel.h"

namespace drc {

struct ProcessUse {
    double seconds = 0;        // wall clock, from before it began to after it had ended
    double cpuSeconds = 0;     // user and system, of it and of the children that it waited for
    double peakMegabytes = 0;  // largest resident set of any one of these; at least our own at the start. 10^6 bytes
    int exitCode = 0;          // 128 + signal if one ended it
    bool stopped = false;      // ended by us: at the limit, or on `cancel`
    std::string output;        // the end of what it wrote, standard output and error together
};

// argv[0] is looked for in PATH. The program leads a process group of its own; when `limitSeconds` are over or `cancel`
// is raised, the group is asked to end, and killed two seconds later. Reads nothing from the terminal. Throws Error if
// it cannot be started at all.
ProcessUse runMeasured(const std::vector<std::string>& argv, std::optional<double> limitSeconds = {},
                       const CancelToken* cancel = nullptr);

// The last line of a program's output that is not blank, without blanks about it: where programs say what is wrong. If
// the output ends with a line of text and a caret below it, as ours does where a scene's file is wrong, the line before
// these two.
std::string lastLine(const std::string& output);

}  // namespace drc
