// Messages to the user on standard error. Errors and warnings are always shown, information unless --quiet, debug
// messages with -v.
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
// Prints "file:line:column: warning: message". Safe to call from several threads. Identical warnings are printed once.
void logWarning(const SourceLocation& where, const std::string& message);
// Like logWarning(), for problems that may occur at thousands of locations in a file: prints only the first location,
// with "(said once)" or, within a WarningBatch (warning_batch.h), with the number of further ones.
void logWarningOnce(const SourceLocation& where, const std::string& message);
inline void logWarning(const std::string& message) { logWarning({}, message); }
// Number of different warnings so far, for tests and `drc info`. Texts beyond limits::kWarnings are not stored, so
// repetitions of those warnings are counted each time.
int warningCount();
// Forgets all earlier warnings, for tests and for programs that read many files.
void forgetWarnings();

}  // namespace drc
