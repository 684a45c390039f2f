// File names of the frames of an animation: "shot.####.exr" with the numbers 1-24.
#pragma once
#include <string>
#include <vector>

namespace drc {

class FramePattern {
  public:
    // option: names the pattern in messages. Throws Error unless the last part of the path has one run of #.
    FramePattern(const std::string& option, const std::string& pattern);
    // The path of a frame, whose number has at least as many digits as there are #.
    std::string path(int number) const;

  private:
    std::string before_, after_;
    size_t digits_;
};

// The numbers of a list such as "1-24" or "1,3,8-12", ascending. Throws Error, naming the option, if it is malformed,
// if a number repeats or is negative, or if there are more than a million.
std::vector<int> frameNumbers(const std::string& option, const std::string& list);

}  // namespace drc
