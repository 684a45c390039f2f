// The U-Net of neural/unet_shape.h as a libtorch module, and conversion to and from the renderer's weights.
#pragma once
#include <torch/torch.h>

#include <memory>
#include <vector>

#include "neural/unet_weights.h"

namespace drc {

class ModelImpl : public torch::nn::Module {
  public:
    // He initialisation for LeakyReLU. The last layer's bias starts near the mean of a target. Uses torch's global
    // generator.
    explicit ModelImpl(const UNetShape& shape);

    // [B][shape.inputs][S][S] -> [B][3][S][S]. During training the final ReLU is left out, since its gradient is zero
    // where it is closed. Targets are never negative, so applying it afterwards only reduces the error.
    torch::Tensor forward(torch::Tensor x);

    const UNetShape& shape() const { return shape_; }
    void setWeights(const UNetWeights& weights);
    std::shared_ptr<const UNetWeights> weights() const;
    // Copies the running means and variances of batch normalisations, which are not parameters.
    void copyStatistics(const ModelImpl& other);

  private:
    UNetShape shape_;
    torch::Tensor inputScale_;
    std::vector<bool> seesInput_;  // for each convolution, whether it takes the network's input
    // As shape_.convs(). The normalisation is exported as the convolution's scale and shift; null if there is none.
    std::vector<torch::nn::Conv2d> convs_;
    std::vector<torch::nn::BatchNorm2d> norms_;
};
TORCH_MODULE(Model);

}  // namespace drc
