#include "app/shipped_folders.h"

namespace drc {

std::vector<std::filesystem::path> shippedFolders(const std::string& name) {
    std::error_code ignored;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    return {(program / name).lexically_normal(), (program / "../.." / name).lexically_normal(),
            (program / "../share/drc" / name).lexically_normal(), name};
}

}  // namespace drc
