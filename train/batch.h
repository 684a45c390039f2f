// Examples as the tensors that the network sees, on the network's scale (neural/transforms.h).
#pragma once
#include <torch/torch.h>

#include <string>
#include <vector>

#include "dataset.h"
#include "neural/transforms.h"

namespace drc {

// Whose mean scales a target: the noisy input's, or its own.
enum class TargetMean { Own, Input };
TargetMean parseTargetMean(const std::string& name);
std::string targetMeanName(TargetMean mean);

// How examples become tensors, for all of one training.
struct Encoding {
    TargetMean mean = TargetMean::Own;
    Ablation ablation = Ablation::None;
    int planes = kPlainPlanes;  // that the network sees: kPlainPlanes or kGuidedPlanes
};

struct Batch {
    torch::Tensor input;       // [B][7 or 13][S][S]
    torch::Tensor target;      // [B][3][S][S], encoded; over albedo if the network sees that
    torch::Tensor targetMean;  // [B]: the mean that the target was scaled by
    // [B][3][S][S]: what decoded outputs and targets are multiplied by to be radiance; ones for a network that does not
    // see albedos.
    torch::Tensor factor;
    torch::Tensor radiance;  // [B][3][S][S], noisy, not encoded; only if asked for
    torch::Tensor clean;     // [B][3][S][S], not encoded; only if asked for
};

// Drawn examples for training step `step`: the data are gone through in a new order each epoch, each time with a random
// realisation and augmentation. A function of (seed, step) alone, so that an interrupted training resumes exactly.
class TrainingBatches {
  public:
    TrainingBatches(const Dataset& dataset, std::vector<size_t> indices, int batch, uint64_t seed,
                    const Encoding& encoding);
    Batch draw(int64_t step);

  private:
    void shuffle(int64_t epoch);

    const Dataset& dataset_;
    std::vector<size_t> indices_, order_;
    int batch_;
    uint64_t seed_;
    Encoding encoding_;
    int64_t epoch_ = -1;
};

// Examples [first, first + count) of `indices` as they are: realisation 0, no augmentation, with the plain radiance.
Batch plainBatch(const Dataset& dataset, const std::vector<size_t>& indices, size_t first, size_t count,
                 const Encoding& encoding);

}  // namespace drc
