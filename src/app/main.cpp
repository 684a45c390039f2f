// drc: the command line. Exit codes, as in docs/exit-codes.md: 0 done, 1 an error that the user can mend, 128 + the
// signal (130 for Ctrl-C) interrupted before all was done; CLI11's own for a wrong command line.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "app/command.h"
#include "app/compare_command.h"
#include "app/exit_code.h"
#include "base/log.h"

int main(int argc, char** argv) {
    for (int i = 0; i < argc; ++i) drc::processInfo().commandLine += (i ? " " : "") + std::string(argv[i]);
    // Then a file beyond `ulimit -f` is an error of writing it, which can be said and mended.
    std::signal(SIGXFSZ, SIG_IGN);

    CLI::App app("Deep Radiance Caching: physically based global illumination for interiors, on a CPU.", "drc");
    app.set_version_flag("--version", "drc " DRC_VERSION);
    app.require_subcommand(1);
    app.footer("Example: drc render scene.pbrt -o picture.png");
    drc::addRenderCommand(app);
    drc::addViewCommand(app);
    drc::addCompareCommand(app);
    drc::addImageCommand(app);
    drc::addInfoCommand(app);
    drc::addReferenceCommand(app);
    drc::addEvaluateCommand(app);
    drc::addBenchCommand(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e);
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
