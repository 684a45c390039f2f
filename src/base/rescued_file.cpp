#include "base/rescued_file.h"

#include <filesystem>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/numbered_path.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::string writeRescued(const std::string& path, std::string_view bytes, const std::vector<std::string>& folders) {
    for (const std::string& folder : folders) {
        try {
            std::error_code ignored;
            for (int number = 1;; ++number) {
                const std::string file = numberedPath(folder, path, "rescued", number);
                // Never overwrite an existing entry, not even a link whose target does not exist.
                if (fs::exists(fs::symlink_status(file, ignored))) continue;
                writeFileAtomically(file, bytes);
                return file;
            }
        } catch (const Error&) {  // the next folder may have room
        }
    }
    return "";
}

std::vector<std::string> rescueFolders(const std::string& path, const std::string& scene) {
    std::error_code failure;
    std::vector<std::string> folders{fs::path(path).parent_path().string(), fs::path(scene).parent_path().string()};
    const fs::path temporary = fs::temp_directory_path(failure);
    if (!failure) folders.push_back(temporary.string());
    return folders;
}

}  // namespace drc
