// A sequence of oneDNN primitives. Memory layouts are chosen, buffers are planned and arguments are bound before the
// first run.
#pragma once
#include <dnnl.hpp>
#include <vector>

#include "neural/packed_weights.h"

namespace drc {

// Usage: call the layer functions in order of evaluation, then compile() once, then run() any number of times. Not
// thread-safe. run() makes no allocations of its own. The layer functions throw dnnl::error if oneDNN does not support
// the request.
class Graph {
  public:
    using TensorId = int;
    struct ConvOptions {
        int firstIn = 0, countIn = 0;  // the weight's input channels that `source` provides; countIn 0: all
        bool bias = true;
        float slope = 1;      // slope of the activation max(x, slope x): 0 is ReLU, 1 is none
        TensorId addTo = -1;  // if set, the result is added to this tensor in place, before the activation
        bool affine = true;   // apply the scale and shift of the convolution, if it has them
        // Keep the result in float, whatever the type of the other intermediate results.
        bool inFloat = false;
    };

    // type: data type of intermediate results and packed weights. Accumulators and biases are float.
    Graph(PackedWeights& packed, dnnl::memory::data_type type);

    // The network's input: float, NCHW; its memory is passed to run().
    TensorId input(int batch, int channels, int size);
    TensorId conv(TensorId source, const UNetWeights::Conv& conv, const ConvOptions& options);
    TensorId maxPool2(TensorId source);
    TensorId upsample2(TensorId source);  // bilinear, pixel centres at half-integers
    // Declares a result to be the output, which run() writes as float NCHW.
    void output(TensorId source);

    void compile();
    void run(const float* input, float* output);
    size_t arenaBytes() const { return arena_.size() * sizeof(Line); }

  private:
    struct alignas(64) Line {
        std::byte bytes[64];
    };
    struct Tensor {
        dnnl::memory::desc desc;
        int firstStep = -1, lastStep = -1;
        bool external = false;
        dnnl::memory memory;
    };
    struct Step {
        dnnl::primitive primitive;
        dnnl::memory::desc scratchpad;
        std::vector<std::pair<int, TensorId>> tensors;
        std::vector<std::pair<int, dnnl::memory>> constants;
        dnnl::memory scratchpadMemory;
        std::vector<dnnl_exec_arg_t> arguments;
    };
    TensorId addTensor(const dnnl::memory::desc& desc, bool external = false);
    void addStep(Step step);
    TensorId reordered(TensorId source, const dnnl::memory::desc& wanted);
    void reorder(TensorId source, TensorId target);

    PackedWeights& packed_;
    dnnl::memory::data_type type_;
    dnnl::stream stream_;
    dnnl::primitive_attr plainAttributes_;
    std::vector<Tensor> tensors_;
    std::vector<Step> steps_;
    std::vector<Line> arena_;
    TensorId input_ = -1, output_ = -1;
};

}  // namespace drc
