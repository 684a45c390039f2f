// Finds the files that come with the program.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace drc {

// The places where a folder of this name may be, whether or not it exists: beside the program, above a build folder, in
// share/drc of an installation, in the current folder; in this order.
std::vector<std::filesystem::path> shippedFolders(const std::string& name);

}  // namespace drc
