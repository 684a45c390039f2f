// The names and the order of the channels that the parts of an EXR have together.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace drc {

struct ExrPartChannels {
    std::string part;                   // its name; files of one part need none
    std::vector<std::string> channels;  // as the file has them, sorted by name
};

struct ExrChannel {
    std::string name;  // in the picture
    size_t part = 0;
    std::string nameInPart;
};

// Layer by layer and, within each, with "R", "G", "B" ("X", "Y", "Z" of a position) before all others. A part is a
// layer: the channel "Z" of the part "depth" becomes "depth.Z". The beauty keeps its names, and comes first: it is the
// first part that has "R", "G" and "B" or, if there is none, the first with a "Y". Of a single part all names stay.
// Where two names would be the same, the later one gets the number of its part before it, as "part2.depth.Z".
struct ExrChannels {
    std::vector<ExrChannel> channels;
    size_t beautyPart = 0;  // the number of parts if none is the beauty
};
ExrChannels exrChannels(const std::vector<ExrPartChannels>& parts);

}  // namespace drc
