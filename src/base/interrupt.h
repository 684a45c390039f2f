// Interrupts: the first Ctrl-C asks the program to finish and save what it has, the second ends it at once. The signals
// of batch systems and of a closed terminal count as the first.
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
// at once, with the exit code 128 + its number: nothing has been written, and old files stay as they are.
void setSomethingToSave(bool something);

// From now on, the first of these signals raises interruptToken() and says so on standard error, if there is something
// to save. A further SIGINT ends the process with 130. A further SIGTERM or SIGHUP does nothing, because one request
// may send both twice: `timeout` signals its child and then the whole group, and both the shell and the system report a
// closed terminal. A signal that was ignored when the program started (nohup, background jobs of scripts) stays
// ignored.
void installInterruptHandler();

}  // namespace drc
