// Names beside those that the user gave, for pictures that may not or cannot take their place.
#pragma once
#include <string>

namespace drc {

// FOLDER/NAME.WORD.EXT, or FOLDER/NAME.WORD-NUMBER.EXT from the second on, where `path` ends in NAME.EXT. NAME is cut
// where the file's name would be longer than a file system takes.
std::string numberedPath(const std::string& folder, const std::string& path, const std::string& word, int number);

}  // namespace drc
