#include "scene/film_output.h"

#include <filesystem>

#include "base/error.h"

namespace drc {

std::vector<std::string> filmOutputs(const RenderSettings& settings) {
    const std::filesystem::path file(settings.outputFile);
    const std::string name = file.filename().string();
    // std::filesystem takes ".exr" for a hidden file without an extension, and returns all of it as the stem.
    if (name.empty() || name == "." || name == ".." || name == ".exr" || name == ".png") {
        const std::string folder = name.starts_with(".") ? "" : file.parent_path().string() + "/";
        throw Error(settings.outputFileAt, "the film's file name '" + settings.outputFile +
                                               "' names no picture: it must end in a file's name, such as '" + folder +
                                               "picture.exr'");
    }
    const std::string stem = file.stem().string();
    return {stem + ".exr", stem + ".png"};
}

}  // namespace drc
