// The command line as a whole: all subcommands with what they have in common, and messages about what cannot be meant.
#pragma once
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace drc {

// `drc` with its subcommands. A repeated option overrides the one before, but for those that are lists; the name of an
// option is never taken for the value of the one before it.
std::unique_ptr<CLI::App> makeCommandLine();

// What is wrong with the command line that did not parse, in one line that says what would be right: an unknown command
// or option with the nearest one, else the error's own words. Empty if there is nothing wrong: help was asked for.
std::string usageFault(const CLI::App& app, const CLI::ParseError& error);

// Ends a parse of `app` that threw: prints the help that was asked for, or what is wrong. The exit status: 0, or
// kUsageExitStatus.
int finishUnparsed(const CLI::App& app, const CLI::ParseError& error);

}  // namespace drc
