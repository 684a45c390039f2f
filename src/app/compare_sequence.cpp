#include "app/compare_sequence.h"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/image_output.h"
#include "app/usage_error.h"
#include "base/error.h"
#include "base/frame_pattern.h"
#include "image/display.h"
#include "image/flicker.h"
#include "image/picture_window.h"
#include "image/relative_norm.h"

namespace drc {
namespace {

// One frame of all three animations.
struct Frame {
    FrameSurfaces surfaces;
    Image first, second, test;
};

Frame readFrame(const SequenceComparison& options, int number) {
    const auto read = [&](const char* what, const std::string& pattern) {
        const std::string path = FramePattern(what, pattern).path(number);
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored))
            throw Error(fmt::format("--sequence {}: there is no {}", options.frames, path));
        return readPictureFile(path);
    };
    const PictureFile first = read("REF1", options.first), second = read("REF2", options.second),
                      test = read("TEST", options.test);
    const auto placed = [](const PictureFile& file) { return PlacedPicture{file.path, file.image, file.window}; };
    requireSamePlace(placed(first), placed(second), "compared");
    requireSamePlace(placed(first), placed(test), "compared");
    return {frameSurfacesOf(first), coloursOf(first, options.layer), coloursOf(second, options.layer),
            coloursOf(test, options.layer)};
}

float bestExposure(const Frame& frame) {
    Image mean = frame.first;
    for (size_t i = 0; i < mean.data().size(); ++i) mean.data()[i] = (mean.data()[i] + frame.second.data()[i]) / 2;
    return exposureOf({.autoExposure = true}, mean);
}

struct Result {
    Flicker flicker;
    Estimate error, blockError;  // of the frames by themselves
};

Result measure(const SequenceComparison& options, const std::vector<int>& numbers) {
    std::vector<Flicker> pairs;
    Result result{{}, {0, 0}, {0, 0}};
    std::optional<Frame> last;
    float exposure = 0;
    for (const int number : numbers) {
        Frame frame = readFrame(options, number);
        const CrossErrors errors =
            crossErrors(frame.first, frame.second, relativeNorm(frame.first, frame.second), frame.test);
        const auto add = [&](Estimate& sum, const Estimate& one) {
            sum.mean += one.mean / double(numbers.size());
            sum.standardError = std::hypot(sum.standardError, one.standardError / double(numbers.size()));
        };
        add(result.error, errors.error);
        add(result.blockError, errors.block);
        if (last)
            pairs.push_back(
                flickerBetween({last->surfaces, frame.surfaces, last->first, frame.first, last->second, frame.second},
                               last->test, frame.test, exposure));
        else
            exposure = bestExposure(frame) + options.exposure;
        last = std::move(frame);
    }
    result.flicker = meanFlicker(pairs);
    return result;
}

nlohmann::ordered_json jsonNumber(double x) {
    return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(nullptr);
}

void printJson(const Result& result) {
    nlohmann::ordered_json json;
    const auto add = [&](const std::string& name, const Estimate& estimate) {
        json[name] = jsonNumber(estimate.mean);
        json[name + "_se"] = jsonNumber(estimate.standardError);
    };
    add("flicker", result.flicker.pixels);
    add("block_flicker", result.flicker.blocks);
    json["median_step"] = jsonNumber(result.flicker.medianStep);
    json["percentile_99_step"] = jsonNumber(result.flicker.percentile99);
    json["compared"] = jsonNumber(result.flicker.compared);
    add("error", result.error);
    add("block_error", result.blockError);
    fmt::print("{}\n", json.dump());
}

void printTable(const Result& result) {
    const auto line = [](const char* name, const Estimate& estimate, const char* note) {
        fmt::print("{:<12} {:.6g} +- {:.2g}   {}\n", name, estimate.mean, estimate.standardError, note);
    };
    line("flicker", result.flicker.pixels, "error of what changes from frame to frame, without the references' noise");
    line("  of blocks", result.flicker.blocks, "means of 8x8 pixels");
    fmt::print(
        "steps        {:.3g}, {:.3g}   median and 99th percentile, in 1/255 of the display, light that changes "
        "included\n",
        result.flicker.medianStep, result.flicker.percentile99);
    fmt::print("compared     {:.1f} %   of the pixels, which both frames show\n", 100 * result.flicker.compared);
    line("error", result.error, "of the frames by themselves");
    line("  of blocks", result.blockError, "means of 8x8 pixels");
}

}  // namespace

void compareSequence(const SequenceComparison& options) {
    const std::vector<int> numbers = frameNumbers("--sequence", options.frames);
    if (numbers.size() < 2) throw UsageError("--sequence: an animation has at least two frames");
    const Result result = measure(options, numbers);
    options.json ? printJson(result) : printTable(result);
}

}  // namespace drc
