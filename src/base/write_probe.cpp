#include "base/write_probe.h"

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/link_end.h"
#include "base/stream_file.h"

namespace drc {
namespace {

// A full disk may still have room for a name, but not for a block of data.
constexpr size_t kBlock = 4096;

bool isStream(const std::string& path) {
    struct stat status = {};
    return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

}  // namespace

void probeWriting(const std::string& path) {
    std::error_code failure;
    const bool ownStream = ownDescriptor(endOfLinks(path, failure)) >= 0;
    if (!ownStream && isStream(path)) {
        if (access(path.c_str(), W_OK) != 0)
            throw Error(fmt::format("cannot write {}: {}", path, std::strerror(errno)));
        return;
    }
    AtomicFile file(path);
    if (!ownStream) file.write(std::string(kBlock, '\0'));
}

}  // namespace drc
