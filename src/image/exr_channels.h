// Names and order of a picture's channels, collected from the parts of an EXR.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace drc {

struct ExrPartChannels {
    std::string part;                   // its name; files of one part need none
    std::vector<std::string> channels;  // in the file's order: sorted by name
};

struct ExrChannel {
    std::string name;  // in the picture
    size_t part = 0;
    std::string nameInPart;
};

// The channels, layer by layer. Within a layer, "R", "G", "B" ("X", "Y", "Z" of a position) come before all others. A
// part becomes a layer: the channel "Z" of the part "depth" becomes "depth.Z". The beauty part comes first and its
// channels keep their names: it is the first part with "R", "G" and "B" or, if there is none, the first with a "Y". The
// channels of a single part keep their names, too. If two names would be equal, the later one is prefixed by the number
// of its part, as "part2.depth.Z".
struct ExrChannels {
    std::vector<ExrChannel> channels;
    size_t beautyPart = 0;  // the number of parts if there is no beauty
};
ExrChannels exrChannels(const std::vector<ExrPartChannels>& parts);

}  // namespace drc
