// A training run: Adam with warm-up and cosine decay of the learning rate to zero, gradient clipping, and a running
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
    int64_t examples = 500000;    // total number drawn, over all epochs
    double learningRate = 1e-3;   // peak value
    double warmUp = 0.02;         // share of the steps in which the rate rises linearly from 0 to its peak
    double clipNorm = 1;          // maximum norm of the gradient of all parameters; 0: no clipping
    double averageDecay = 0.999;  // of the running average of the weights, per step
    double irradianceWeight = 0;  // see Loss
    uint64_t seed = 1;
    Encoding encoding;
    bool bf16 = false;  // autocast of the forward pass

    int64_t steps() const { return (examples + batch - 1) / batch; }
};

class Training {
  public:
    // Seeds torch's global generator. The model starts from random weights.
    Training(const UNetShape& shape, const Dataset& dataset, std::vector<size_t> indices,
             const TrainingOptions& options);

    // Initialises both the model and its running average with these weights.
    void startFrom(const UNetWeights& weights);
    // Trains on one batch and returns its loss. Must not be called when done() == options.steps().
    double step();
    int64_t done() const { return step_; }
    double learningRate() const;
    Model& average() { return average_; }

    // Saves and restores the complete state, so that a resumed training continues as if it had not stopped. load()
    // throws drc::Error if the file is unreadable or was made with other options.
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
