#include "base/parallel_time.h"

#include <chrono>
#include <mutex>

namespace drc {
namespace {

using Clock = std::chrono::steady_clock;

struct Sections {
    std::mutex mutex;
    int alive = 0;
    Clock::time_point since;  // start of the current section: when `alive` became 1
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

}  // namespace drc
