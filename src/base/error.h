// The one exception type for what a user can mend: a bad file, a bad option, a full disk.
#pragma once
#include <stdexcept>
#include <string>

namespace drc {

// A place in a text file. line and column count from 1; 0 means "the file as a whole".
struct SourceLocation {
    std::string file;
    int line = 0;
    int column = 0;

    bool empty() const { return file.empty(); }
    // "file:line:column", "file" or "".
    std::string str() const;
};

// what() is ready to print: "file:line:column: message", followed on the next lines by an excerpt with a caret where
// one was given. It says what is wrong and what would be right.
class Error : public std::runtime_error {
  public:
    explicit Error(const std::string& message) : std::runtime_error(message) {}
    Error(const SourceLocation& where, const std::string& message, const std::string& excerpt = "");
    const SourceLocation& where() const { return where_; }

  private:
    SourceLocation where_;
};

}  // namespace drc
