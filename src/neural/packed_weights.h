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
    dnnl::memory bias(const UNetWeights::Conv& conv);

  private:
    std::mutex mutex_;
    std::map<std::string, std::vector<dnnl::memory>> packed_;
};

}  // namespace drc
