// The command line as a whole: all subcommands, the rules that they share, and messages about usage faults.
#pragma once
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace drc {

// `drc` with its subcommands. A repeated option overrides the earlier one, unless it is a list; the name of an option
// is never accepted as the value of the option before it.
std::unique_ptr<CLI::App> makeCommandLine();

// Explains in one line why the command line did not parse, and what would be right: for an unknown command or option,
// names the nearest known one, otherwise gives the error's own message. Empty if help was asked for, which is no fault.
std::string usageFault(const CLI::App& app, const CLI::ParseError& error);

// Ends a parse of `app` that threw: prints the help that was asked for, or the fault. Returns the exit status: 0, or
// kUsageExitStatus.
int finishUnparsed(const CLI::App& app, const CLI::ParseError& error);

}  // namespace drc
