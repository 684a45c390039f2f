// A chain of oneDNN primitives whose layouts are chosen, memory planned and arguments bound before the first run.
#pragma once
#include <dnnl.hpp>
#include <vector>

#include "neural/packed_weights.h"

namespace drc {

// Build with the layer functions, in the order of evaluation, then compile() once, then run() as often as wanted.
// Not thread-safe; allocates nothing of its own in run(). dnnl::error leaves the layer functions if oneDNN cannot do
// what is asked.
class Graph {
  public:
    using TensorId = int;
    struct ConvOptions {
        int firstIn = 0, countIn = 0;  // which of the weight's input channels `source` holds; countIn 0: all
        bool bias = true;
        float slope = 1;      // of the activation max(x, slope x); 0: ReLU, 1: none
        TensorId addTo = -1;  // add to this tensor, in place, before the activation, and return it
        bool affine = true;   // apply the convolution's scale and shift, if it has them
        // Keep the result in float, whatever the type of intermediate results is.
        bool inFloat = false;
    };

    // The type of all intermediate results; weights are packed to it too. Sums and biases are float.
    Graph(PackedWeights& packed, dnnl::memory::data_type type);

    // Float NCHW memory that is given to run().
    TensorId input(int batch, int channels, int size);
    TensorId conv(TensorId source, const UNetWeights::Conv& conv, const ConvOptions& options);
    TensorId maxPool2(TensorId source);
    TensorId upsample2(TensorId source);  // bilinear, pixel centres at half-integers
    // Marks the result; run() writes it as float NCHW.
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
