// Keeps a command's files apart: an output must replace neither an input nor another output.
#pragma once
#include <map>
#include <string>
#include <utility>

namespace drc {

// Whether two paths lead to the same file, also by symbolic or hard links, or will once the file is created.
bool isSameFile(const std::string& a, const std::string& b);

class DistinctFiles {
  public:
    // Register an input or an output. what: names the file in messages, such as "--timing" or "the scene's file". Both
    // throw Error if one file is read and written, or written twice: one line that begins with the written file's
    // `what` and path. Devices such as /dev/null may be written any number of times.
    void reads(const std::string& what, const std::string& path) { add({what + " " + path, true}, path); }
    void writes(const std::string& what, const std::string& path) { add({what + " " + path, false}, path); }

  private:
    using Inode = std::pair<unsigned long, unsigned long>;  // device number and inode number
    struct File {
        std::string name;  // for messages
        bool isRead;
    };
    void add(const File& file, const std::string& path);

    std::map<std::string, File> byPath_;
    std::map<Inode, File> byInode_;  // detects hard links
};

}  // namespace drc
