#include <filesystem>
#include <string_view>

#include "app/command.h"
#include "app/laboratory.h"

namespace drc {

void addBenchCommand(CLI::App& app) {
    // Registered for the list of commands alone: isBench() is asked before the command line is parsed.
    app.add_subcommand(kBenchCommand, "Compare renderers: scenes x methods x budgets, as a page with tables");
}

bool isBench(int argc, const char* const* argv) { return argc > 1 && std::string_view(argv[1]) == kBenchCommand; }

void bench(int argc, const char* const* argv) {
    std::vector<std::string> arguments{"--drc", std::filesystem::read_symlink("/proc/self/exe").string()};
    arguments.insert(arguments.end(), argv + 2, argv + argc);
    becomeLaboratory(kBenchCommand, arguments);
}

}  // namespace drc
