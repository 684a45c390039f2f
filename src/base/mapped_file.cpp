#include "base/mapped_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.h"

namespace drc {

MappedFile::MappedFile(const std::string& path) {
    const auto fail = [&](const std::string& message) { throw Error(SourceLocation{path}, message); };
    // Without O_NONBLOCK, opening a pipe would block until some program opens it for writing.
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) fail(fmt::format("cannot open: {}", std::strerror(errno)));
    struct stat info = {};
    if (::fstat(fd, &info) != 0 || !S_ISREG(info.st_mode)) {
        ::close(fd);
        fail("not a regular file");
    }
    const auto size = size_t(info.st_size);
    void* address = size ? ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, fd, 0) : nullptr;
    const int reason = errno;
    ::close(fd);
    if (address == MAP_FAILED) fail(fmt::format("cannot read: {}", std::strerror(reason)));
    bytes_ = {static_cast<const char*>(address), size};
}

MappedFile::~MappedFile() {
    if (!bytes_.empty()) ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

MappedFile::MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}

}  // namespace drc
