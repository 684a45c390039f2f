#include "base/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>

namespace drc {
namespace {

// Not a local static: its initialisation guard must not run inside the handler.
CancelToken token;

// Only calls that are safe in a signal handler.
void handle(int signal) {
    if (token.cancelled()) _exit(128 + signal);
    token.cancel();
    const int savedErrno = errno;
    static constexpr char kMessage[] = "\ndrc: interrupted, finishing; interrupt again to stop at once\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kMessage, sizeof(kMessage) - 1);
    errno = savedErrno;
}

}  // namespace

CancelToken& interruptToken() { return token; }

void installInterruptHandler() {
    struct sigaction action = {};
    action.sa_handler = handle;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    // One signal at a time, so that the message and the flag cannot interleave with the other signal's.
    sigaddset(&action.sa_mask, SIGINT);
    sigaddset(&action.sa_mask, SIGTERM);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

}  // namespace drc
