// `drc image average`.
#include <fmt/core.h>

#include <cmath>
#include <memory>

#include "app/image_output.h"
#include "app/image_subcommands.h"
#include "base/error.h"
#include "base/log.h"
#include "base/memory.h"
#include "image/picture_window.h"

namespace drc {
namespace {

struct AverageOptions {
    std::vector<std::string> inputs;
    ImageOutput output;
};

void requireFit(const PictureFile& picture, const PictureFile& first) {
    if (picture.image.width() != first.image.width() || picture.image.height() != first.image.height())
        throw Error(fmt::format("{} is {}, but {} is {}: only pictures of one size can be averaged", picture.path,
                                placeString(picture.image, picture.window), first.path,
                                placeString(first.image, first.window)));
    for (const PictureFile* a : {&first, &picture})
        for (const std::string& name : a->image.channelNames())
            if (const PictureFile& b = a == &first ? picture : first; b.image.channelIndex(name) < 0)
                throw Error(fmt::format("{} has no channel {}, which {} has", b.path, name, a->path));
    requireSamePlace({first.path, first.image, first.window}, {picture.path, picture.image, picture.window},
                     "averaged");
}

void average(const AverageOptions& options, const CLI::App& command) {
    checkImageOutput(command, options.output);
    PictureFile mean = readPictureFile(options.inputs[0]);
    const auto channels = size_t(mean.image.channels());
    const MemoryClaim memory(double(mean.image.data().size()) * (sizeof(double) + sizeof(int)), "averaging pictures");
    std::vector<double> sums(mean.image.data().size());
    std::vector<int> counts(sums.size());
    const auto add = [&](const PictureFile& picture) {
        int64_t bad = 0;
        for (size_t c = 0; c < channels; ++c) {
            const auto own = size_t(picture.image.channelIndex(mean.image.channelNames()[c]));
            for (size_t i = 0; i < mean.image.pixelCount(); ++i) {
                const float v = picture.image.data()[i * channels + own];
                if (!std::isfinite(v)) {
                    ++bad;
                    continue;
                }
                sums[i * channels + c] += double(v);
                ++counts[i * channels + c];
            }
        }
        if (bad > 0) logWarning(fmt::format("{}: {} value(s) are NaN or infinite and are left out", picture.path, bad));
    };
    add(mean);
    for (size_t k = 1; k < options.inputs.size(); ++k) {
        const PictureFile picture = readPictureFile(options.inputs[k]);
        requireFit(picture, mean);
        add(picture);
    }
    for (size_t i = 0; i < sums.size(); ++i) mean.image.data()[i] = float(sums[i] / std::max(1, counts[i]));
    // The first file's metadata does not apply to the mean, whose values also need more digits than halves have.
    mean.metadata.clear();
    mean.storage.halfChannels.clear();
    writeImageOutput(options.output, std::move(mean));
}

}  // namespace

void addImageAverage(CLI::App& image) {
    const auto options = std::make_shared<AverageOptions>();
    CLI::App* command = image.add_subcommand("average", "Write the mean of pictures, all of which weigh the same");
    command->add_option("PICTURE", options->inputs, "Pictures of one size and with the same channels")->required();
    addImageOutput(*command, options->output);
    command->footer(
        "Each channel is averaged by itself, in linear light; values that are NaN or infinite are left out. Renders\n"
        "of one scene are better put together by drc image merge, which weighs them by their samples.\n\n"
        "Example: drc image average frame-*.exr -o mean.exr");
    command->callback([options, command] { average(*options, *command); });
}

}  // namespace drc
