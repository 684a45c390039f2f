#include "app/compare_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/compare_sequence.h"
#include "app/image_output.h"
#include "app/option_checks.h"
#include "app/usage_error.h"
#include "base/distinct_files.h"
#include "base/error.h"
#include "base/log.h"
#include "image/difference_image.h"
#include "image/entropy.h"
#include "image/image_io.h"
#include "image/metrics.h"
#include "image/pair_metrics.h"
#include "image/picture_window.h"
#include "render/picture_writer.h"

namespace drc {
namespace {

struct CompareOptions {
    std::vector<std::string> pictures;  // one reference or two, then the test image
    std::string diff;
    std::string signedDiff;
    std::string layer;
    std::string sequence;
    bool json = false;
    float exposure = 0;
};

void warnOfNonFinite(int64_t count, const std::string& path) {
    if (count > 0)
        logWarning(fmt::format("{}: {} pixel(s) are NaN or infinite; all errors and the mean ratio leave them out",
                               path, count));
}

// JSON has no NaN and no infinity: they become null.
nlohmann::ordered_json number(double x) {
    return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(nullptr);
}

// Adds the facts about each picture by itself: the reference, or the mean of both, and the test image.
void addSizes(nlohmann::ordered_json& json, const std::array<double, 2>& pngKb, const Image& reference,
              const Image& test) {
    json["png_kb"] = {number(pngKb[0]), number(pngKb[1])};
    json["entropy"] = {luminanceEntropy(reference), luminanceEntropy(test)};
}

std::string toJson(const Metrics& m, const Image& reference, const Image& test) {
    nlohmann::ordered_json json;
    json["ssim"] = number(m.ssim);
    json["flip"] = number(m.flip);
    json["relmse"] = number(m.relmse);
    json["block_relmse"] = number(m.blockRelmse);
    json["mse"] = number(m.mse);
    json["l1"] = number(m.l1);
    json["mean_ratio"] = {number(m.meanRatio[0]), number(m.meanRatio[1]), number(m.meanRatio[2])};
    addSizes(json, m.pngKb, reference, test);
    return json.dump();
}

std::string toTable(const Metrics& m) {
    std::string table;
    table += fmt::format("SSIM        {:.6f}   1 is equal\n", m.ssim);
    table += fmt::format("FLIP        {:.6f}   0 is equal\n", m.flip);
    table += fmt::format("relMSE      {:.6g}\n", m.relmse);
    table += fmt::format("  of blocks {:.6g}   means of 8x8 pixels\n", m.blockRelmse);
    table += fmt::format("MSE         {:.6g}\n", m.mse);
    table += fmt::format("L1          {:.6g}\n", m.l1);
    table += fmt::format("mean ratio  {:.4f} {:.4f} {:.4f}   R G B, test / reference\n", m.meanRatio[0], m.meanRatio[1],
                         m.meanRatio[2]);
    table += fmt::format("PNG kB      {:.1f} {:.1f}   reference, test\n", m.pngKb[0], m.pngKb[1]);
    return table;
}

std::string toJson(const ReferencePair& pair, const PairMetrics& m, const Image& test) {
    const CrossErrors& e = m.errors;
    nlohmann::ordered_json json;
    json["error"] = number(e.error.mean);
    json["error_se"] = number(e.error.standardError);
    json["trimmed_error"] = number(e.trimmed.mean);
    json["trimmed_error_se"] = number(e.trimmed.standardError);
    json["block_error"] = number(e.block.mean);
    json["block_error_se"] = number(e.block.standardError);
    json["reference_noise"] = number(e.noise);
    json["block_reference_noise"] = number(e.blockNoise);
    json["ssim"] = number(m.ssim);
    json["ssim_noise"] = number(pair.ssimNoise());
    json["ssim_is_noisy"] = m.ssimIsNoisy;
    json["flip"] = number(m.flip);
    json["flip_noise"] = number(pair.flipNoise());
    json["flip_is_noisy"] = m.flipIsNoisy;
    json["mean_ratio"] = {number(e.meanRatio[0]), number(e.meanRatio[1]), number(e.meanRatio[2])};
    addSizes(json, m.pngKb, pair.mean(), test);
    return json.dump();
}

std::string toTable(const ReferencePair& pair, const PairMetrics& m) {
    const CrossErrors& e = m.errors;
    const auto line = [](const char* name, const Estimate& estimate, const char* note) {
        return fmt::format("{:<11} {:.6g} +- {:.2g}   {}\n", name, estimate.mean, estimate.standardError, note);
    };
    const auto noisy = [](bool isNoisy, double noise) {
        return isNoisy ? fmt::format(", of which the references' noise is about {:.2g}: too much to tell", noise) : "";
    };
    std::string table;
    table += line("error", e.error, "without the references' noise");
    table += line("  trimmed", e.trimmed, "without the 0.1 % of pixels that stand out most");
    table += line("  of blocks", e.block, "means of 8x8 pixels");
    table += fmt::format("ref. noise  {:.6g}   of each reference, in the same norm; of blocks {:.6g}\n", e.noise,
                         e.blockNoise);
    table += fmt::format("SSIM        {:.6f}   1 is equal{}\n", m.ssim, noisy(m.ssimIsNoisy, pair.ssimNoise()));
    table += fmt::format("FLIP        {:.6f}   0 is equal{}\n", m.flip, noisy(m.flipIsNoisy, pair.flipNoise()));
    table += fmt::format("mean ratio  {:.4f} {:.4f} {:.4f}   R G B, test / mean of the references\n", e.meanRatio[0],
                         e.meanRatio[1], e.meanRatio[2]);
    table += fmt::format("PNG kB      {:.1f} {:.1f}   mean of the references, test\n", m.pngKb[0], m.pngKb[1]);
    return table;
}

std::string extensionOf(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

// Called before the work, so that a wrong path is reported at once.
void checkDifferencePath(const std::string& path) {
    if (extensionOf(path) != ".png")
        throw UsageError(fmt::format("--diff {}: the differences are written as .png", path));
}

// The test image less the reference, linear: negative where the test image is too dark.
Image signedDifference(const Image& reference, const Image& test) {
    Image difference = test;
    for (size_t i = 0; i < difference.data().size(); ++i) difference.data()[i] -= reference.data()[i];
    return difference;
}

void writeDifferences(const CompareOptions& options, const Image& reference, const Image& test,
                      const ExrWindow& window) {
    if (!options.diff.empty()) writePng(options.diff, differenceImage(reference, test, options.exposure));
    if (!options.signedDiff.empty()) {
        const Image difference = signedDifference(reference, test);
        writeExr(options.signedDiff, {{"", &difference}}, {}, window);
    }
}

struct Compared {
    std::string path;
    Image image;
    ExrWindow window;

    operator PlacedPicture() const { return {path, image, window}; }
};

Compared read(const CompareOptions& options, const std::string& path) {
    if (!options.layer.empty()) {
        const PictureFile file = readPictureFile(path);
        return {path, coloursOf(file, options.layer), file.window};
    }
    const ImageFile file = readImageFile(path);
    return {path, linearRgbOf(file), file.window};
}

void compareWithOne(const CompareOptions& options) {
    const Compared reference = read(options, options.pictures[0]), test = read(options, options.pictures[1]);
    requireSamePlace(reference, test, "compared");
    const Metrics m = compare(reference.image, test.image, options.exposure);
    warnOfNonFinite(m.nonFiniteReference, reference.path);
    warnOfNonFinite(m.nonFiniteTest, test.path);
    fmt::print("{}{}", options.json ? toJson(m, reference.image, test.image) : toTable(m), options.json ? "\n" : "");
    writeDifferences(options, reference.image, test.image, reference.window);
}

void compareWithTwo(const CompareOptions& options) {
    const auto& paths = options.pictures;
    Compared first = read(options, paths[0]), second = read(options, paths[1]);
    const Compared test = read(options, paths[2]);
    requireSamePlace(first, second, "compared");
    requireSamePlace(first, test, "compared");
    const ReferencePair pair(std::move(first.image), std::move(second.image), options.exposure, paths[0], paths[1]);
    const PairMetrics m = pair.compare(test.image, paths[2]);
    for (size_t i = 0; i < paths.size(); ++i) warnOfNonFinite(m.errors.nonFinite[i], paths[i]);
    fmt::print("{}{}", options.json ? toJson(pair, m, test.image) : toTable(pair, m), options.json ? "\n" : "");
    writeDifferences(options, pair.mean(), test.image, test.window);
}

void run(const CompareOptions& options) {
    if (!options.diff.empty()) checkDifferencePath(options.diff);
    if (!options.signedDiff.empty() && extensionOf(options.signedDiff) != ".exr")
        throw UsageError(fmt::format("--signed-diff {}: signed differences are written as .exr", options.signedDiff));
    DistinctFiles files;
    for (const std::string& path : options.pictures) files.reads("the picture", path);
    for (const auto& [option, path] :
         {std::pair("--diff", options.diff), std::pair("--signed-diff", options.signedDiff)})
        if (!path.empty()) {
            files.writes(option, path);
            checkOutput(option, path);
        }
    options.pictures.size() == 2 ? compareWithOne(options) : compareWithTwo(options);
}

void runSequence(const CompareOptions& options) {
    if (options.pictures.size() != 3)
        throw UsageError("--sequence: needs REF1 REF2 TEST, two reference animations of different seeds");
    if (!options.diff.empty() || !options.signedDiff.empty())
        throw UsageError("--sequence: writes no pictures; --diff and --signed-diff are for single ones");
    compareSequence({options.sequence, options.pictures[0], options.pictures[1], options.pictures[2], options.layer,
                     options.exposure, options.json});
}

// own: the command as the user types it.
void addComparison(CLI::App& app, const std::string& name, const std::string& own) {
    const auto options = std::make_shared<CompareOptions>();
    CLI::App* command =
        app.add_subcommand(name, "Measure how far an image is from a reference, or from two of different seeds");
    command
        ->add_option(
            "PICTURE", options->pictures,
            "REF TEST, or REF1 REF2 TEST: references (EXR, PFM, PNG, JPEG, TIFF, HDR, TGA), then the image to judge; "
            "all of one size and, of EXR files, of the same part of the whole")
        ->required()
        ->expected(2, 3);
    command->add_option("--layer", options->layer,
                        "The layer or the channel of EXR files to compare in place of the beauty: direct, or depth.Z");
    command
        ->add_option(
            "--sequence", options->sequence,
            "Compare animations, REF1 REF2 TEST with #### in place of the frames' numbers, and measure flicker. "
            "REF1 was rendered with --aovs")
        ->type_name("LIST");
    command->add_flag(
        "--json", options->json,
        "Print one JSON object. With one reference: ssim, flip, relmse, block_relmse, mse, l1, mean_ratio "
        "[R, G, B], png_kb and entropy [REF, TEST]. With two: error, trimmed_error, block_error, each with _se, its "
        "standard error; reference_noise, block_reference_noise; ssim and flip, each with _noise and "
        "_is_noisy; mean_ratio, png_kb, entropy");
    command->add_option("--diff", options->diff,
                        "Write a PNG: reference | test | 4 |difference| | red where brighter, blue where darker");
    command->add_option("--signed-diff", options->signedDiff,
                        "Write an EXR: the test image less the reference, or less the mean of both, linear");
    command->add_option("--exposure", options->exposure, "Stops by which both are brightened for SSIM, FLIP and PNGs")
        ->capture_default_str()
        ->check(numberIn(-100, 100));
    command->footer(
        "SSIM and FLIP compare displayed colours; relMSE (without the worst 0.1 % of pixels), MSE and L1 compare\n"
        "linear radiance. The relMSE of the means of 8x8 pixels shows errors that noise hides.\n"
        "With two references, rendered with different seeds, the errors are without the references' own noise:\n"
        "the mean of (T - R1)(T - R2) / (D^2 + 0.01), D the references' radiance about the pixel.\n\n"
        "Examples:\n"
        "  " +
        own +
        " reference.exr drc.exr --diff difference.png\n"
        "  " +
        own +
        " seed1.exr seed2.exr drc.exr\n"
        "  " +
        own + " --sequence 1-24 a_####.exr b_####.exr drc_####.exr");
    command->callback([options] { options->sequence.empty() ? run(*options) : runSequence(*options); });
}

}  // namespace

void addCompareCommand(CLI::App& app) { addComparison(app, "compare", "drc compare"); }

void addImageDiff(CLI::App& image) { addComparison(image, "diff", "drc image diff"); }

}  // namespace drc
