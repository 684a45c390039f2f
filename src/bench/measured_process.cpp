#include "bench/measured_process.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "base/error.h"

namespace drc {
namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t kKeptOutput = 1 << 16;
constexpr double kMercySeconds = 2;  // between asking a program to end and killing it

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double seconds(const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); }

[[noreturn]] void cannotStart(const std::string& program, int errorNumber) {
    throw Error(fmt::format("{}: cannot be started: {}", program, std::strerror(errorNumber)));
}

struct Pipe {
    int ends[2] = {-1, -1};
    Pipe() {
        if (pipe2(ends, O_CLOEXEC) != 0) throw Error(fmt::format("no pipe: {}", std::strerror(errno)));
    }
    ~Pipe() {
        closeEnd(0);
        closeEnd(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void closeEnd(int i) {
        if (ends[i] >= 0) close(ends[i]);
        ends[i] = -1;
    }
};

// Not posix_spawn: its child begins in our own memory, and the system then counts our peak as the child's.
pid_t start(const std::vector<std::string>& argv, int output) {
    std::vector<char*> arguments;
    for (const std::string& argument : argv) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    Pipe failure;
    const pid_t pid = fork();
    if (pid < 0) cannotStart(argv[0], errno);
    if (pid == 0) {
        // Other threads may have held any lock: from here only what signal handlers may do.
        setpgid(0, 0);
        const int nothing = open("/dev/null", O_RDONLY);
        if (nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
            dup2(output, STDERR_FILENO) >= 0)
            execvp(arguments[0], arguments.data());
        const int reason = errno;
        [[maybe_unused]] const ssize_t written = write(failure.ends[1], &reason, sizeof reason);
        _exit(127);
    }
    setpgid(pid, pid);  // here as well: whoever comes first
    failure.closeEnd(1);
    int reason = 0;
    ssize_t got = 0;
    while ((got = read(failure.ends[0], &reason, sizeof reason)) < 0 && errno == EINTR) {
    }
    if (got == sizeof reason) {
        waitpid(pid, nullptr, 0);
        cannotStart(argv[0], reason);
    }
    return pid;
}

// Reads all that the pipe holds now, and keeps the end of it. False once all writers have closed it.
bool drain(int fd, std::string& output) {
    char buffer[4096];
    for (;;) {
        const ssize_t n = read(fd, buffer, sizeof buffer);
        if (n == 0) return false;
        if (n < 0) return errno == EAGAIN || errno == EINTR;
        output.append(buffer, size_t(n));
        if (output.size() > 2 * kKeptOutput) output.erase(0, output.size() - kKeptOutput);
    }
}

}  // namespace

ProcessUse runMeasured(const std::vector<std::string>& argv, std::optional<double> limitSeconds,
                       const CancelToken* cancel) {
    if (argv.empty()) throw Error("a command must have at least a program's name");
    Pipe pipe;
    const auto begin = Clock::now();
    const pid_t pid = start(argv, pipe.ends[1]);
    pipe.closeEnd(1);
    fcntl(pipe.ends[0], F_SETFL, O_NONBLOCK);

    ProcessUse use;
    rusage usage{};
    int status = 0;
    bool open = true;
    double askedToEnd = -1;
    for (;;) {
        const pid_t ended = wait4(pid, &status, WNOHANG, &usage);
        if (ended == pid) break;
        const double now = secondsSince(begin);
        if (askedToEnd < 0 && ((limitSeconds && now > *limitSeconds) || (cancel && cancel->cancelled()))) {
            kill(-pid, SIGTERM);
            use.stopped = true;
            askedToEnd = now;
        } else if (askedToEnd >= 0 && now > askedToEnd + kMercySeconds) {
            kill(-pid, SIGKILL);
        }
        // The pipe's end tells at once that the program ended; a closed pipe would make us spin.
        if (open) {
            pollfd wait{pipe.ends[0], POLLIN, 0};
            poll(&wait, 1, 10);
            open = drain(pipe.ends[0], use.output);
        } else {
            poll(nullptr, 0, 2);
        }
    }
    use.seconds = secondsSince(begin);
    if (use.stopped) kill(-pid, SIGKILL);  // what it may have left behind
    drain(pipe.ends[0], use.output);
    if (use.output.size() > kKeptOutput) use.output.erase(0, use.output.size() - kKeptOutput);
    use.cpuSeconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    use.peakMegabytes = double(usage.ru_maxrss) * 1024e-6;
    use.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return use;
}

std::string lastLine(const std::string& output) {
    constexpr const char* kBlank = " \t\r\n";
    std::string lines[3];  // the last comes first
    size_t end = output.find_last_not_of(kBlank);
    for (std::string& line : lines) {
        if (end == std::string::npos) break;
        const size_t before = output.find_last_of("\r\n", end);
        const size_t begin = output.find_first_not_of(kBlank, before == std::string::npos ? 0 : before);
        line = output.substr(begin, end + 1 - begin);
        end = before == std::string::npos ? before : output.find_last_not_of(kBlank, before);
    }
    return lines[0] == "^" && !lines[2].empty() ? lines[2] : lines[0];
}

}  // namespace drc
