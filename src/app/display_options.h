// The options for displaying pictures, which `drc render` and `drc image` share.
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "image/display.h"

namespace drc {

// Adds --exposure, --auto-exposure and --view. group: their heading in --help; empty: that of the other options.
void addDisplayOptions(CLI::App& command, DisplaySettings& display, const std::string& group = "");

// The names of these options that the parsed `command` was given, for example "--exposure, --view".
std::string givenDisplayOptions(const CLI::App& command);
// Throws UsageError, which names the given ones of these options, if none of the outputs is a PNG: EXR files stay
// linear and unexposed, so the options would do nothing.
void refuseDisplayOptionsWithoutPng(const CLI::App& command, const std::vector<std::string>& outputs);

}  // namespace drc
