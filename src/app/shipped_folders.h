// Where the files that come with the program are.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace drc {

// Where a folder of this name may be, whether or not it is: beside the program, above a build's folder, in share/drc of
// an installation, in the current folder. In this order.
std::vector<std::filesystem::path> shippedFolders(const std::string& name);

}  // namespace drc
