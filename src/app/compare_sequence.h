// `drc compare --sequence`: how far the frames of an animation are from two references, and how much they flicker.
#pragma once
#include <string>

namespace drc {

struct SequenceComparison {
    std::string frames;               // list of numbers
    std::string first, second, test;  // file names with # in place of the number
    std::string layer;                // empty: the beauty
    float exposure = 0;               // stops beyond those that show the first frame's references best
    bool json = false;
};

// Prints the result to standard output. Throws Error if a file is missing or unfit.
void compareSequence(const SequenceComparison& options);

}  // namespace drc
