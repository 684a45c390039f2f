// drc: the command line. Exit codes, as in docs/exit-codes.md: 0 done; 1 an error that the user can fix; 64 an invalid
// command line (EX_USAGE of sysexits.h); 128 + the signal's number (130 for Ctrl-C) interrupted before all was done.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "app/command.h"
#include "app/command_line.h"
#include "app/exit_code.h"
#include "app/usage_error.h"
#include "base/log.h"

int main(int argc, char** argv) {
    for (int i = 0; i < argc; ++i) drc::processInfo().commandLine += (i ? " " : "") + std::string(argv[i]);
    // With the signal ignored, a file beyond `ulimit -f` is a write error, which can be reported and handled.
    std::signal(SIGXFSZ, SIG_IGN);

    const std::unique_ptr<CLI::App> app = drc::makeCommandLine();
    try {
        if (drc::isBench(argc, argv)) drc::bench(argc, argv);
        app->parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return drc::finishUnparsed(*app, e);
    } catch (const drc::UsageError& e) {
        drc::logError(e.what());
        return drc::kUsageExitStatus;
    } catch (const std::bad_alloc&) {
        drc::logError("out of memory");
        return 1;
    } catch (const std::exception& e) {
        drc::logError(e.what());
        return 1;
    }
    // Exits without destructors: the system frees a large scene's memory at once, while they would take up to a second
    // of --time.
    std::fflush(nullptr);
    std::_Exit(drc::exitCode());
}
