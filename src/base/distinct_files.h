// Keeps the files of a command apart: what it writes replaces neither what it reads nor another of its outputs.
#pragma once
#include <map>
#include <string>
#include <utility>

namespace drc {

// Whether two paths lead to one file, also by symbolic or hard links, or will once the file is made.
bool isSameFile(const std::string& a, const std::string& b);

class DistinctFiles {
  public:
    // what: names the file in messages, as "--timing" or "the scene's file". Both throw Error, in one line that begins
    // with what names the written file and its path, if one file is written and read, or written twice. Devices, such
    // as /dev/null, may be written by all.
    void reads(const std::string& what, const std::string& path) { add({what + " " + path, true}, path); }
    void writes(const std::string& what, const std::string& path) { add({what + " " + path, false}, path); }

  private:
    using Inode = std::pair<unsigned long, unsigned long>;  // device and number
    struct File {
        std::string name;  // for messages
        bool isRead;
    };
    void add(const File& file, const std::string& path);

    std::map<std::string, File> byPath_;
    std::map<Inode, File> byInode_;  // finds hard links
};

}  // namespace drc
