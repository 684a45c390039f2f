// Weights in the layouts that oneDNN's convolutions ask for, made once and shared by all networks that run them.
#pragma once
#include <dnnl.hpp>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "neural/unet_weights.h"

namespace drc {

class PackedWeights {
  public:
    // Input channels [firstIn, firstIn + countIn) of a convolution's weight, in the layout and type of `wanted`.
    dnnl::memory weight(const UNetWeights::Conv& conv, int firstIn, int countIn, const dnnl::memory::desc& wanted);
    // Arrays of a number a channel; they are the key, so they must be those of the weights.
    dnnl::memory perChannel(const std::vector<float>& values, const dnnl::memory::desc& wanted);

  private:
    std::mutex mutex_;
    std::map<std::string, std::vector<dnnl::memory>> packed_;
    std::map<const float*, dnnl::memory> channels_;
};

}  // namespace drc
