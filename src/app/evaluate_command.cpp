#include <memory>

#include "app/command.h"
#include "app/evaluation_page.h"
#include "app/evaluation_text.h"
#include "app/option_checks.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "base/log.h"
#include "base/parallel.h"

namespace drc {
namespace {

struct EvaluateOptions {
    EvaluationSettings settings;
    std::string html;
    int threads = 0, samples = 12;
    uint64_t seed = 0;
    bool json = false, quiet = false;
};

void run(EvaluateOptions& options) {
    setThreadCount(options.threads);
    if (options.quiet) setLogLevel(LogLevel::Quiet);
    options.settings.showProgress = !options.quiet;
    // Opened before the work, so that a page that cannot be written is reported at once.
    std::unique_ptr<AtomicFile> page;
    if (!options.html.empty()) page = std::make_unique<AtomicFile>(options.html);
    const Evaluation evaluation = evaluate(options.settings);
    const EvaluationReport report = makeReport(evaluation);
    fmt::print("{}", options.json ? evaluationJson(evaluation, report) : evaluationTable(evaluation, report));
    if (page) {
        page->write(evaluationPage(evaluation, report, {size_t(options.samples), options.seed}));
        page->commit();
    }
}

}  // namespace

void addEvaluateCommand(CLI::App& app) {
    auto* command = app.add_subcommand("evaluate", "Measure how close denoised maps come to converged ones");
    auto o = std::make_shared<EvaluateOptions>();
    command
        ->add_option("EXAMPLES", o->settings.paths,
                     "What `drc reference` writes: files, or folders of them; maps of several projections may be mixed")
        ->required();
    command
        ->add_option("--weights", o->settings.weights,
                     "A network: one that comes with the program, or a file of weights; may be repeated. Default: drc")
        ->allow_extra_args(false);
    command->add_flag("--all-inputs", o->settings.allInputs,
                      "Average over every realisation of an example, not the first alone");
    command->add_flag("--json", o->json, "Print one JSON object");
    command->add_option("--html", o->html, "Write a page with tables, box plots and pictures of maps");
    command->add_option("--samples", o->samples, "Examples that the page shows, of each projection")
        ->capture_default_str()
        ->check(CLI::Range(0, 1000));
    addSeedOption(*command, o->seed, "Of the choice of these examples");
    addThreadsOption(*command, o->threads);
    command->add_flag("--quiet", o->quiet, "Say nothing but errors, warnings and the result");
    command->footer(
        "Methods: none, gaussian (sigma 1), and each network whose projection the maps have, named as its file; each "
        "as\n"
        "the renderer runs it. Measures of a map and its target, both divided by the target's mean (as rendered), or\n"
        "each by its own (equal energy):\n"
        "  L1          mean absolute difference over the hemisphere\n"
        "  SSIM        of the luminances, exposed so that the target's 99th percentile is white, clipped above,\n"
        "              sRGB-encoded; window of 11 x 11 texels; 1 is equal\n"
        "  irradiance  relative squared error of the irradiance, mean over 64 normals in the hemisphere\n"
        "p: Wilcoxon's signed-rank test over examples, two-sided, normal approximation, and the Kruskal-Wallis test,\n"
        "which forgets which scores are of one example. Both take examples as independent; those of one scene are "
        "less\n"
        "so. Projections are compared on the viewpoints that both have.\n\n"
        "Example: drc evaluate examples/held-out --weights a.safetensors --weights b.safetensors --html page.html");
    command->callback([o] { run(*o); });
}

}  // namespace drc
