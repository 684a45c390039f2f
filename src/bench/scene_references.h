// What the pictures of a scene are measured against: two independent references, or one.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_result.h"
#include "image/pair_metrics.h"

namespace drc {

// The references that `folder` has of a scene: NAME-1.exr and NAME-2.exr, else NAME.exr. Throws Error if there are
// none, or only one of a pair.
std::vector<std::string> givenReferences(const std::string& folder, const std::string& name);

class SceneReferences {
  public:
    // One path or two. Throws Error, naming the files, on what cannot be read or compared.
    explicit SceneReferences(const std::vector<std::string>& paths);

    // What is shown of them: the one, or the mean of both.
    const Image& shown() const { return pair_ ? pair_->mean() : single_; }
    bool isPair() const { return pair_.has_value(); }
    // Fills in what the report says of them: sizes of the picture that is shown, noise.
    void describe(BenchScene& scene) const;
    // Reads the picture and fills in how far it is from them. Throws Error if it is of another size or no picture.
    void measure(const std::string& picture, BenchRun& run) const;

  private:
    std::optional<ReferencePair> pair_;
    Image single_;
};

}  // namespace drc
