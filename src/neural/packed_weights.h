// Weights in the memory layouts that oneDNN's convolutions choose. Each layout is made once and shared by all networks
// that use it.
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
    // Input channels [firstIn, firstIn + countIn) of a convolution's weight, in the layout and data type of `wanted`.
    dnnl::memory weight(const UNetWeights::Conv& conv, int firstIn, int countIn, const dnnl::memory::desc& wanted);
    // A per-channel array (bias, scale or shift). `values` must be the array in the weights itself, because its address
    // is the cache key.
    dnnl::memory perChannel(const std::vector<float>& values, const dnnl::memory::desc& wanted);

  private:
    std::mutex mutex_;
    std::map<std::string, std::vector<dnnl::memory>> packed_;
    std::map<const float*, dnnl::memory> channels_;
};

}  // namespace drc
