// Alternative names beside the user's, for pictures that cannot or must not be written under the user's name.
#pragma once
#include <string>

namespace drc {

// Where `path` ends in NAME.EXT: FOLDER/NAME.WORD.EXT, or FOLDER/NAME.WORD-NUMBER.EXT if number > 1. NAME is shortened
// if the file name would be too long for the file system.
std::string numberedPath(const std::string& folder, const std::string& path, const std::string& word, int number);

}  // namespace drc
