// The options by which pictures are displayed, which `drc render` and `drc image` share.
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "image/display.h"

namespace drc {

// --exposure, --auto-exposure and --view. group: their heading in --help; empty: that of all others.
void addDisplayOptions(CLI::App& command, DisplaySettings& display, const std::string& group = "");

// Those of the options that were given to the parsed `command`: "--exposure, --view".
std::string givenDisplayOptions(const CLI::App& command);
// Throws UsageError that names those of the options that were given to the parsed `command`, if none of the outputs is
// a PNG: an EXR stays as it is, so that they would do nothing.
void refuseDisplayOptionsWithoutPng(const CLI::App& command, const std::vector<std::string>& outputs);

}  // namespace drc
