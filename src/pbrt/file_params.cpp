#include "pbrt/file_params.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace drc::pbrt {

bool namesFile(std::string_view typeName, std::string_view name) {
    constexpr std::array<std::string_view, 6> kNames = {"bsdffile", "emissionfilename", "filename",
                                                        "lensfile", "mapname",          "normalmap"};
    return typeName == "spectrum" || (typeName == "string" && std::ranges::find(kNames, name) != kNames.end());
}

std::string absolutePath(const std::string& name, const SourcePos& pos, const FileSearch& files) {
    try {
        return std::filesystem::absolute(files.find(name, pos, "file")).lexically_normal().string();
    } catch (const Error&) {
        return name;
    }
}

}  // namespace drc::pbrt
