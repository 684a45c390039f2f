// The exception for an invalid command line: an option that does not exist, a value out of bounds, options that
// contradict each other. Faults of files and of the machine are Errors.
#pragma once
#include <string>

#include "base/error.h"

namespace drc {

// The exit status after a usage error: EX_USAGE of sysexits.h.
inline constexpr int kUsageExitStatus = 64;

class UsageError : public Error {
  public:
    explicit UsageError(const std::string& message) : Error(message) {}
};

// Returns f(), and turns an Error that it throws into a UsageError with the same message. For checks shared with
// callers other than the command line.
template <class F>
auto asUsage(F&& f) {
    try {
        return f();
    } catch (const Error& error) {
        throw UsageError(error.what());
    }
}

}  // namespace drc
