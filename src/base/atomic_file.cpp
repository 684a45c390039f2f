#include "base/atomic_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/error.h"

namespace drc {
namespace fs = std::filesystem;

AtomicFile::AtomicFile(const std::string& path) : path_(path), target_(path) {
    std::error_code ec;
    if (fs::is_symlink(path, ec)) {
        const fs::path real = fs::weakly_canonical(path, ec);
        if (!ec) target_ = real.string();
    }
    const auto status = fs::status(target_, ec);
    if (fs::is_directory(status)) fail(EISDIR);
    const bool replaces = fs::is_regular_file(status);
    if (fs::exists(status) && !replaces) {
        direct_ = true;
        temp_ = target_;
        fd_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
        if (fd_ < 0) fail(errno);
        return;
    }
    if (path.empty()) fail(ENOENT);
    // A file that its owner made read-only is not to be replaced, although the folder's permissions allow it.
    if (replaces && access(target_.c_str(), W_OK) != 0) fail(errno);
    static std::atomic<int> serial{0};
    const fs::path t(target_);
    // Hidden, and without the target's extension, so that no "*.exr" picks up a half-written file.
    const std::string name = fmt::format(".{}.{}.{}.tmp", t.filename().string(), getpid(), serial++);
    temp_ = (t.parent_path() / name).string();
    fd_ = ::open(temp_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (fd_ < 0) {
        const int reason = errno;
        temp_.clear();
        fail(reason);
    }
    struct stat old;
    if (replaces && stat(target_.c_str(), &old) == 0) {
        [[maybe_unused]] const int ignored = fchmod(fd_, old.st_mode & 07777);  // the new file keeps the old one's mode
    }
}

AtomicFile::~AtomicFile() { closeAndRemove(); }

void AtomicFile::closeAndRemove() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
    if (!direct_ && !temp_.empty()) ::unlink(temp_.c_str());
    temp_.clear();
}

void AtomicFile::fail(int errorNumber) {
    closeAndRemove();
    throw Error(fmt::format("cannot write {}: {}", path_.empty() ? "\"\"" : path_, std::strerror(errorNumber)));
}

void AtomicFile::write(std::string_view data) {
    while (!data.empty()) {
        const ssize_t n = ::write(fd_, data.data(), data.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail(errno);
        if (n == 0) fail(ENOSPC);
        data.remove_prefix(static_cast<size_t>(n));
    }
}

void AtomicFile::commit() {
    // File systems over a network, and quotas, may report a full disk only here. Pipes and terminals cannot be flushed.
    if (::fsync(fd_) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP) fail(errno);
    const int closed = ::close(fd_);
    fd_ = -1;
    if (closed != 0 && errno != EINTR) fail(errno);
    if (!direct_ && ::rename(temp_.c_str(), target_.c_str()) != 0) fail(errno);
    temp_.clear();
}

void writeFileAtomically(const std::string& path, std::string_view data) {
    AtomicFile file(path);
    file.write(data);
    file.commit();
}

std::string readFile(const std::string& path) {
    const auto fail = [&](int reason) { throw Error(fmt::format("cannot read {}: {}", path, std::strerror(reason))); };
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd < 0) fail(errno);
    std::string data;
    struct stat status;
    if (fstat(fd, &status) == 0 && S_ISREG(status.st_mode)) data.reserve(static_cast<size_t>(status.st_size) + 1);
    constexpr size_t kBlock = 1 << 16;
    for (size_t size = 0;;) {
        data.resize(size + kBlock);
        const ssize_t n = ::read(fd, data.data() + size, kBlock);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) {
            const int reason = errno;
            ::close(fd);
            if (n < 0) fail(reason);
            data.resize(size);
            return data;
        }
        size += static_cast<size_t>(n);
    }
}

}  // namespace drc
