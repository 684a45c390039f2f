#include "app/compare_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "base/error.h"
#include "base/log.h"
#include "image/difference_image.h"
#include "image/image_io.h"
#include "image/metrics.h"

namespace drc {
namespace {

struct CompareOptions {
    std::string reference, test, diff;
    bool json = false;
    float exposure = 0;
};

void warnOfNonFinite(int64_t count, const std::string& path) {
    if (count > 0)
        logWarning(fmt::format("{}: {} pixel(s) are NaN or infinite; relMSE, MSE, L1 and the mean ratio leave them out",
                               path, count));
}

// JSON has no NaN and no infinity: they become null.
nlohmann::ordered_json number(double x) {
    return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(nullptr);
}

std::string toJson(const Metrics& m) {
    nlohmann::ordered_json json;
    json["ssim"] = number(m.ssim);
    json["flip"] = number(m.flip);
    json["relmse"] = number(m.relmse);
    json["block_relmse"] = number(m.blockRelmse);
    json["mse"] = number(m.mse);
    json["l1"] = number(m.l1);
    json["mean_ratio"] = {number(m.meanRatio[0]), number(m.meanRatio[1]), number(m.meanRatio[2])};
    json["png_kb"] = {number(m.pngKb[0]), number(m.pngKb[1])};
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

void run(const CompareOptions& options) {
    const Image reference = readLinearRgb(options.reference), test = readLinearRgb(options.test);
    if (reference.width() != test.width() || reference.height() != test.height())
        throw Error(fmt::format("the images differ in size: {} is {}, {} is {}", options.reference,
                                sizeString(reference), options.test, sizeString(test)));
    const Metrics m = compare(reference, test, options.exposure);
    warnOfNonFinite(m.nonFiniteReference, options.reference);
    warnOfNonFinite(m.nonFiniteTest, options.test);
    if (!options.diff.empty()) writePng(options.diff, differenceImage(reference, test, options.exposure));
    fmt::print("{}{}", options.json ? toJson(m) : toTable(m), options.json ? "\n" : "");
}

}  // namespace

void addCompareCommand(CLI::App& app) {
    const auto options = std::make_shared<CompareOptions>();
    CLI::App* command = app.add_subcommand("compare", "Measure how far an image is from a reference");
    command->add_option("REF", options->reference, "Reference image (EXR, PFM, PNG, JPEG, HDR, TGA)")->required();
    command->add_option("TEST", options->test, "Image to judge, of the same size")->required();
    command->add_flag("--json", options->json,
                      "Print one JSON object: ssim, flip, relmse, block_relmse, mse, l1, mean_ratio [R, G, B], png_kb "
                      "[REF, TEST]");
    command->add_option("--diff", options->diff,
                        "Write a PNG: reference | test | 4 |difference| | red where brighter, blue where darker");
    command->add_option("--exposure", options->exposure, "Stops by which both are brightened for SSIM, FLIP and PNGs")
        ->capture_default_str()
        ->check(CLI::Range(-100.f, 100.f));
    command->footer(
        "SSIM and FLIP compare displayed colours; relMSE (without the worst 0.1 % of pixels), MSE and L1 compare\n"
        "linear radiance. The relMSE of the means of 8x8 pixels shows errors that noise hides.\n\n"
        "Example:\n"
        "  drc compare reference.exr drc.exr --diff difference.png");
    command->callback([options] { run(*options); });
}

}  // namespace drc
