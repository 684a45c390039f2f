// Files that are either written whole or not at all: a crash, a full disk or Ctrl-C leaves the old file, if any, as it
// was.
#pragma once
#include <string>
#include <string_view>

namespace drc {

// Reserves a temporary file beside the target; commit() puts it in the target's place. Without a commit the
// destructor removes it. A target that is no regular file (/dev/stdout, a pipe) cannot be replaced: it is written
// directly. A symbolic link stays, and what it points to is replaced.
//     AtomicFile file("out.exr");
//     ... write to file.tempPath() ...
//     file.commit();
class AtomicFile {
  public:
    // Throws Error, naming the path and the system's reason, if nothing can be written there: better before a long
    // render than after it.
    explicit AtomicFile(const std::string& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    const std::string& tempPath() const { return temp_; }
    // Appends to the temporary file. Throws Error as the constructor does, with the temporary file removed.
    void write(std::string_view data);
    // Flushes to the disk and renames. Throws Error as the constructor does, with the temporary file removed.
    void commit();

  private:
    [[noreturn]] void fail(int errorNumber);
    void closeAndRemove();

    std::string path_;    // as the user named it, for messages
    std::string target_;  // what is replaced
    std::string temp_;
    int fd_ = -1;
    bool direct_ = false;  // temp_ is the target itself
};

void writeFileAtomically(const std::string& path, std::string_view data);

// Whole file as bytes. Throws Error naming the path and the reason.
std::string readFile(const std::string& path);

}  // namespace drc
