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
#include "base/link_end.h"
#include "base/stream_file.h"

namespace drc {
namespace fs = std::filesystem;
namespace {

// Gives the new file the old one's permissions, and its owner and group if the system allows that.
void keepAccess(int fd, const struct stat& old) {
    struct stat now = {};
    if (fstat(fd, &now) != 0) return;
    mode_t mode = old.st_mode & 0777;
    const bool sameGroup = now.st_gid == old.st_gid;
    const bool sameOwner = now.st_uid == old.st_uid;
    if ((!sameOwner || !sameGroup) && fchown(fd, old.st_uid, old.st_gid) != 0 && !sameGroup &&
        fchown(fd, uid_t(-1), old.st_gid) != 0)
        mode = (mode & ~070u) | (mode & 07u) << 3;  // a group other than the old one gets only the rights of others
    [[maybe_unused]] const int ignored = fchmod(fd, mode);
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path), target_(path) {
    if (path.empty()) fail(ENOENT);
    findTarget();
    struct stat old = {};
    const bool exists = ownDescriptor(target_) >= 0 || stat(target_.c_str(), &old) == 0;
    // For example a name that is too long; the temporary file's name would not be.
    if (!exists && errno != ENOENT) fail(errno);
    if (exists && S_ISDIR(old.st_mode)) fail(EISDIR);
    if (exists && !S_ISREG(old.st_mode)) {
        try {
            fd_ = openStream(target_);
        } catch (const Error& error) {
            fail(error.what());
        }
        return;
    }
    // A file that its owner made read-only must not be replaced, even where the folder's permissions allow it.
    if (exists && faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) fail(errno);
    openTemporary(exists);
    if (exists) keepAccess(fd_, old);
}

AtomicFile::~AtomicFile() { closeAndRemove(); }

void AtomicFile::findTarget() {
    std::error_code failure;
    target_ = endOfLinks(path_, failure);
    if (failure) fail(failure.value());
}

void AtomicFile::openTemporary(bool replaces) {
    static std::atomic<int> serial{0};
    const fs::path t(target_);
    constexpr size_t kLongestName = 200;  // leaves room for the suffix: names have at most 255 bytes
    do {
        // Hidden, and without the target's extension, so that no "*.exr" picks up a half-written file.
        const std::string name =
            fmt::format(".{}.{}.{}.tmp", t.filename().string().substr(0, kLongestName), getpid(), serial++);
        temp_ = (t.parent_path() / name).string();
        // If the name exists, the file belongs to another machine on the same disk or is left from a crash: try the
        // next.
        fd_ = ::open(temp_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, replaces ? 0600 : 0666);
    } while (fd_ < 0 && errno == EEXIST);
    if (fd_ >= 0) return;
    const int reason = errno;
    temp_.clear();
    fail(reason);
}

void AtomicFile::closeAndRemove() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
    if (!temp_.empty()) ::unlink(temp_.c_str());
    temp_.clear();
}

void AtomicFile::fail(int errorNumber) { fail(std::strerror(errorNumber)); }

void AtomicFile::fail(const std::string& reason) {
    closeAndRemove();
    const std::string link = target_ == path_ ? "" : fmt::format(" (a link to {})", target_);
    throw Error(fmt::format("cannot write {}{}: {}", path_.empty() ? "\"\"" : path_, link, reason));
}

void AtomicFile::write(std::string_view data) {
    if (temp_.empty()) {
        try {
            return writeStream(fd_, data);
        } catch (const Error& error) {
            fail(error.what());
        }
    }
    while (!data.empty()) {
        const ssize_t n = ::write(fd_, data.data(), data.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail(errno);
        if (n == 0) fail(ENOSPC);
        data.remove_prefix(static_cast<size_t>(n));
    }
}

void AtomicFile::commit() {
    // Network file systems and quotas may report a full disk only here. Pipes and terminals cannot be flushed.
    if (::fsync(fd_) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP) fail(errno);
    const int closed = ::close(fd_);
    fd_ = -1;
    if (closed != 0 && errno != EINTR) fail(errno);
    if (!temp_.empty() && ::rename(temp_.c_str(), target_.c_str()) != 0) fail(errno);
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
