#include "base/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <mutex>
#include <set>

#include "base/limits.h"

namespace drc {
namespace {

spdlog::logger& logger() {
    static const auto instance = [] {
        auto l = spdlog::stderr_color_mt("drc");
        l->set_pattern("drc: %v");
        l->set_level(spdlog::level::info);
        return l;
    }();
    return *instance;
}

// Messages quote files. Control characters are replaced, so that a file cannot send escape sequences to the terminal,
// and very long names are cut.
std::string printable(std::string text) {
    if (text.size() > limits::kMessageBytes) {
        text.resize(limits::kMessageBytes);
        text += "...";
    }
    for (char& c : text)
        if ((static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\t') || c == 127) c = '?';
    return text;
}

std::mutex warningMutex;
std::set<std::string>& warnings() {
    static std::set<std::string> seen;
    return seen;
}
int unseenWarnings = 0;  // warnings beyond limits::kWarnings; their texts are not kept, so repetitions count too

// Warnings with the same key are the same.
void warn(const std::string& key, std::string text) {
    {
        const std::lock_guard lock(warningMutex);
        std::set<std::string>& seen = warnings();
        if (seen.contains(key)) return;
        if (seen.size() < limits::kWarnings)
            seen.insert(key);
        else if (unseenWarnings++ > 0)
            return;
        else
            text = "warning: there are more warnings than these; they are not shown";
    }
    logger().warn("{}", text);
}

std::string warningText(const SourceLocation& where, const std::string& message) {
    return printable((where.empty() ? "" : where.str() + ": ") + "warning: " + message);
}

}  // namespace

void setLogLevel(LogLevel level) {
    logger().set_level(level == LogLevel::Quiet    ? spdlog::level::warn
                       : level == LogLevel::Normal ? spdlog::level::info
                                                   : spdlog::level::debug);
}

void logError(const std::string& message) { logger().error("{}", "error: " + printable(message)); }
void logInfo(const std::string& message) { logger().info("{}", printable(message)); }
void logDebug(const std::string& message) { logger().debug("{}", message); }

void logWarning(const SourceLocation& where, const std::string& message) {
    const std::string text = warningText(where, message);
    warn(text, text);
}

void logWarningOnce(const SourceLocation& where, const std::string& message) {
    warn(printable(message), warningText(where, message + " (said once)"));
}

int warningCount() {
    const std::lock_guard lock(warningMutex);
    return int(warnings().size()) + unseenWarnings;
}

void forgetWarnings() {
    const std::lock_guard lock(warningMutex);
    warnings().clear();
    unseenWarnings = 0;
}

}  // namespace drc
