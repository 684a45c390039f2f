// A second place for results that cannot be written where the user wanted them.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace drc {

// Writes the bytes to NAME.rescued.EXT, or NAME.rescued-2.EXT and so on, where `path` ends in NAME.EXT: a file that did
// not exist, in the first of the folders in which that is possible. Returns its path; empty if it is possible in none.
std::string writeRescued(const std::string& path, std::string_view bytes, const std::vector<std::string>& folders);

// Where to write a picture that has no room at `path`: there under another name, beside the scene, and in the folder
// for temporary files.
std::vector<std::string> rescueFolders(const std::string& path, const std::string& scene);

}  // namespace drc
