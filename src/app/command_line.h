// The command line as a whole: all subcommands with what they have in common, and messages about what cannot be meant.
#pragma once
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace drc {

// `drc` with its subcommands. A repeated option overrides the one before, but for those that are lists; the name of an
// option is never taken for the value of the one before it.
std::unique_ptr<CLI::App> makeCommandLine();

// Explains in one line why the command line did not parse, and what would be right: an unknown command or option with
// the nearest known one, else the error's own message. Empty if help was asked for, which is no fault.
std::string usageFault(const CLI::App& app, const CLI::ParseError& error);

// Ends a parse of `app` that threw: prints the help that was asked for, or what is wrong. The exit status: 0, or
// kUsageExitStatus.
int finishUnparsed(const CLI::App& app, const CLI::ParseError& error);

}  // namespace drc
