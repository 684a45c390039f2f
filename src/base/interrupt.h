// Ctrl-C: the first asks the program to finish what it has and save it, the second ends it at once.
#pragma once
#include "base/parallel.h"

namespace drc {

// Raised by the first SIGINT (or SIGTERM, which batch systems send) after installInterruptHandler().
CancelToken& interruptToken();

// From now on, the first SIGINT or SIGTERM raises interruptToken() and says so on standard error; a second one ends the
// process with the shell's exit code for it, 128 + signal: 130 for Ctrl-C.
void installInterruptHandler();

}  // namespace drc
