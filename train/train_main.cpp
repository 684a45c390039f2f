// drc-train: trains the map denoiser on shards of examples and writes the weights file that drc loads.
#include <fmt/core.h>
#include <malloc.h>
#include <torch/torch.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "base/error.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "dataset.h"
#include "neural/safetensors.h"
#include "training.h"
#include "validation.h"

namespace drc {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Options {
    std::vector<std::string> data, validationData, validationScenes;
    std::string output, curve, checkpoint, init, commit, command, targetMean = "own", kind = "plain", ablation = "none";
    int width = 32, levels = 4, planes = 0, threads = 0;
    int64_t reportEvery = 20000;
    std::string store = "fp32";
    size_t validationExamples = 512;
    double validationFraction = 0.1;
    TrainingOptions training;
};

void parse(CLI::App& app, Options& o) {
    app.description("Trains the network of Deep Radiance Caching on the shards that `drc reference` writes.");
    app.footer(
        "Example:\n"
        "  drc-train --data data/train --examples 500000 --width 32 --output models/drc.safetensors \\\n"
        "            --checkpoint out/train.ckpt --curve out/train.csv\n"
        "An interrupted run goes on from its checkpoint when the same command is given again.\n"
        "Where other programs use the processor too, set OMP_WAIT_POLICY=passive.");
    TrainingOptions& t = o.training;
    app.add_option("--data", o.data, "Training examples: files that `drc reference` wrote, or folders of them")
        ->required();
    app.add_option("-o,--output", o.output, "The weights file to write");
    app.add_option("--store", o.store, "Number format of the weights file: fp32, or fp16 or bf16 at half the size")
        ->capture_default_str()
        ->check(CLI::IsMember({"fp32", "fp16", "bf16"}));
    app.add_option("--init", o.init, "Weights to start from; with --examples 0 they are only evaluated");
    app.add_option("--examples", t.examples, "Total number of examples to draw")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
    app.add_option("--batch", t.batch, "Examples per step")->capture_default_str()->check(CLI::PositiveNumber);
    app.add_option("--kind", o.kind, "The network's blocks: plain, residual, separable or paper")
        ->capture_default_str();
    app.add_option("--width", o.width, "Channels of the first level")->capture_default_str()->check(CLI::Range(1, 512));
    app.add_option("--levels", o.levels, "Levels of the network")->capture_default_str()->check(CLI::Range(1, 6));
    app.add_option("--planes", o.planes,
                   "7: radiance, normals and distance, as the paper; 13: and albedos and direct light. By default "
                   "7 for the paper's network, 13 for others")
        ->check(CLI::IsMember({kPlainPlanes, kGuidedPlanes}));
    app.add_option("--lr", t.learningRate, "Peak learning rate")->capture_default_str()->check(CLI::PositiveNumber);
    app.add_option("--irradiance", t.irradianceWeight, "Weight of the irradiance error in the loss")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
    app.add_option("--clip", t.clipNorm, "Maximum norm of the gradient; 0: no clipping")->capture_default_str();
    app.add_option("--average", t.averageDecay, "Decay of the running average of the weights")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("--seed", t.seed, "Seed of all random numbers")->capture_default_str();
    app.add_option("--target-mean", o.targetMean, "Mean by which a target is scaled")
        ->capture_default_str()
        ->check(CLI::IsMember({"own", "input"}));
    app.add_option("--ablate", o.ablation, "Inputs hidden from the network: none, normals, distance or both")
        ->capture_default_str();
    app.add_option("--validation-data", o.validationData, "Folders of examples to validate on");
    app.add_option("--validation-scenes", o.validationScenes, "Scenes of --data to validate on (comma-separated)")
        ->delimiter(',');
    app.add_option("--validation-fraction", o.validationFraction,
                   "Otherwise, the share of scenes to validate on, chosen by hashing their names")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 0.9));
    app.add_option("--validation-examples", o.validationExamples,
                   "Maximum number of validation examples, spread evenly")
        ->capture_default_str();
    app.add_option("--report-every", o.reportEvery, "Examples between two validations")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--curve", o.curve, "CSV file of the losses during training; train/plot-curve draws it");
    app.add_option("--checkpoint", o.checkpoint, "File to save the state to every minute, and to resume from");
    app.add_option("--threads", o.threads, "Threads; 0: all")->capture_default_str()->check(CLI::NonNegativeNumber);
    app.add_option("--commit", o.commit, "Commit of the source code, recorded in the weights file");
    app.add_flag("--bf16", t.bf16, "Train in bf16 where possible");
}

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// An evenly spaced subset, because neighbours in a shard are similar.
std::vector<size_t> thinned(const std::vector<size_t>& indices, size_t most) {
    if (indices.size() <= most) return indices;
    std::vector<size_t> some;
    for (size_t i = 0; i < most; ++i) some.push_back(indices[i * indices.size() / most]);
    return some;
}

// Continues the curve of an interrupted run; rows after the checkpoint are dropped.
std::ofstream openCurve(const std::string& path, int64_t resumedAt) {
    std::string kept =
        "examples,seconds,learning_rate,train_log_l1,val_log_l1,val_intensity_l1,val_irradiance,noisy_log_l1,gaussian_"
        "log_l1\n";
    if (resumedAt > 0) {
        std::ifstream old(path);
        std::string line;
        std::getline(old, line);
        while (std::getline(old, line))
            if (std::atoll(line.c_str()) <= resumedAt) kept += line + "\n";
    }
    std::ofstream out(path);
    if (!out) throw Error(SourceLocation{path}, "cannot write");
    out << kept;
    return out;
}

void exportWeights(const Options& o, const Training& training, Model& model, const Dataset& dataset,
                   const Validation& v) {
    const StringMap provenance{{"projection", projectionName(dataset.projection())},
                               {"target_mean", o.targetMean},
                               {"ablation", o.ablation},
                               {"data", fmt::format("{} examples of {} scenes, content {}", dataset.size(),
                                                    dataset.scenes().size(), dataset.contentHash())},
                               {"examples_drawn", std::to_string(training.done() * o.training.batch)},
                               {"seed", std::to_string(o.training.seed)},
                               {"validation", fmt::format("log L1 {:.5f}, noisy {:.5f}, Gaussian {:.5f}", v.network.log,
                                                          v.none.log, v.gaussian.log)},
                               {"command", o.command},
                               {"commit", o.commit}};
    const DType type = o.store == "fp16" ? DType::F16 : o.store == "bf16" ? DType::BF16 : DType::F32;
    model->weights()->save(o.output, provenance, type);
    logInfo(fmt::format("wrote {}", o.output));
}

int run(Options o) {
    at::set_num_threads(o.threads > 0 ? o.threads : int(std::max(1u, std::thread::hardware_concurrency())));
    if (o.output.empty() && o.training.examples > 0) throw Error("--output is missing: where to write the weights?");

    if (!o.validationData.empty()) {
        const auto scenes = Dataset(o.validationData).scenes();
        o.validationScenes.insert(o.validationScenes.end(), scenes.begin(), scenes.end());
        o.data.insert(o.data.end(), o.validationData.begin(), o.validationData.end());
    }
    const Dataset dataset(o.data);
    const Split split = splitByScene(dataset, o.validationScenes, o.validationFraction);
    const auto validation = thinned(split.validation, o.validationExamples);
    logInfo(fmt::format("{} examples of {} scenes ({} shards skipped): {} for training, {} for validation ({} used)",
                        dataset.size(), dataset.scenes().size(), dataset.skippedShards(), split.training.size(),
                        split.validation.size(), validation.size()));

    UNetShape shape;
    shape.kind = parseUNetKind(o.kind);
    shape.width = o.width;
    shape.levels = o.levels;
    shape.size = dataset.mapSize();
    shape.inputs = o.planes > 0 ? o.planes : shape.kind == UNetKind::Paper ? kPlainPlanes : kGuidedPlanes;
    std::shared_ptr<const UNetWeights> init;
    if (!o.init.empty()) {
        init = UNetWeights::load(o.init);
        shape = init->shape();
        if (shape.size != dataset.mapSize())
            throw Error(SourceLocation{o.init},
                        fmt::format("the weights are for maps of {}x{}, the data have {}x{}", shape.size, shape.size,
                                    dataset.mapSize(), dataset.mapSize()));
    }
    if (shape.size % (1 << (shape.levels - 1)) != 0)
        throw Error(
            fmt::format("maps of {0}x{0} cannot be halved {1} times: lower --levels", shape.size, shape.levels - 1));
    o.training.encoding = {parseTargetMean(o.targetMean), parseAblation(o.ablation), shape.inputs};
    Training training(shape, dataset, split.training, o.training);
    if (init) training.startFrom(*init);
    if (!o.checkpoint.empty() && std::filesystem::exists(o.checkpoint)) {
        training.load(o.checkpoint);
        logInfo(fmt::format("resumed at example {}", training.done() * o.training.batch));
    }

    const auto check = [&] { return validate(training.average(), dataset, validation, o.training.encoding); };
    Validation v = check();
    if (!validation.empty())
        logInfo(fmt::format(
            "validation, log L1 (intensity L1): noisy {:.4f} ({:.3f}), Gaussian {:.4f} ({:.3f}), "
            "network {:.4f} ({:.3f})",
            v.none.log, v.none.intensity, v.gaussian.log, v.gaussian.intensity, v.network.log, v.network.intensity));
    if (o.training.examples == 0) {
        if (!o.output.empty()) exportWeights(o, training, training.average(), dataset, v);
        return 0;
    }

    std::ofstream curve;
    if (!o.curve.empty()) curve = openCurve(o.curve, training.done() * o.training.batch);
    installInterruptHandler();
    const int64_t steps = o.training.steps(), reportSteps = std::max<int64_t>(1, o.reportEvery / o.training.batch);
    const auto start = Clock::now();
    auto lastSave = start;
    double lossSum = 0, trainingSeconds = 0;
    int64_t lossCount = 0, stepsHere = 0;
    while (training.done() < steps && !interruptToken().cancelled()) {
        const double rate = training.learningRate();
        const auto stepStart = Clock::now();
        lossSum += training.step();
        trainingSeconds += secondsSince(stepStart);
        ++lossCount, ++stepsHere;
        if (training.done() % reportSteps == 0 || training.done() == steps) {
            v = check();
            const int64_t examples = training.done() * o.training.batch;
            const double perSecond = double(stepsHere) * o.training.batch / trainingSeconds;
            logInfo(
                fmt::format("{:>9} examples, {:.0f}/s, {:.0f} min left: train {:.4f}, validation {:.4f} "
                            "(noisy {:.4f}, Gaussian {:.4f}), intensity {:.3f} (noisy {:.3f}, Gaussian {:.3f}), "
                            "irradiance {:.4f} ({:.4f}, {:.4f})",
                            examples, perSecond, double(steps - training.done()) * o.training.batch / perSecond / 60,
                            lossSum / double(lossCount), v.network.log, v.none.log, v.gaussian.log, v.network.intensity,
                            v.none.intensity, v.gaussian.intensity, v.network.irradiance, v.none.irradiance,
                            v.gaussian.irradiance));
            if (curve.is_open())
                curve << fmt::format("{},{:.1f},{:.3g},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", examples,
                                     secondsSince(start), rate, lossSum / double(lossCount), v.network.log,
                                     v.network.intensity, v.network.irradiance, v.none.log, v.gaussian.log)
                      << std::flush;
            lossSum = 0, lossCount = 0;
        }
        if (!o.checkpoint.empty() && secondsSince(lastSave) >= 60) {
            training.save(o.checkpoint);
            lastSave = Clock::now();
        }
    }
    if (!o.checkpoint.empty()) training.save(o.checkpoint);
    if (interruptToken().cancelled()) {
        logInfo(fmt::format("interrupted at example {}", training.done() * o.training.batch));
        v = check();
    }
    exportWeights(o, training, training.average(), dataset, v);
    return 0;
}

}  // namespace
}  // namespace drc

int main(int argc, char** argv) {
    // Each step allocates what the step before freed. By default glibc returns large blocks to the system, and each
    // step has to fault them in again, which took 3 to 13 % of the time.
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    CLI::App app;
    drc::Options options;
    for (int i = 0; i < argc; ++i) options.command += (i ? " " : "") + std::string(i ? argv[i] : "drc-train");
    drc::parse(app, options);
    CLI11_PARSE(app, argc, argv);
    try {
        return drc::run(options);
    } catch (const std::exception& error) {
        drc::logError(error.what());
        return 1;
    }
}
