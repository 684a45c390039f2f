#include "app/laboratory.h"

#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "app/shipped_folders.h"
#include "base/error.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

// Names another Python than the one in PATH, say that of a virtual environment.
constexpr const char* kPythonVariable = "DRC_PYTHON";

std::string pythonProgram() {
    const char* named = std::getenv(kPythonVariable);
    return named && *named ? named : "python3";
}

std::string startScript() {
    std::error_code ignored;
    for (const fs::path& folder : shippedFolders("lab"))
        if (const fs::path script = folder / "start.py"; fs::exists(script, ignored)) return script.string();
    throw Error(
        "the folder lab, the part of drc that is written in Python, is neither beside the program nor above it");
}

[[noreturn]] void cannotStart(int reason) {
    if (reason == ENOENT)
        throw Error(fmt::format(
            "{}: there is no such program: apt install python3 python3-numpy python3-matplotlib python3-jinja2, or let "
            "{} name a Python of 3.11 or later",
            pythonProgram(), kPythonVariable));
    throw Error(fmt::format("{}: cannot be started: {}", pythonProgram(), std::strerror(reason)));
}

class PythonCommand {
  public:
    PythonCommand(const std::string& command, const std::vector<std::string>& arguments)
        : words_{pythonProgram(), startScript(), command} {
        words_.insert(words_.end(), arguments.begin(), arguments.end());
        for (std::string& word : words_) pointers_.push_back(word.data());
        pointers_.push_back(nullptr);
    }
    const char* program() const { return pointers_[0]; }
    char* const* argv() const { return pointers_.data(); }

  private:
    std::vector<std::string> words_;
    std::vector<char*> pointers_;
};

}  // namespace

void becomeLaboratory(const std::string& command, const std::vector<std::string>& arguments) {
    const PythonCommand line(command, arguments);
    std::fflush(nullptr);
    execvp(line.program(), line.argv());
    cannotStart(errno);
}

int runLaboratory(const std::string& command, const std::vector<std::string>& arguments) {
    const PythonCommand line(command, arguments);
    std::fflush(nullptr);
    pid_t child = 0;
    if (const int failure = posix_spawnp(&child, line.program(), nullptr, nullptr, line.argv(), environ))
        cannotStart(failure);
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw Error(fmt::format("{}: lost: {}", line.program(), std::strerror(errno)));
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace drc
