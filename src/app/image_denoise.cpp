// `drc image denoise`: of a picture, or of the frames of an animation.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <map>
#include <memory>

#include "app/image_denoiser.h"
#include "app/image_output.h"
#include "app/image_subcommands.h"
#include "app/option_checks.h"
#include "app/usage_error.h"
#include "base/distinct_files.h"
#include "base/error.h"
#include "base/frame_pattern.h"
#include "base/log.h"
#include "base/parallel.h"
#include "reconstruct/temporal_filter.h"

namespace drc {
namespace {

struct DenoiseOptions {
    std::string input;
    std::string frames;
    int window = 2;
    ImageDenoiserOptions denoiser;
    int threads = 0;
    ImageOutput output;
};

// The frames around the present one. Each file is read once.
class FrameWindow {
  public:
    FrameWindow(FramePattern files, std::vector<int> numbers, int radius)
        : files_(std::move(files)), numbers_(std::move(numbers)), radius_(radius) {}

    // The noisy picture of a frame, averaged over the window; picture: the frame's file.
    Image colours(size_t index, PictureFile& picture) {
        const size_t first = index - std::min(index, size_t(radius_)),
                     end = std::min(numbers_.size(), index + size_t(radius_) + 1);
        std::erase_if(loaded_, [&](const auto& entry) { return entry.first < first; });
        for (size_t i = first; i < end; ++i) {
            if (loaded_.contains(i)) continue;
            loaded_.emplace(i, temporalFrameOf(readPictureFile(files_.path(numbers_[i]))));
        }
        picture = readPictureFile(files_.path(numbers_[index]));
        std::vector<const TemporalFrame*> neighbours;
        for (size_t i = first; i < end; ++i)
            // A gap in the numbers is a gap in time.
            if (i != index && std::abs(numbers_[i] - numbers_[index]) <= radius_) neighbours.push_back(&loaded_.at(i));
        return filteredOverTime(loaded_.at(index), neighbours).beauty();
    }

  private:
    FramePattern files_;
    std::vector<int> numbers_;
    int radius_;
    std::map<size_t, TemporalFrame> loaded_;  // by index into numbers_
};

void denoiseFrames(const DenoiseOptions& options) {
    if (!options.denoiser.layer.empty()) throw UsageError("--layer: with --frames it is the whole picture");
    const FramePattern inputs("RENDER", options.input), outputs("-o", options.output.path);
    const std::vector<int> numbers = frameNumbers("--frames", options.frames);
    DistinctFiles files;
    for (const int number : numbers) {
        const std::string path = inputs.path(number);
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored))
            throw Error(fmt::format("--frames {}: there is no {}", options.frames, path));
        files.reads(fmt::format("frame {}", number), path);
    }
    for (const int number : numbers) files.writes(fmt::format("-o of frame {}", number), outputs.path(number));
    FrameWindow window(inputs, numbers, options.window);
    const ImageDenoiser denoiser(options.denoiser);
    for (size_t i = 0; i < numbers.size(); ++i) {
        PictureFile picture;
        Image colours = window.colours(i, picture);
        denoiser.denoise(picture, std::move(colours));
        picture.metadata["drc:denoiser"] += fmt::format(", {} frames before and after", options.window);
        ImageOutput output = options.output;
        output.path = outputs.path(numbers[i]);
        writeImageOutput(output, std::move(picture), "");
        logInfo(output.path);
    }
}

void denoise(const DenoiseOptions& options, const CLI::App& command) {
    checkImageOutput(command, options.output);
    setThreadCount(options.threads);
    if (!options.frames.empty()) return denoiseFrames(options);
    if (command.count("--window") > 0) throw UsageError("--window: it needs --frames");
    PictureFile picture = readPictureFile(options.input);
    ImageDenoiser(options.denoiser).denoise(picture);
    writeImageOutput(options.output, std::move(picture), options.denoiser.layer);
}

}  // namespace

void addImageDenoise(CLI::App& image) {
    const auto options = std::make_shared<DenoiseOptions>();
    CLI::App* command = image.add_subcommand("denoise", "Remove the noise of a render by Open Image Denoise");
    command
        ->add_option("RENDER", options->input,
                     "An EXR, best with albedo and normal, as drc render --aovs writes it. With --frames, #### stands "
                     "for the frame's number")
        ->required();
    command
        ->add_option(
            "--frames", options->frames,
            "Frames of an animation, such as 1-24 or 1,3,8-12: each is averaged with its neighbours where they "
            "show the same surfaces in the same light, and then denoised. They need --aovs and no denoiser")
        ->type_name("LIST");
    command
        ->add_option("--window", options->window,
                     "With --frames: how many frames before and after a frame it is averaged with")
        ->capture_default_str()
        ->check(CLI::Range(0, 8));
    addImageOutput(*command, options->output);
    command->add_option("--layer", options->denoiser.layer, "The layer to denoise. Default: the beauty");
    command->add_option(
        "--albedo", options->denoiser.albedo,
        fmt::format("The layer of the surfaces' albedo. Default: {}", fmt::join(albedoLayerNames(), " or ")));
    command->add_option(
        "--normal", options->denoiser.normal,
        fmt::format("The layer of the surfaces' normals. Default: {}", fmt::join(normalLayerNames(), " or ")));
    command->add_option("--quality", options->denoiser.quality, "high, balanced or fast")
        ->capture_default_str()
        ->check(CLI::IsMember({"high", "balanced", "fast"}));
    command
        ->add_option("--prefilter", options->denoiser.prefilter,
                     "on: denoise albedo and normal first; off: use them as they are; clean: they have no noise")
        ->capture_default_str()
        ->check(CLI::IsMember({"on", "off", "clean"}));
    command->add_option("--oidn-library", options->denoiser.library, "As of drc render");
    addThreadsOption(*command, options->threads);
    command->footer(
        "An EXR keeps its other layers as they are. Without albedo and normal, more detail is lost.\n\n"
        "Examples: drc image denoise render.exr -o clean.exr\n"
        "          drc image denoise f_####.exr --frames 1-24 --window 2 -o d_####.exr");
    command->callback([options, command] { denoise(*options, *command); });
}

}  // namespace drc
