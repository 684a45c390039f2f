#include "pbrt/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/error.h"

namespace drc::pbrt {

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
    if (data_ != nullptr) ::munmap(const_cast<char*>(data_), size_);
}

}  // namespace drc::pbrt
