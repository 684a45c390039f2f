// `drc image merge`.
#include <memory>

#include "app/image_output.h"
#include "app/image_subcommands.h"
#include "image/render_merger.h"

namespace drc {
namespace {

struct MergeOptions {
    std::vector<std::string> inputs;
    ImageOutput output;
};

void merge(const MergeOptions& options, const CLI::App& command) {
    checkImageOutput(command, options.output);
    RenderMerger merger;
    for (const std::string& path : options.inputs) merger.add(readPictureFile(path));
    writeImageOutput(options.output, merger.merged());
}

}  // namespace

void addImageMerge(CLI::App& image) {
    const auto options = std::make_shared<MergeOptions>();
    CLI::App* command =
        image.add_subcommand("merge", "Merge renders of one scene with different seeds, weighted by their samples");
    command->add_option("RENDER", options->inputs, "EXR files of drc render, each with a --seed of its own")
        ->required()
        ->expected(2, 100000);
    addImageOutput(*command, options->output);
    command->footer(
        "Pixels are weighted by the layer \"Debug Sample Count\", which --aovs writes, else by the samples that the\n"
        "metadata names (drc:spp). Variances are combined, so that the result can be merged again and denoised.\n"
        "Renders should not be denoised before (--denoise off).\n\n"
        "Example:\n"
        "  drc render scene.pbrt --seed 1 --aovs --denoise off -o 1.exr\n"
        "  drc render scene.pbrt --seed 2 --aovs --denoise off -o 2.exr\n"
        "  drc image merge 1.exr 2.exr -o both.exr && drc image denoise both.exr -o clean.exr");
    command->callback([options, command] { merge(*options, *command); });
}

}  // namespace drc
