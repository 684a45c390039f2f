#include "base/stream_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <limits.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

#include "base/error.h"
#include "base/interrupt.h"
#include "base/log.h"

namespace drc {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPause(50);  // between checks for an interrupt

[[noreturn]] void fail(int errorNumber) { throw Error(std::strerror(errorNumber)); }

// Patience with the other side of a pipe: unlimited before an interrupt, one second after it.
class Patience {
  public:
    bool over() {
        if (!interruptToken().cancelled()) return false;
        if (!since_) since_ = Clock::now();
        return Clock::now() - *since_ > std::chrono::seconds(1);
    }

  private:
    std::optional<Clock::time_point> since_;
};

int openPipe(const std::string& path) {
    Patience patience;
    for (auto wait = kPause * 0;; wait += kPause) {
        // Without O_NONBLOCK, opening a pipe without a reader would block, and the call would restart after signals.
        const int fd = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
        if (fd >= 0) return fd;
        if (errno == EINTR) continue;
        if (errno != ENXIO) fail(errno);
        if (patience.over()) throw Error("nobody reads from this pipe");
        if (wait == std::chrono::seconds(1)) logInfo(path + ": waiting for somebody to read from this pipe");
        std::this_thread::sleep_for(kPause);
    }
}

}  // namespace

int ownDescriptor(const std::string& path) {
    const std::filesystem::path p(path);
    const std::string name = p.filename().string();
    const auto digit = [](unsigned char c) { return std::isdigit(c) != 0; };
    if (name.empty() || name.size() > 9 || !std::all_of(name.begin(), name.end(), digit)) return -1;
    std::error_code ec;
    const auto folder = std::filesystem::canonical(p.has_parent_path() ? p.parent_path() : ".", ec);
    if (ec || folder != std::filesystem::canonical("/proc/self/fd", ec) || ec) return -1;
    return std::stoi(name);
}

int openStream(const std::string& path) {
    // The descriptor is duplicated, because opening /dev/stdout by name would start at the beginning of a file that the
    // shell appends to, and would fail for a socket.
    if (const int own = ownDescriptor(path); own >= 0) {
        const int mode = ::fcntl(own, F_GETFL);
        if (mode < 0) fail(errno);
        if ((mode & O_ACCMODE) == O_RDONLY) throw Error("it is open for reading only");
        const int copy = ::fcntl(own, F_DUPFD_CLOEXEC, 0);
        if (copy < 0) fail(errno);
        return copy;
    }
    struct stat status = {};
    if (::stat(path.c_str(), &status) != 0) fail(errno);
    if (S_ISFIFO(status.st_mode)) return openPipe(path);
    const int fd = ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
    if (fd < 0) fail(errno);
    return fd;
}

void writeStream(int descriptor, std::string_view data) {
    Patience patience;
    while (!data.empty()) {
        pollfd ready = {descriptor, POLLOUT, 0};
        const int found = ::poll(&ready, 1, int(kPause.count()));
        if (found < 0 && errno != EINTR) fail(errno);
        if (found <= 0) {
            if (patience.over()) throw Error("nobody goes on reading");
            continue;
        }
        // A ready pipe accepts PIPE_BUF bytes at once. Writing more would block until the reader reads the rest.
        const ssize_t n = ::write(descriptor, data.data(), std::min<size_t>(data.size(), PIPE_BUF));
        if (n < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (n < 0) fail(errno);
        if (n == 0) fail(ENOSPC);
        data.remove_prefix(static_cast<size_t>(n));
        patience = {};
    }
}

}  // namespace drc
