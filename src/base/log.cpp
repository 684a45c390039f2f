#include "base/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <mutex>
#include <set>

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

std::mutex warningMutex;
std::set<std::string>& warnings() {
    static std::set<std::string> seen;
    return seen;
}

}  // namespace

void setLogLevel(LogLevel level) {
    logger().set_level(level == LogLevel::Quiet    ? spdlog::level::warn
                       : level == LogLevel::Normal ? spdlog::level::info
                                                   : spdlog::level::debug);
}

void logError(const std::string& message) { logger().error("{}", "error: " + message); }
void logInfo(const std::string& message) { logger().info("{}", message); }
void logDebug(const std::string& message) { logger().debug("{}", message); }

void logWarning(const SourceLocation& where, const std::string& message) {
    const std::string text = (where.empty() ? "" : where.str() + ": ") + "warning: " + message;
    {
        const std::lock_guard lock(warningMutex);
        if (!warnings().insert(text).second) return;
    }
    logger().warn("{}", text);
}

int warningCount() {
    const std::lock_guard lock(warningMutex);
    return int(warnings().size());
}

}  // namespace drc
