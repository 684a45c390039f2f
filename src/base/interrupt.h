// Ctrl-C: the first asks the program to finish what it has and save it, the second ends it at once. So do the signals
// that batch systems and a closed terminal send.
#pragma once
#include "base/parallel.h"

namespace drc {

// Raised by the first SIGINT (Ctrl-C), SIGTERM (batch systems, `kill`) or SIGHUP (a closed terminal) after
// installInterruptHandler().
CancelToken& interruptToken();

// The signal that raised interruptToken(); 0 before. A program that ends because of it exits with the shell's code,
// 128 + interruptSignal().
int interruptSignal();

// Whether there is anything to finish and save; true by default. While there is not, the first signal ends the process
// at once, with 128 + its number: nothing has been written, and old files stay as they are.
void setSomethingToSave(bool something);

// From now on, the first of the signals above raises interruptToken() and says so on standard error, if there is
// something to save. SIGINT after that ends the process with 130. Another SIGTERM or SIGHUP does nothing, because both may come twice for one request:
// `timeout` signals its child and then the whole group, and a closed terminal is told by the shell and by the system. A
// signal that was ignored when the program started (nohup, background jobs of scripts) stays ignored.
void installInterruptHandler();

}  // namespace drc
