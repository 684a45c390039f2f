#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>

#include "app/command.h"
#include "app/evaluation_text.h"
#include "app/exit_code.h"
#include "app/laboratory.h"
#include "app/option_checks.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "base/log.h"
#include "base/parallel.h"
#include "render/picture_writer.h"

namespace drc {
namespace {

struct EvaluateOptions {
    EvaluationSettings settings;
    SampleSettings samples;
    std::string html;
    int threads = 0;
    bool json = false, quiet = false;
};

void makePictureFolder(const std::string& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) throw Error(fmt::format("--pictures {}: {}", folder, failed.message()));
}

// A new folder, removed at the end.
class ReportFolder {
  public:
    ReportFolder() : path_((std::filesystem::temp_directory_path() / "drc-evaluate-XXXXXX").string()) {
        if (mkdtemp(path_.data()) == nullptr)
            throw Error(fmt::format("cannot make a folder in {}: {}", std::filesystem::temp_directory_path().string(),
                                    std::generic_category().message(errno)));
    }
    ~ReportFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ReportFolder(const ReportFolder&) = delete;
    ReportFolder& operator=(const ReportFolder&) = delete;
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

// The laboratory makes the page of the JSON and of the pictures that it names.
void writeReportPage(const EvaluateOptions& options, const Evaluation& evaluation, const EvaluationReport& report) {
    const ReportFolder folder;
    SampleSettings samples = options.samples;
    samples.folder = folder.path();
    const std::string json = (std::filesystem::path(folder.path()) / "report.json").string();
    writeFileAtomically(json, evaluationJson(evaluation, report, &samples));
    if (const int status = runLaboratory("evaluate-page", {json, "-o", options.html})) exitCode() = status;
}

void run(EvaluateOptions& options) {
    setThreadCount(options.threads);
    if (options.quiet) setLogLevel(LogLevel::Quiet);
    options.settings.showProgress = !options.quiet;
    // Better to know before the work than after it that nothing can be written there, or that Python lacks a module.
    const bool hasPictures = !options.samples.folder.empty();
    if (hasPictures) makePictureFolder(options.samples.folder);
    if (!options.html.empty()) {
        checkOutput("--html", options.html);
        if (const int status = runLaboratory("check")) {
            exitCode() = status;
            return;
        }
    }
    const Evaluation evaluation = evaluate(options.settings);
    const EvaluationReport report = makeReport(evaluation);
    fmt::print("{}", options.json ? evaluationJson(evaluation, report, hasPictures ? &options.samples : nullptr)
                                  : evaluationTable(evaluation, report));
    if (!options.html.empty()) writeReportPage(options, evaluation, report);
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
    command->add_option("--pictures", o->samples.folder,
                        "Folder for pictures of maps as PNG files, which --json then names");
    command->add_option("--samples", o->samples.count, "Examples that are shown, of each projection")
        ->capture_default_str()
        ->check(CLI::Range(0, 1000));
    addSeedOption(*command, o->samples.seed, "Of the choice of these examples");
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
