#include "base/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>

namespace drc {
namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

// Globals, because the initialisation guards of local statics must not run inside the signal handler.
CancelToken token;
std::atomic<int> firstSignal{0};
std::atomic<bool> somethingToSave{true};
static_assert(std::atomic<int>::is_always_lock_free, "the signal handler writes it");

// Calls only functions that are safe in a signal handler.
void handle(int signal) {
    if (token.cancelled()) {
        if (signal == SIGINT) _exit(128 + SIGINT);
        return;
    }
    if (!somethingToSave) {
        static constexpr std::string_view kMessage = "\ndrc: interrupted before there was a picture\n";
        [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kMessage.data(), kMessage.size());
        _exit(128 + signal);
    }
    firstSignal = signal;  // before the token: a thread that sees the token raised can read the signal
    token.cancel();
    const int savedErrno = errno;
    const std::string_view message = signal == SIGINT
                                         ? "\ndrc: interrupted, finishing; interrupt again to stop at once\n"
                                         : "\ndrc: asked to end, finishing\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message.data(), message.size());
    errno = savedErrno;
}

}  // namespace

CancelToken& interruptToken() { return token; }

void setSomethingToSave(bool something) { somethingToSave = something; }

int interruptSignal() { return firstSignal; }

void installInterruptHandler() {
    struct sigaction action = {};
    action.sa_handler = handle;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    // Blocks the other signals in the handler, so that its message and flag cannot interleave with theirs.
    for (const int signal : kSignals) sigaddset(&action.sa_mask, signal);
    for (const int signal : kSignals) {
        struct sigaction before = {};
        if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
        sigaction(signal, &action, nullptr);
    }
}

}  // namespace drc
