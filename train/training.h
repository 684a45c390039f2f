// One training from start to end: Adam with a warm-up and a cosine decay to zero, gradients clipped, and a running
// average of the weights, which is what is validated and exported.
#pragma once
#include <torch/torch.h>

#include <cstdint>
#include <string>

#include "batch.h"
#include "loss.h"
#include "model.h"

namespace drc {

struct TrainingOptions {
    int batch = 32;
    int64_t examples = 500000;    // drawn in total, over all epochs
    double learningRate = 1e-3;   // at its peak
    double warmUp = 0.02;         // share of the steps in which the rate climbs from 0 to its peak
    double clipNorm = 1;          // of the gradient of all parameters; 0: no clipping
    double averageDecay = 0.999;  // of the running average of the weights, a step
    double irradianceWeight = 0;  // see Loss
    uint64_t seed = 1;
    Encoding encoding;
    bool bf16 = false;  // autocast of the forward pass

    int64_t steps() const { return (examples + batch - 1) / batch; }
};

class Training {
  public:
    // Seeds torch's generator; the model starts from random weights.
    Training(const UNetShape& shape, const Dataset& dataset, std::vector<size_t> indices,
             const TrainingOptions& options);

    // Both the model that learns and its average start from these weights.
    void startFrom(const UNetWeights& weights);
    // One batch; returns its loss. The step after done() == options.steps() is an error of the caller.
    double step();
    int64_t done() const { return step_; }
    double learningRate() const;
    Model& average() { return average_; }

    // Everything a resumed training needs to go on as if it had not stopped. load() throws drc::Error if the file is
    // unreadable or was made with other options.
    void save(const std::string& path);
    void load(const std::string& path);

  private:
    torch::Tensor forwardLoss(const Batch& batch);
    void updateAverage();
    std::string signature() const;

    TrainingOptions options_;
    TrainingBatches batches_;
    Loss loss_;
    Model model_, average_;
    torch::optim::Adam optimizer_;
    int64_t step_ = 0;
};

}  // namespace drc
