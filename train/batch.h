// Batches of training examples as tensors, encoded for the network (neural/transforms.h).
#pragma once
#include <torch/torch.h>

#include <string>
#include <vector>

#include "dataset.h"
#include "neural/transforms.h"

namespace drc {

// The mean by which a target is scaled: that of the noisy input, or its own.
enum class TargetMean { Own, Input };
TargetMean parseTargetMean(const std::string& name);
std::string targetMeanName(TargetMean mean);

// How examples are encoded; the same for a whole training run.
struct Encoding {
    TargetMean mean = TargetMean::Own;
    Ablation ablation = Ablation::None;
    int planes = kPlainPlanes;  // inputs of the network: kPlainPlanes or kGuidedPlanes
};

struct Batch {
    torch::Tensor input;       // [B][7 or 13][S][S]
    torch::Tensor target;      // [B][3][S][S], encoded; demodulated by albedo if the network sees albedo
    torch::Tensor targetMean;  // [B], the mean by which the target is scaled
    // [B][3][S][S], the factor that turns decoded outputs and targets into radiance; 1 for a network without albedo.
    torch::Tensor factor;
    torch::Tensor radiance;  // [B][3][S][S], noisy input, not encoded; only if requested
    torch::Tensor clean;     // [B][3][S][S], target, not encoded; only if requested
};

// Batches for training. Each epoch visits the data in a new random order, and each visit chooses a random realisation
// and augmentation. A batch depends only on (seed, step), so that an interrupted training resumes exactly.
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

// The examples [first, first + count) of `indices` with realisation 0 and without augmentation, including the radiance
// that is not encoded.
Batch plainBatch(const Dataset& dataset, const std::vector<size_t>& indices, size_t first, size_t count,
                 const Encoding& encoding);

}  // namespace drc
