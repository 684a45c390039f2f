#include "app/open_in_browser.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>

#include "base/error.h"

namespace drc {
namespace {

// Time that the browser has to read the page.
constexpr std::chrono::seconds kKept{60};

// A new folder that other users cannot enter.
std::filesystem::path privateFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "drc-view-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw Error("cannot make a folder in " + std::filesystem::temp_directory_path().string() + ": " +
                    std::generic_category().message(errno));
    return name;
}

void writePage(const std::filesystem::path& path, const std::string& address) {
    const std::string page =
        "<!doctype html><meta charset=utf-8><title>drc view</title>"
        "<meta http-equiv=refresh content=\"0; url=" +
        address + "\">\n";
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    const bool whole = file >= 0 && write(file, page.data(), page.size()) == ssize_t(page.size());
    if (file >= 0) close(file);
    if (!whole) throw Error("cannot write " + path.string() + ": " + std::generic_category().message(errno));
}

}  // namespace

void openInBrowser(const std::string& address) {
    const std::filesystem::path folder = privateFolder(), page = folder / "view.html";
    const auto remove = [folder] {
        std::error_code ignored;
        std::filesystem::remove_all(folder, ignored);
    };
    std::string program = "xdg-open", argument = page.string();
    char* arguments[] = {program.data(), argument.data(), nullptr};
    pid_t child = 0;
    try {
        writePage(page, address);
        if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments, environ) != 0)
            throw Error("there is no xdg-open");
    } catch (...) {
        remove();
        throw;
    }
    std::thread([child, remove] {
        waitpid(child, nullptr, 0);
        std::this_thread::sleep_for(kKept);
        remove();
    }).detach();
}

}  // namespace drc
