// `drc compare`: metrics of an image against one or two references.
#pragma once

namespace CLI {
class App;
}

namespace drc {

// Registers the subcommand. Its callback does the work, prints to standard output and throws Error on bad input.
void addCompareCommand(CLI::App& app);
// Registers the same command under the name `diff`, as a subcommand of `drc image`.
void addImageDiff(CLI::App& image);

}  // namespace drc
