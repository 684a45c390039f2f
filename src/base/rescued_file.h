// A fallback location for results that cannot be written where the user wanted them.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace drc {

// Writes the bytes to a new file in the first of the folders that allows it: NAME.rescued.EXT, or NAME.rescued-2.EXT
// and so on, where `path` ends in NAME.EXT. Returns the file's path; empty if no folder allows it.
std::string writeRescued(const std::string& path, std::string_view bytes, const std::vector<std::string>& folders);

// Folders for a picture that cannot be written to `path`: the same folder (under another name), the scene's folder, and
// the folder for temporary files.
std::vector<std::string> rescueFolders(const std::string& path, const std::string& scene);

}  // namespace drc
