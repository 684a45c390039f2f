// Runs a subcommand as the command line would, for tests.
#pragma once
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace drc::test {

// What `drc ARGUMENTS...` prints; throws what it throws. add: registers the subcommand.
inline std::string outputOf(void (*add)(CLI::App&), std::vector<std::string> arguments) {
    CLI::App app;
    add(app);
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants a vector
    testing::internal::CaptureStdout();
    try {
        app.parse(std::move(arguments));
    } catch (...) {
        testing::internal::GetCapturedStdout();
        throw;
    }
    std::fflush(stdout);
    return testing::internal::GetCapturedStdout();
}

}  // namespace drc::test
