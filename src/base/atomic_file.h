// Files that are written whole or not at all: a crash, a full disk or Ctrl-C leaves the old file as it was.
#pragma once
#include <string>
#include <string_view>

namespace drc {

// Reserves a temporary file beside the target. commit() replaces the target by it, with the old file's permissions, and
// its owner and group as far as the system allows. Without commit(), the destructor removes the temporary file.
//
// A symbolic link is kept: the file that it points to is replaced or created. Paths that are not regular files (a pipe,
// a terminal, /dev/null) cannot be replaced, nor can descriptors that the program was given (/dev/stdout, /dev/fd/3):
// the data is written to them directly (stream_file.h). Opening a named pipe waits for its reader.
//
//     AtomicFile file("out.exr");
//     file.write(bytes);
//     file.commit();
class AtomicFile {
  public:
    // Throws Error, with the path and the system's reason, if the path is not writable: an error before a long render
    // is better than one after it.
    explicit AtomicFile(const std::string& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    // Appends to the temporary file. Throws Error as the constructor does, with the temporary file removed.
    void write(std::string_view data);
    // Flushes the file to disk and renames it. Throws Error as the constructor does, with the temporary file removed.
    void commit();

  private:
    [[noreturn]] void fail(int errorNumber);
    [[noreturn]] void fail(const std::string& reason);
    void findTarget();
    void openTemporary(bool replaces);
    void closeAndRemove();

    std::string path_;    // as the user named it, for messages
    std::string target_;  // end of its links: the file that is replaced or written directly
    std::string temp_;    // empty if the target is written directly
    int fd_ = -1;
};

void writeFileAtomically(const std::string& path, std::string_view data);

// Reads a whole file. Throws Error with the path and the reason.
std::string readFile(const std::string& path);

}  // namespace drc
