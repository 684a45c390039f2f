#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <set>

#include "app/command.h"
#include "app/exit_code.h"
#include "app/option_checks.h"
#include "app/shipped_folders.h"
#include "app/usage_error.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/limits.h"
#include "base/log.h"
#include "bench/bench.h"
#include "bench/bench_json.h"
#include "bench/bench_page.h"
#include "bench/bench_table.h"
#include "integrators/integrator.h"
#include "render/picture_writer.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

// The budget if none is given.
constexpr int kDefaultSeconds = 10;

struct BenchOptions {
    std::vector<std::string> scenes, methods{"drc", "path"}, namedMethods, adapters;
    std::vector<std::string> seconds, spp, tasks;
    std::string output = "out/bench", references, resolution;
    ReferenceSettings reference;
    int repeats = 1, threads = 0, directSpp = 16;
    double limit = 3600;
    std::string oidnLibrary;
    bool quiet = false, verbose = false;
};

double parseAmount(const std::string& text, const std::string& option) {
    double value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || end != text.data() + text.size() || !(value > 0 && value < 1e9))
        throw UsageError(
            fmt::format("{} {}: give positive numbers with commas between, or 1..256 for 1,2,4 to 256", option, text));
    return value;
}

// "a..b" stands for a, 2a, 4a and so on, up to b.
void addBudgets(std::vector<Budget>& budgets, const std::vector<std::string>& texts, BudgetUnit unit,
                const std::string& option) {
    const auto add = [&](double amount, const std::string& text) {
        if (unit != BudgetUnit::Seconds && amount != std::floor(amount))
            throw UsageError(fmt::format("{} {}: must be a whole number", option, text));
        const Budget budget{unit, amount};
        if (std::find(budgets.begin(), budgets.end(), budget) == budgets.end()) budgets.push_back(budget);
    };
    for (const std::string& text : texts) {
        const size_t dots = text.find("..");
        const double first = parseAmount(text.substr(0, dots), option);
        const double last = dots == std::string::npos ? first : parseAmount(text.substr(dots + 2), option);
        for (double amount = first; amount <= last; amount *= 2) add(amount, text);
    }
}

std::optional<Adapter> findAdapter(const std::string& name, const std::vector<Adapter>& given) {
    for (const Adapter& adapter : given)
        if (adapter.name == name) return adapter;
    std::error_code ignored;
    for (const fs::path& folder : shippedFolders("integrations"))
        if (fs::exists(folder / name / "adapter.json", ignored)) return readAdapter((folder / name).string());
    return {};
}

std::vector<BenchMethod> makeMethods(const BenchOptions& o) {
    std::vector<Adapter> adapters;
    for (const std::string& path : o.adapters) adapters.push_back(readAdapter(path));
    std::vector<BenchMethod> methods;
    std::set<std::string> names;
    const auto add = [&](const std::string& text) {
        asUsage(
            [&] { methods.emplace_back(text, [&](const std::string& name) { return findAdapter(name, adapters); }); });
        if (!names.insert(methods.back().name()).second)
            throw UsageError(fmt::format("two methods are called {}", methods.back().name()));
    };
    for (const std::string& method : o.methods) {
        if (method.find('=') != std::string::npos)
            throw UsageError(fmt::format("--methods {}: give a method with options of its own by --method", method));
        add(method);
    }
    for (const std::string& method : o.namedMethods) {
        if (method.find('=') == std::string::npos)
            throw UsageError(
                fmt::format("--method {}: give NAME=OPTIONS, the options being those of drc render", method));
        add(method);
    }
    return methods;
}

BenchSettings makeSettings(const BenchOptions& o) {
    BenchSettings s;
    s.scenes = o.scenes;
    s.methods = makeMethods(o);
    addBudgets(s.budgets, o.seconds, BudgetUnit::Seconds, "--seconds");
    addBudgets(s.budgets, o.spp, BudgetUnit::Spp, "--spp");
    addBudgets(s.budgets, o.tasks, BudgetUnit::Tasks, "--tasks");
    if (s.budgets.empty()) s.budgets = {{BudgetUnit::Seconds, kDefaultSeconds}};
    for (const BenchMethod& method : s.methods)
        if (std::none_of(s.budgets.begin(), s.budgets.end(), [&](const Budget& b) { return method.keeps(b.unit); }))
            throw UsageError(fmt::format("method {} keeps none of the budgets that are asked for", method.name()));
    if (!o.resolution.empty()) {
        const FilmGeometry film = parseResolution(o.resolution);
        constexpr int kLeast = 11;  // what SSIM needs
        if (film.width < kLeast || film.height < kLeast)
            throw UsageError(
                fmt::format("--resolution {}: pictures are compared from {} pixels upwards", o.resolution, kLeast));
        s.width = film.width, s.height = film.height;
    }
    s.repeats = o.repeats;
    s.output = o.output;
    s.references = o.references;
    s.threads = threadCount();
    s.limitSeconds = o.limit;
    s.own.path = fs::read_symlink("/proc/self/exe").string();
    s.own.directSpp = o.directSpp;
    s.own.oidnLibrary = o.oidnLibrary;
    s.reference = o.reference;
    s.reference.program = s.own.path;
    s.reference.threads = s.threads;
    return s;
}

void bench(const BenchOptions& o) {
    setLogLevel(o.quiet ? LogLevel::Quiet : o.verbose ? LogLevel::Verbose : LogLevel::Normal);
    setThreadCount(o.threads);
    const BenchSettings settings = makeSettings(o);
    if (o.seconds.empty() && o.spp.empty() && o.tasks.empty())
        logInfo(fmt::format("no budget is given: {} s for each render; --seconds, --spp and --tasks set others",
                            kDefaultSeconds));
    const auto file = [&](const char* name) { return (fs::path(o.output) / name).string(); };
    std::error_code failed;
    fs::create_directories(o.output, failed);
    if (failed) throw Error(fmt::format("-o {}: {}", o.output, failed.message()));
    for (const char* name : {"bench.json", "bench.md", "index.html"}) checkOutput("-o", file(name));
    installInterruptHandler();
    const BenchReport report = runBench(settings, &interruptToken());
    if (interruptToken().cancelled()) exitCode() = 128 + interruptSignal();
    const std::string table = benchMarkdown(report);
    fmt::print("{}", table);
    writeFileAtomically(file("bench.json"), toJson(report));
    writeFileAtomically(file("bench.md"), table);
    writeFileAtomically(file("index.html"), benchPage(report, o.output));
    const auto failures =
        size_t(std::ranges::count_if(report.runs, [](const BenchRun& run) { return !run.failure.empty(); }));
    if (interruptToken().cancelled()) logInfo("interrupted; called again in the same way, it goes on");
    logInfo(fmt::format("{}: {} runs, {} failed", file("index.html"), report.runs.size(), failures));
    if (failures > 0 && failures == report.runs.size())
        throw Error("all runs failed; the first: " + report.runs[0].failure);
}

}  // namespace

void addBenchCommand(CLI::App& app) {
    auto* command = app.add_subcommand("bench", "Compare renderers: scenes x methods x budgets, as a page with tables");
    auto o = std::make_shared<BenchOptions>();
    command->add_option("SCENE", o->scenes, "Scene files, pbrt-v3 or pbrt-v4")->required();
    command->add_option("-o,--output", o->output, "Folder for index.html, bench.json, bench.md and all pictures")
        ->capture_default_str();
    command
        ->add_option(
            "--methods", o->methods,
            fmt::format(
                "With commas between: {}, drc-maps:MAP-DENOISER (none, gaussian, oracle), drc-maps:NETWORK, or the "
                "name "
                "of an adapter (cycles, mitsuba3, pbrt-v3, pbrt-v4); each with +DENOISER, as path+oidn: Open Image "
                "Denoise in its best mode for the budget, or in one that is named: path+oidn:high, :balanced, "
                ":high-raw, :balanced-raw, :fast-raw; raw: albedo and normal are not filtered first",
                fmt::join(integratorNames(), ", ")))
        ->delimiter(',')
        ->capture_default_str();
    command->add_option("--method", o->namedMethods,
                        "NAME=OPTIONS: our own renderer with these options of drc render; may be repeated");
    command->add_option(
        "--adapter", o->adapters,
        "Adapter file of another program, or its folder; may be repeated. The adapter's name is then a method");
    command
        ->add_option(
            "--seconds", o->seconds,
            fmt::format("Wall-clock budgets of the whole process, as 10,30. Default, if no budget is given: {}",
                        kDefaultSeconds))
        ->delimiter(',');
    command
        ->add_option("--spp", o->spp, "Budgets in samples a pixel, as 1..256: adapters and ours without radiance maps")
        ->delimiter(',');
    command->add_option("--tasks", o->tasks, "Budgets in indirect tasks, as 1..256: drc-maps")->delimiter(',');
    command->add_option("--direct-spp", o->directSpp, "Samples a pixel of direct light where the budget is in tasks")
        ->capture_default_str()
        ->check(wholeNumberIn(1, limits::kSamplesPerPixel));
    command->add_option("--repeats", o->repeats, "Number of runs of each method, each with its own seed")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    command->add_option(
        "--references", o->references,
        "Folder with NAME-1.exr and NAME-2.exr for each scene, of different seeds, or with NAME.exr, whose "
        "noise is then part of the errors. NAME is that of the scene file, or of its folder if the file "
        "is called scene.pbrt. Default: pairs are rendered, and kept in the output folder");
    command
        ->add_option("--reference-error", o->reference.error,
                     "Standard error that the noise of rendered references may leave in an error")
        ->capture_default_str()
        ->check(numberAbove(0));
    command->add_option("--reference-integrator", o->reference.integrator, "path or bdpt")
        ->capture_default_str()
        ->check(CLI::IsMember({"path", "bdpt"}));
    command
        ->add_option("--reference-spp", o->reference.maxSpp,
                     "Samples a pixel of each reference at which rendering it stops, whatever its noise")
        ->capture_default_str()
        ->check(wholeNumberIn(1, limits::kSamplesPerPixel));
    command->add_option("--resolution", o->resolution,
                        "WIDTHxHEIGHT in pixels. Default: the given references', else 1280x720");
    command->add_option("--limit", o->limit, "Seconds after which a run without a budget in seconds is ended")
        ->capture_default_str()
        ->check(secondsOfWork());
    addThreadsOption(*command, o->threads);
    command->add_option("--oidn-library", o->oidnLibrary,
                        "Path of libOpenImageDenoise.so, if the system does not find it by itself");
    command->add_flag("--quiet", o->quiet, "Print only the table, warnings and errors");
    command->add_flag("-v,--verbose", o->verbose, "Print more messages, among them the command lines");
    command->footer(
        "Example: drc bench scene.pbrt --methods drc,path+oidn --seconds 10,30,60\n"
        "After an interruption, which ends it with 130 (Ctrl-C), 143 (SIGTERM) or 129 (SIGHUP), the same command\n"
        "continues where it stopped.");
    command->callback([o] { bench(*o); });
}

}  // namespace drc
