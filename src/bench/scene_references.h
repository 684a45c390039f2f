// The references that a scene's pictures are compared with: two independent ones, or one.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_result.h"
#include "image/pair_metrics.h"

namespace drc {

// The references of a scene in `folder`: NAME-1.exr and NAME-2.exr, else NAME.exr. Throws Error if there are none, or
// only one of a pair.
std::vector<std::string> givenReferences(const std::string& folder, const std::string& name);

class SceneReferences {
  public:
    // Takes one path or two. Throws Error, naming the files, if they cannot be read or compared.
    explicit SceneReferences(const std::vector<std::string>& paths);

    // The picture to show: the only reference, or the mean of both.
    const Image& shown() const { return pair_ ? pair_->mean() : single_; }
    bool isPair() const { return pair_.has_value(); }
    // Fills in what the report says about them: the picture's size and file sizes, and the noise.
    void describe(BenchScene& scene) const;
    // Reads a picture and fills in its errors. Throws Error if it has another size or is not a picture.
    void measure(const std::string& picture, BenchRun& run) const;

  private:
    std::optional<ReferencePair> pair_;
    Image single_;
};

}  // namespace drc
