#include "bench/bench.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/log.h"
#include "bench/bench_json.h"
#include "bench/measured_process.h"
#include "image/entropy.h"
#include "image/image_io.h"
#include "image/metrics.h"
#include "pbrt/scene_file.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

// Size and time of a file: what tells that it was changed.
std::string state(const std::string& path) {
    std::error_code missing;
    const auto size = fs::file_size(path, missing);
    const auto time = fs::last_write_time(path, missing);
    return missing ? "" : fmt::format("{}:{}", size, time.time_since_epoch().count());
}

// For a part of a path; different names stay different.
std::string fileName(const std::string& name) {
    std::string safe;
    uint32_t hash = 2166136261u;  // FNV-1a
    for (const char c : name) {
        safe += std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' || c == '.' ? c : '_';
        hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    }
    return safe == name && name[0] != '.' ? safe : fmt::format("_{}-{:08x}", safe, hash);
}

std::string processorName() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

void checkInstalled(const BenchMethod& method) {
    if (!method.adapter() || method.adapter()->check.empty()) return;
    const Adapter& adapter = *method.adapter();
    std::string what;
    try {
        const ProcessUse use = runMeasured(adapter.check, 120);
        if (use.exitCode == 0) return;
        what = lastLine(use.output);
    } catch (const Error& error) {
        what = error.what();
    }
    throw Error(fmt::format("{}: not installed ({}). {}", adapter.name, what, adapter.install));
}

std::string budgetFile(const Budget& budget, int repeat) {
    std::string name = budgetName(budget);
    std::erase(name, ' ');
    return fmt::format("{}-{}", name, repeat);
}

void measurePicture(const std::string& path, const Image& reference, BenchRun& run) {
    const Image picture = readLinearRgb(path);
    if (picture.width() != reference.width() || picture.height() != reference.height())
        throw Error(fmt::format("wrote {} pixels, not {}", sizeString(picture), sizeString(reference)));
    const Metrics m = compare(reference, picture);
    run.ssim = m.ssim, run.flip = m.flip, run.relmse = m.relmse, run.mse = m.mse;
    run.pngKb = m.pngKb[1];
    run.meanRatio = m.meanRatio;
    run.entropy = luminanceEntropy(picture);
}

double renderSeconds(const std::string& timing) {
    try {
        return nlohmann::json::parse(readFile(timing)).at("render_seconds");
    } catch (const std::exception&) {  // few programs tell
        return kNotMeasured;
    }
}

class Bench {
  public:
    Bench(const BenchSettings& settings, const CancelToken* cancel) : s_(settings), cancel_(cancel) {
        report_.version = DRC_VERSION;
        report_.processor = processorName();
        report_.threads = s_.threads;
        report_.budgets = s_.budgets;
        for (const BenchMethod& method : s_.methods) report_.methods.push_back(method.name());
        fs::create_directories(s_.output);
    }

    BenchReport run() {
        for (const BenchMethod& method : s_.methods) checkInstalled(method);
        std::set<std::string> names;
        for (const std::string& file : s_.scenes)
            if (!names.insert(sceneName(file)).second)
                throw Error(
                    fmt::format("two scenes are called {}; give one of them another file name", sceneName(file)));
        for (const std::string& file : s_.scenes) {
            if (cancelled()) break;
            prepare(file);
        }
        const int count = countRuns();
        for (int repeat = 0; repeat < s_.repeats; ++repeat)
            for (const BenchScene& scene : report_.scenes)
                for (const Budget& budget : s_.budgets)
                    for (const BenchMethod& method : s_.methods)
                        if (method.keeps(budget.unit) && !cancelled()) addRun(scene, method, budget, repeat, count);
        return std::move(report_);
    }

  private:
    bool cancelled() const { return cancel_ && cancel_->cancelled(); }

    int countRuns() const {
        int count = 0;
        for (const Budget& budget : s_.budgets)
            for (const BenchMethod& method : s_.methods) count += method.keeps(budget.unit);
        return count * s_.repeats * int(report_.scenes.size());
    }

    void prepare(const std::string& file) {
        BenchScene scene;
        scene.name = sceneName(file);
        scene.file = file;
        scene.width = s_.width, scene.height = s_.height;
        if (!s_.references.empty()) {
            scene.reference = fs::absolute(fs::path(s_.references) / (scene.name + ".exr")).lexically_normal().string();
            scene.referenceOrigin = "given";
        } else {
            if (scene.width == 0) {
                const FilmGeometry film = pbrt::loadPbrtFile(file)->settings.film;
                scene.width = film.width, scene.height = film.height;
            }
            const std::string folder = (fs::path(s_.output) / "references").string();
            fs::create_directories(folder);
            const Reference reference = renderReference(file, fileName(scene.name), scene.width, scene.height, folder,
                                                        state(file), s_.reference, cancel_);
            if (reference.path.empty()) return;
            scene.reference = fs::relative(reference.path, s_.output).string();
            scene.referenceOrigin = reference.origin;
        }
        const Image picture = readLinearRgb((fs::path(s_.output) / scene.reference).string());
        if (scene.width == 0) scene.width = picture.width(), scene.height = picture.height();
        if (picture.width() != scene.width || picture.height() != scene.height)
            throw Error(fmt::format("{}: the reference has {} pixels, {}x{} are wanted", scene.reference,
                                    sizeString(picture), scene.width, scene.height));
        scene.referencePngKb = double(encodePng(picture).size()) / 1000;
        scene.referenceEntropy = luminanceEntropy(picture);
        report_.scenes.push_back(scene);
    }

    std::string keyOf(const BenchMethod& method, BenchJob job) const {
        job.output = job.timing = "";  // the folder may be moved
        std::string key;
        for (const std::string& word : method.command(job, s_.own)) key += word + "\n";
        return key + (method.adapter() ? "" : state(s_.own.path)) + "\n" + state(job.scene);
    }

    void addRun(const BenchScene& scene, const BenchMethod& method, const Budget& budget, int repeat, int count) {
        ++number_;
        const fs::path relative =
            fs::path("runs") / fileName(scene.name) / fileName(method.name()) / budgetFile(budget, repeat);
        const std::string stem = (fs::path(s_.output) / relative).string();
        BenchJob job;
        job.scene = scene.file, job.output = stem + ".exr", job.timing = stem + ".timing.json";
        job.width = scene.width, job.height = scene.height;
        job.threads = s_.threads, job.seed = repeat;
        job.budget = budget;
        const std::string key = keyOf(method, job), record = stem + ".json";
        if (fs::exists(record))
            if (auto known = runFromJson(readFile(record), key))
                if (known->failure.empty() && fs::exists(job.output)) {
                    report_.runs.push_back(std::move(*known));
                    return;
                }

        BenchRun run;
        run.scene = scene.name, run.method = method.name(), run.budget = budget, run.repeat = repeat;
        run.picture = (relative.string() + ".exr");
        fs::create_directories(fs::path(stem).parent_path());
        for (const std::string& old : {record, job.output, job.timing}) fs::remove(old);
        if (!measure(method, job, scene, run)) return;
        writeFileAtomically(record, toJson(run, key));
        logInfo(fmt::format("{}/{} {}, {}, {}: {}", number_, count, run.scene, run.method, budgetName(budget),
                            run.failure.empty() ? fmt::format("{:.1f} s, SSIM {:.4f}, FLIP {:.4f}, relMSE {:.5f}",
                                                              run.seconds, run.ssim, run.flip, run.relmse)
                                                : "failed: " + run.failure));
        report_.runs.push_back(std::move(run));
    }

    // False if it was cancelled.
    bool measure(const BenchMethod& method, const BenchJob& job, const BenchScene& scene, BenchRun& run) const {
        const std::vector<std::string> command = method.command(job, s_.own);
        std::string line;
        for (const std::string& word : command) line += " " + word;
        logDebug(line.substr(1));
        // A method that overruns is judged by what it took; this ends what hangs.
        const double limit = job.budget.unit == BudgetUnit::Seconds ? 4 * job.budget.amount + 120 : s_.limitSeconds;
        try {
            const ProcessUse use = runMeasured(command, limit, cancel_);
            if (cancelled()) return false;
            if (use.stopped) throw Error(fmt::format("still running after {:.0f} s", limit));
            if (use.exitCode != 0)
                throw Error(use.output.empty() ? fmt::format("exit code {}", use.exitCode) : lastLine(use.output));
            if (!fs::exists(job.output)) throw Error("ended without a picture");
            run.seconds = use.seconds, run.cpuSeconds = use.cpuSeconds, run.peakMegabytes = use.peakMegabytes;
            run.renderSeconds = renderSeconds(job.timing);
            const Image reference = readLinearRgb((fs::path(s_.output) / scene.reference).string());
            measurePicture(job.output, reference, run);
        } catch (const Error& error) {
            run.failure = lastLine(error.what());
        }
        return true;
    }

    const BenchSettings& s_;
    const CancelToken* cancel_;
    BenchReport report_;
    int number_ = 0;
};

}  // namespace

std::string sceneName(const std::string& file) {
    const fs::path path = fs::absolute(file).lexically_normal();
    const std::string stem = path.stem().string();
    return stem == "scene" ? path.parent_path().filename().string() : stem;
}

BenchReport runBench(const BenchSettings& settings, const CancelToken* cancel) { return Bench(settings, cancel).run(); }

}  // namespace drc
