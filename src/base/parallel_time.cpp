#include "base/parallel_time.h"

#include <unistd.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <mutex>
#include <sstream>
#include <string>

namespace drc {
namespace {

using Clock = std::chrono::steady_clock;

struct Sections {
    std::mutex mutex;
    int alive = 0;
    Clock::time_point since;  // when alive became 1
    Clock::duration before{};
};

Sections& sections() {
    static Sections instance;
    return instance;
}

}  // namespace

ParallelSection::ParallelSection() {
    Sections& all = sections();
    const std::lock_guard lock(all.mutex);
    if (all.alive++ == 0) all.since = Clock::now();
}

ParallelSection::~ParallelSection() {
    Sections& all = sections();
    const std::lock_guard lock(all.mutex);
    if (--all.alive == 0) all.before += Clock::now() - all.since;
}

double parallelSeconds() {
    Sections& all = sections();
    const std::lock_guard lock(all.mutex);
    const Clock::duration now = all.alive > 0 ? Clock::now() - all.since : Clock::duration{};
    return std::chrono::duration<double>(all.before + now).count();
}

// The start is field 22 of /proc/self/stat, in clock ticks since the system booted (man 5 proc).
double processSeconds() {
    std::ifstream file("/proc/self/stat");
    std::string line;
    std::getline(file, line);
    // The second field, the program's name, may have spaces and brackets.
    const size_t nameEnd = line.rfind(')');
    if (nameEnd == std::string::npos) return 0;
    std::istringstream fields(line.substr(nameEnd + 1));
    constexpr int kFirst = 3, kStart = 22;
    std::string skipped;
    for (int field = kFirst; field < kStart; ++field) fields >> skipped;
    double ticks = 0;
    timespec now{};
    if (!(fields >> ticks) || clock_gettime(CLOCK_BOOTTIME, &now) != 0) return 0;
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec) - ticks / double(sysconf(_SC_CLK_TCK));
}

}  // namespace drc
