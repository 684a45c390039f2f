// The number of a frame in its animation, on which the seed of its samples depends: noise that is the same in all
// frames would stick to the screen.
#pragma once
#include <map>
#include <optional>
#include <string>

namespace drc {

// The number at the end of the scene file's name, before its extension: 7 for frame7.pbrt, shot.0007.pbrt and
// f_007.pbrt.gz. None without one, or if it has more than nine digits, as a time stamp has.
std::optional<int> frameNumberOf(const std::string& scene);

// Watches for frames of a run that have the same number, and so the same noise.
class FrameNumbers {
  public:
    // Logs a warning at the first frame that has the number of an earlier one, or none like an earlier one.
    void add(const std::string& scene);

  private:
    std::map<std::optional<int>, std::string> sceneOf_;
    bool hasWarned_ = false;
};

}  // namespace drc
