// Messages to the user on standard error. Levels: error and warning are always shown, info unless quiet, debug with -v.
#pragma once
#include <fmt/core.h>

#include <string>
#include <utility>

#include "base/error.h"

namespace drc {

enum class LogLevel { Quiet, Normal, Verbose };
void setLogLevel(LogLevel level);

void logError(const std::string& message);
void logInfo(const std::string& message);
void logDebug(const std::string& message);
// Prints "file:line:column: warning: message". Thread-safe. Identical warnings are printed once.
void logWarning(const SourceLocation& where, const std::string& message);
inline void logWarning(const std::string& message) { logWarning({}, message); }
// How many different warnings were given so far, for tests and `drc info`. Those beyond limits::kWarnings, which are
// not kept, count each time.
int warningCount();
// As if there had been none: for tests, and for programs that read many files.
void forgetWarnings();

}  // namespace drc
