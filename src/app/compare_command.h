// `drc compare`: metrics between two image files.
#pragma once

namespace CLI {
class App;
}

namespace drc {

// Registers the subcommand. Its callback does the work, prints to standard output and throws Error on bad input.
void addCompareCommand(CLI::App& app);

}  // namespace drc
