// The U-Net of neural/unet_shape.h as a libtorch module, and its weights as the renderer's.
#pragma once
#include <torch/torch.h>

#include <memory>
#include <vector>

#include "neural/unet_weights.h"

namespace drc {

class ModelImpl : public torch::nn::Module {
  public:
    // He initialisation for LeakyReLU; the last layer starts near the mean of a target. Uses torch's global generator.
    explicit ModelImpl(const UNetShape& shape);

    // [B][shape.inputs][S][S] -> [B][3][S][S]. Without the final ReLU while it learns: where a ReLU is closed nothing
    // can be learnt, and as targets are never negative, closing it later only brings an output nearer to its target.
    torch::Tensor forward(torch::Tensor x);

    const UNetShape& shape() const { return shape_; }
    void setWeights(const UNetWeights& weights);
    std::shared_ptr<const UNetWeights> weights() const;
    // Takes over the running means and variances of normalisations, which are no parameters.
    void copyStatistics(const ModelImpl& other);

  private:
    UNetShape shape_;
    torch::Tensor inputScale_;
    std::vector<bool> seesInput_;  // of each convolution: whether it takes the network's input
    // As shape_.convs(). A convolution's scale and shift are what its normalisation is at rest; null if it has none.
    std::vector<torch::nn::Conv2d> convs_;
    std::vector<torch::nn::BatchNorm2d> norms_;
};
TORCH_MODULE(Model);

}  // namespace drc
