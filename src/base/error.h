// The exception for errors that the user can fix: a bad file, a bad option, a full disk.
#pragma once
#include <stdexcept>
#include <string>

namespace drc {

// A position in a text file. Lines and columns count from 1; line 0 means the whole file.
struct SourceLocation {
    std::string file;
    int line = 0;
    int column = 0;

    bool empty() const { return file.empty(); }
    // "file:line:column"; "file" if the line is 0; "" if the location is empty.
    std::string str() const;
};

// what() is ready to print: "file:line:column: message", followed on the next lines by an excerpt of the file with a
// caret, if available. The message says what is wrong and what would be right.
class Error : public std::runtime_error {
  public:
    explicit Error(const std::string& message) : std::runtime_error(message) {}
    Error(const SourceLocation& where, const std::string& message, const std::string& excerpt = "");
    const SourceLocation& where() const { return where_; }

  private:
    SourceLocation where_;
};

}  // namespace drc
