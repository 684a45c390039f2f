#include "app/command.h"
#include "app/compare_command.h"
#include "app/image_subcommands.h"

namespace drc {

void addImageCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("image", "Convert, compare, denoise and merge pictures, or say what they are");
    command->require_subcommand(1);
    addImageConvert(*command);
    addImageDiff(*command);
    addImageAverage(*command);
    addImageInfo(*command);
    addImageDenoise(*command);
    addImageMerge(*command);
    addImageSplit(*command);
    command->footer(
        "Pictures are EXR, PNG, JPEG, TIFF, TGA, Radiance HDR or PFM files; all but TIFF and TGA files are written.\n"
        "drc image SUBCOMMAND --help lists its options.\n\n"
        "Examples:\n"
        "  drc image convert render.exr -o render.png --auto-exposure --view agx\n"
        "  drc image merge seed-0.exr seed-1.exr -o both.exr\n"
        "  drc image denoise both.exr -o clean.exr\n"
        "  drc image split noisy.exr clean.exr -o before-after.png");
}

}  // namespace drc
