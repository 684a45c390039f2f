#include "bench/bench.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/log.h"
#include "base/progress.h"
#include "bench/bench_json.h"
#include "bench/measured_process.h"
#include "bench/scene_references.h"
#include "image/image_io.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

constexpr int kUsersWidth = 1280, kUsersHeight = 720;  // smaller pictures have more samples a pixel than users' have
constexpr const char* kMeasuring = "2";                // to be raised when what is measured of a picture changes

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

// Reads the times and spp that a program reports.
void readTiming(const std::string& timing, BenchRun& run) {
    try {
        const auto json = nlohmann::json::parse(readFile(timing));
        const auto read = [&](const char* key, double& value) {
            if (json.contains(key) && json[key].is_number()) value = json[key];
        };
        read("load_seconds", run.loadSeconds);
        read("render_seconds", run.renderSeconds);
        read("denoise_seconds", run.denoiseSeconds);
        read("write_seconds", run.writeSeconds);
        read("spp", run.spp);
    } catch (const std::exception&) {  // few programs tell
    }
}

// Reads the metadata in pictures of our own program: spp. If it reports no denoising time, it did not denoise.
void readOwnMetadata(const std::string& picture, BenchRun& run) {
    if (std::isnan(run.denoiseSeconds) && !std::isnan(run.renderSeconds)) run.denoiseSeconds = 0;
    const ExrMetadata metadata = readExrMetadata(picture);
    if (const auto spp = metadata.find("drc:spp"); spp != metadata.end())
        run.spp = std::strtod(spp->second.c_str(), nullptr);
}

std::string found(const BenchRun& run) {
    const std::string se = std::isnan(run.errorSe) ? "" : fmt::format(" +- {:.5f}", run.errorSe);
    return fmt::format("{:.1f} s, error {:.5f}{}, SSIM {:.4f}, FLIP {:.4f}", run.seconds, run.error, se, run.ssim,
                       run.flip);
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
        announce();
        for (const std::string& file : s_.scenes) {
            if (cancelled()) break;
            prepare(file);
        }
        const int count = countRuns(report_.scenes.size());
        for (int repeat = 0; repeat < s_.repeats; ++repeat)
            for (const BenchScene& scene : report_.scenes)
                for (const Budget& budget : s_.budgets)
                    for (const BenchMethod& method : s_.methods)
                        if (method.keeps(budget.unit) && !cancelled()) addRun(scene, method, budget, repeat, count);
        return std::move(report_);
    }

  private:
    bool cancelled() const { return cancel_ && cancel_->cancelled(); }

    // Logs the number of renders, and the total time of those with a budget in seconds.
    void announce() const {
        double seconds = 0;
        for (const Budget& budget : s_.budgets)
            for (const BenchMethod& method : s_.methods)
                if (budget.unit == BudgetUnit::Seconds && method.keeps(budget.unit)) seconds += budget.amount;
        seconds *= double(s_.repeats) * double(s_.scenes.size());
        const int count = countRuns(s_.scenes.size());
        std::string text = fmt::format("{} render{}", count, count == 1 ? "" : "s");
        if (seconds > 0) text += fmt::format(", {} with a budget in seconds together", formatDuration(seconds));
        if (s_.references.empty())
            text += fmt::format("; before them two references of each scene, of at most {} spp", s_.reference.maxSpp);
        logInfo(text + fmt::format(", to {}", s_.output));
    }

    int countRuns(size_t scenes) const {
        int count = 0;
        for (const Budget& budget : s_.budgets)
            for (const BenchMethod& method : s_.methods) count += method.keeps(budget.unit);
        return count * s_.repeats * int(scenes);
    }

    void prepare(const std::string& file) {
        BenchScene scene;
        scene.name = sceneName(file);
        scene.file = file;
        scene.width = s_.width, scene.height = s_.height;
        const fs::path folder = fs::path(s_.output) / "references";
        std::vector<std::string> paths;
        if (!s_.references.empty()) {
            paths = givenReferences(s_.references, scene.name);
            scene.referenceOrigin = "given";
        } else {
            if (scene.width == 0) scene.width = kUsersWidth, scene.height = kUsersHeight;
            fs::create_directories(folder);
            const RenderedReferences rendered = renderReferences(file, fileName(scene.name), scene.width, scene.height,
                                                                 folder.string(), state(file), s_.reference, cancel_);
            if (rendered.first.empty()) return;
            paths = {fs::relative(rendered.first, s_.output).string(),
                     fs::relative(rendered.second, s_.output).string()};
            scene.referenceOrigin = rendered.origin;
        }
        if (paths.size() == 2) scene.pair = paths;
        scene.reference = paths[0];
        const SceneReferences& references = referencesOf(scene);
        const Image& shown = references.shown();
        if (scene.width == 0) scene.width = shown.width(), scene.height = shown.height();
        if (shown.width() != scene.width || shown.height() != scene.height)
            throw Error(fmt::format("{}: the reference has {} pixels, {}x{} are wanted", scene.reference,
                                    sizeString(shown), scene.width, scene.height));
        references.describe(scene);
        if (references.isPair()) {
            fs::create_directories(folder);
            const fs::path mean =
                folder / fmt::format("{}-{}x{}-mean.exr", fileName(scene.name), scene.width, scene.height);
            writeExr(mean.string(), shown);
            scene.reference = fs::relative(mean, s_.output).string();
        }
        report_.scenes.push_back(scene);
    }

    // Read once for all runs that follow each other.
    const SceneReferences& referencesOf(const BenchScene& scene) {
        if (loadedFor_ != scene.name) {
            loaded_.emplace(absolute(filesOf(scene)));
            loadedFor_ = scene.name;
        }
        return *loaded_;
    }
    static std::vector<std::string> filesOf(const BenchScene& scene) {
        return scene.pair.empty() ? std::vector{scene.reference} : scene.pair;
    }
    std::vector<std::string> absolute(std::vector<std::string> files) const {
        for (std::string& file : files) file = (fs::path(s_.output) / file).string();
        return files;
    }
    // When it changes, pictures are measured anew.
    std::string stateOfReferences(const BenchScene& scene) const {
        std::string states = kMeasuring;
        for (const std::string& file : absolute(filesOf(scene))) states += " " + state(file);
        return states;
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
        if (std::optional<BenchRun> known = knownRun(record, key, job.output, scene)) {
            report_.runs.push_back(std::move(*known));
            return;
        }

        BenchRun run;
        run.scene = scene.name, run.method = method.name(), run.budget = budget, run.repeat = repeat;
        run.picture = (relative.string() + ".exr");
        if (const OidnMode* mode = method.oidnMode(job)) run.oidnMode = mode->name;
        fs::create_directories(fs::path(stem).parent_path());
        for (const std::string& old : {record, job.output, job.timing}) fs::remove(old);
        const std::string name =
            fmt::format("{}/{} {}, {}, {}", number_, count, run.scene, run.method, budgetName(budget));
        logInfo(name + ": rendering");
        if (!measure(method, job, scene, run)) return;
        writeFileAtomically(record, toJson(run, key));
        logInfo(fmt::format("{}: {}", name, run.failure.empty() ? found(run) : "failed: " + run.failure));
        report_.runs.push_back(std::move(run));
    }

    // The result of an earlier call, measured anew if the references have changed since.
    std::optional<BenchRun> knownRun(const std::string& record, const std::string& key, const std::string& picture,
                                     const BenchScene& scene) {
        if (!fs::exists(record) || !fs::exists(picture)) return {};
        std::optional<BenchRun> known = runFromJson(readFile(record), key);
        if (!known || !known->failure.empty()) return {};
        if (known->measuredAgainst == stateOfReferences(scene)) return known;
        try {
            measurePicture(picture, scene, *known);
        } catch (const Error&) {  // damaged: as if it were not there
            return {};
        }
        writeFileAtomically(record, toJson(*known, key));
        return known;
    }

    // False if it was cancelled.
    bool measure(const BenchMethod& method, const BenchJob& job, const BenchScene& scene, BenchRun& run) {
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
            readTiming(job.timing, run);
            if (!method.adapter()) readOwnMetadata(job.output, run);
            measurePicture(job.output, scene, run);
        } catch (const Error& error) {
            run.failure = lastLine(error.what());
        }
        return true;
    }

    void measurePicture(const std::string& picture, const BenchScene& scene, BenchRun& run) {
        referencesOf(scene).measure(picture, run);
        run.measuredAgainst = stateOfReferences(scene);
    }

    const BenchSettings& s_;
    const CancelToken* cancel_;
    BenchReport report_;
    std::optional<SceneReferences> loaded_;
    std::string loadedFor_;
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
