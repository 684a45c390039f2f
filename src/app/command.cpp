#include "app/command.h"

#include <unistd.h>

#include <charconv>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "app/usage_error.h"
#include "base/limits.h"

namespace drc {
namespace {

// The time at which the system started this process, because --time promises the whole of it: loading its twenty
// libraries takes some ten milliseconds before main begins, and longer if they come from a disk. The present time if
// /proc does not tell.
std::chrono::steady_clock::time_point processStart() {
    const auto now = std::chrono::steady_clock::now();
    std::ifstream file("/proc/self/stat");
    std::string stat;
    std::getline(file, stat);
    // The second field, the program's name, may contain spaces; the 22nd is the start, in ticks since the boot.
    const size_t nameEnd = stat.rfind(')');
    if (nameEnd == std::string::npos) return now;
    std::istringstream fields(stat.substr(nameEnd + 1));
    std::string skipped;
    for (int i = 3; i < 22; ++i) fields >> skipped;
    double ticks = 0;
    timespec boot{};
    if (!(fields >> ticks) || clock_gettime(CLOCK_BOOTTIME, &boot) != 0) return now;
    const double age = double(boot.tv_sec) + double(boot.tv_nsec) * 1e-9 - ticks / double(sysconf(_SC_CLK_TCK));
    if (age < 0) return now;
    return now - std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(age));
}

}  // namespace

ProcessInfo& processInfo() {
    static ProcessInfo info{processStart(), {}};
    return info;
}

FilmGeometry parseResolution(const std::string& text) {
    FilmGeometry film;
    const char* const end = text.data() + text.size();
    const auto [afterWidth, noWidth] = std::from_chars(text.data(), end, film.width);
    const bool hasTwo = noWidth == std::errc() && afterWidth != end && *afterWidth == 'x';
    const auto [afterHeight, noHeight] = std::from_chars(hasTwo ? afterWidth + 1 : end, end, film.height);
    const auto isSide = [](int pixels) { return pixels >= 1 && pixels <= limits::kFilmSide; };
    if (!hasTwo || noHeight != std::errc() || afterHeight != end || !isSide(film.width) || !isSide(film.height))
        throw UsageError("--resolution " + text + ": give width and height in pixels, at most 65536 each, as 1280x720");
    return film;
}

std::string sceneTitle(const std::string& path) {
    if (path == "-") return "standard input";
    std::error_code ignored;
    const std::filesystem::path whole = std::filesystem::absolute(path, ignored);
    return (whole.parent_path().filename() / whole.filename()).string();
}

}  // namespace drc
