#include "pbrt/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/error.h"

namespace drc::pbrt {
namespace {

// Files up to this size in bytes are copied, because unmapping a file interrupts all cores that run the process.
constexpr size_t kSmall = size_t(1) << 16;

// Reads up to `size` bytes, or fewer if the file has been shortened in the meantime. -1 if reading fails.
ssize_t readAll(int file, char* to, size_t size) {
    size_t done = 0;
    while (done < size) {
        const ssize_t count = ::read(file, to + done, size - done);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return -1;
        if (count == 0) break;
        done += size_t(count);
    }
    return ssize_t(done);
}

}  // namespace

MappedFile::MappedFile(const std::string& path, const std::string& what, uint64_t most) {
    const auto failed = [&](int reason) {
        throw Error("cannot read " + what + " '" + path + "': " + std::strerror(reason));
    };
    // Do not block if the path is a pipe without a writer.
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) failed(errno);
    struct stat status {};
    int reason = 0;
    if (::fstat(file, &status) != 0) {
        reason = errno;
    } else if (!S_ISREG(status.st_mode)) {
        reason = S_ISDIR(status.st_mode) ? EISDIR : EINVAL;
    } else if (uint64_t(status.st_size) > most) {
        reason = EFBIG;
    } else if (status.st_size > 0 && size_t(status.st_size) <= kSmall) {
        copy_ = std::make_unique_for_overwrite<char[]>(size_t(status.st_size));
        const ssize_t size = readAll(file, copy_.get(), size_t(status.st_size));
        if (size < 0) reason = errno;
        data_ = copy_.get();
        size_ = size_t(std::max<ssize_t>(size, 0));
    } else if (status.st_size > 0) {
        void* memory = ::mmap(nullptr, size_t(status.st_size), PROT_READ, MAP_PRIVATE, file, 0);
        if (memory == MAP_FAILED) {
            reason = errno;
        } else {
            data_ = static_cast<const char*>(memory);
            size_ = size_t(status.st_size);
        }
    }
    ::close(file);
    if (reason != 0) failed(reason);
}

MappedFile::~MappedFile() {
    if (data_ != nullptr && !copy_) ::munmap(const_cast<char*>(data_), size_);
}

}  // namespace drc::pbrt
