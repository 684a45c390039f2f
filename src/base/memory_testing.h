// A limit on this process's memory, for tests of what happens when memory is short.
#pragma once
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

namespace drc {

// While an object of this class lives, the process can allocate only the given number of bytes more.
class AddressSpaceLimit {
  public:
    explicit AddressSpaceLimit(uint64_t more) {
        getrlimit(RLIMIT_AS, &before_);
        // Read without a buffer on the heap, which would count, and be gone a moment later.
        char text[128] = {};
        const int file = open("/proc/self/statm", O_RDONLY);
        if (file >= 0) {
            if (read(file, text, sizeof text - 1) < 0) text[0] = 0;
            close(file);
        }
        rlimit limit = before_;
        limit.rlim_cur = std::strtoull(text, nullptr, 10) * uint64_t(sysconf(_SC_PAGESIZE)) + more;
        setrlimit(RLIMIT_AS, &limit);
    }
    ~AddressSpaceLimit() { setrlimit(RLIMIT_AS, &before_); }
    AddressSpaceLimit(const AddressSpaceLimit&) = delete;
    AddressSpaceLimit& operator=(const AddressSpaceLimit&) = delete;

  private:
    rlimit before_{};
};

}  // namespace drc
