#include "base/error.h"

namespace drc {

std::string SourceLocation::str() const {
    if (file.empty() || line == 0) return file;
    return file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

Error::Error(const SourceLocation& where, const std::string& message, const std::string& excerpt)
    : std::runtime_error((where.empty() ? "" : where.str() + ": ") + message + (excerpt.empty() ? "" : "\n" + excerpt)),
      where_(where) {}

}  // namespace drc
