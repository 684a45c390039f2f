// The subcommands of `drc image`. Each registers itself; its callback does the work, writes one file whole or not at
// all, and throws Error on bad input.
#pragma once
#include <CLI/CLI.hpp>

namespace drc {

void addImageAverage(CLI::App& image);
void addImageConvert(CLI::App& image);
void addImageDenoise(CLI::App& image);
void addImageInfo(CLI::App& image);
void addImageMerge(CLI::App& image);
void addImageSplit(CLI::App& image);

}  // namespace drc
