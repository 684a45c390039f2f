// Interrupts: the first Ctrl-C asks the program to finish and save its results, the second ends it at once. Signals
// from batch systems or a closed terminal act like the first.
#pragma once
#include "base/parallel.h"

namespace drc {

// Raised by the first SIGINT (Ctrl-C), SIGTERM (batch systems, `kill`) or SIGHUP (a closed terminal) after
// installInterruptHandler().
CancelToken& interruptToken();

// The signal that raised interruptToken(); 0 before. A program that ends because of it uses the shell's exit code, 128
// + interruptSignal().
int interruptSignal();

// Whether there are results to finish and save; true by default. While false, the first signal ends the process at once
// with the exit code 128 + signal: nothing has been written, and old files are unchanged.
void setSomethingToSave(bool something);

// From now on, the first SIGINT, SIGTERM or SIGHUP raises interruptToken() and, if there are results to save, prints a
// message on standard error. A further SIGINT ends the process with exit code 130. A further SIGTERM or SIGHUP does
// nothing, because one request may send it twice: `timeout` signals its child and then the whole group, and both the
// shell and the system report a closed terminal. A signal that was ignored when the program started (nohup, background
// jobs of scripts) stays ignored.
void installInterruptHandler();

}  // namespace drc
