#include "base/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <map>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include "base/limits.h"
#include "base/warning_batch.h"

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

// Messages quote files. This replaces control characters, so that a file cannot send escape sequences to the terminal,
// and cuts very long texts.
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
int unseenWarnings = 0;  // warnings beyond limits::kWarnings; without their texts, repetitions are counted too
bool saidThereAreMore = false;

std::string warningText(const SourceLocation& where, const std::string& message) {
    return printable((where.empty() ? "" : where.str() + ": ") + "warning: " + message);
}

// A warning that a WarningBatch holds back.
struct Kept {
    std::string text;  // including the first location
    int more = 0;      // number of further locations
};
int openBatches = 0;
std::vector<Kept>& kept() {
    static std::vector<Kept> all;
    return all;
}
std::map<std::string, size_t>& keptByMessage() {
    static std::map<std::string, size_t> indices;
    return indices;
}

// Warnings with equal keys count as identical. atEnd: suffix for a warning that is printed at once.
void warn(const std::string& key, const SourceLocation& where, const std::string& message, const char* atEnd) {
    std::string text = warningText(where, message);
    {
        const std::lock_guard lock(warningMutex);
        std::set<std::string>& seen = warnings();
        if (const auto known = keptByMessage().find(message); known != keptByMessage().end() && !where.empty()) {
            // Counts a further location, unless this exact warning was given before.
            Kept& first = kept()[known->second];
            if (first.text == text || seen.contains(text)) return;
            ++first.more;
            if (key != text) return;
            if (seen.size() < limits::kWarnings)
                seen.insert(text);
            else
                ++unseenWarnings;
            return;
        }
        if (seen.contains(key)) return;
        const bool isKnown = seen.size() < limits::kWarnings;
        if (isKnown) {
            seen.insert(key);
        } else {
            ++unseenWarnings;
            if (std::exchange(saidThereAreMore, true)) return;
            text = "warning: there are more warnings than these; they are not shown";
        }
        if (openBatches > 0) {
            if (isKnown) keptByMessage()[message] = kept().size();
            kept().push_back({text});
            return;
        }
    }
    logger().warn("{}{}", text, atEnd);
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
    warn(warningText(where, message), where, message, "");
}

void logWarningOnce(const SourceLocation& where, const std::string& message) {
    warn(printable(message), where, message, " (said once)");
}

WarningBatch::WarningBatch() {
    const std::lock_guard lock(warningMutex);
    ++openBatches;
}

WarningBatch::~WarningBatch() {
    std::vector<Kept> ready;
    {
        const std::lock_guard lock(warningMutex);
        if (--openBatches > 0) return;
        ready.swap(kept());
        keptByMessage().clear();
    }
    for (const Kept& warning : ready)
        logger().warn("{}{}", warning.text, warning.more > 0 ? fmt::format(" (and {} more)", warning.more) : "");
}

int warningCount() {
    const std::lock_guard lock(warningMutex);
    return int(warnings().size()) + unseenWarnings;
}

void forgetWarnings() {
    const std::lock_guard lock(warningMutex);
    warnings().clear();
    unseenWarnings = 0;
    saidThereAreMore = false;
}

}  // namespace drc
