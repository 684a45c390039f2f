#include "neural/unet.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.h"
#include "neural/graph.h"
#include "neural/onednn_thread.h"
#include "neural/packed_weights.h"

namespace drc {

bool cpuHasBf16() {
    const auto bf16 = unsigned(dnnl::cpu_isa::avx512_core_bf16);
    return (unsigned(dnnl::get_effective_cpu_isa()) & bf16) == bf16;
}

namespace {

dnnl::memory::data_type typeOf(Precision precision) {
    return precision == Precision::Bf16 ? dnnl::memory::data_type::bf16 : dnnl::memory::data_type::f32;
}

Graph::TensorId addConvOnSkip(Graph& graph, const Layer& layer, const std::vector<Graph::TensorId>& values,
                              const UNetWeights::Conv& conv, int count) {
    Graph::ConvOptions options;
    options.countIn = count;
    options.bias = options.affine = false;
    return graph.conv(values[size_t(layer.skip)], conv, options);
}

// Builds the network of `shape` with the given weights, for batches of `batch` maps.
void buildNetwork(Graph& graph, const UNetShape& shape, const std::vector<UNetWeights::Conv>& convs, int batch) {
    auto conv = convs.begin();
    std::vector<Graph::TensorId> values{graph.input(batch, shape.inputs, shape.size)};
    std::vector<int> channels{shape.inputs};
    const std::vector<Layer> layers = shape.layers();
    for (const Layer& layer : layers) {
        const auto source = size_t(layer.source);
        const auto result = [&](Graph::TensorId id, int count) {
            values.push_back(id);
            channels.push_back(count);
        };
        if (layer.op == LayerOp::MaxPool) {
            result(graph.maxPool2(values[source]), channels[source]);
        } else if (layer.op == LayerOp::Upsample) {
            result(graph.upsample2(values[source]), channels[source]);
        } else {
            Graph::ConvOptions options;
            options.slope = layer.slope;
            // The last layer stays in float. This costs nothing; rounding its results to bf16 would be the largest of
            // all errors.
            options.inFloat = &layer == &layers.back();
            options.firstIn = layer.skip < 0 ? 0 : channels[size_t(layer.skip)];
            options.countIn = channels[source];
            if (layer.add >= 0) options.addTo = values[size_t(layer.add)];
            // The convolution of two concatenated tensors is the sum of two convolutions, so the concatenation need not
            // be stored.
            if (layer.skip >= 0) options.addTo = addConvOnSkip(graph, layer, values, *conv, options.firstIn);
            result(graph.conv(values[source], *conv++, options), layer.conv.out);
        }
    }
    graph.output(values.back());
    graph.compile();
}

size_t texels(const UNetShape& shape) { return size_t(shape.size) * size_t(shape.size); }

}  // namespace

struct UNet::State {
    State(std::shared_ptr<const UNetWeights> weights_, int batch_, Precision precision)
        : weights(std::move(weights_)),
          batch(batch_),
          graph(weights->packed(), typeOf(precision)),
          inputFloats(size_t(weights->shape().inputs) * texels(weights->shape())),
          outputFloats(size_t(weights->shape().outputs) * texels(weights->shape())),
          lastInput(batch * inputFloats),
          lastOutput(batch * outputFloats) {
        buildNetwork(graph, weights->shape(), weights->convs(), batch);
    }

    std::shared_ptr<const UNetWeights> weights;
    int batch;
    Graph graph;
    size_t inputFloats, outputFloats;          // per map
    std::vector<float> lastInput, lastOutput;  // for the last batch, if it is not full
};

UNet::UNet(std::shared_ptr<const UNetWeights> weights, int batch, Precision precision) {
    if (batch < 1) throw Error("the network's batch must be at least 1");
    const SingleThreadScope single;
    try {
        state_ = std::make_unique<State>(std::move(weights), batch, precision);
    } catch (const dnnl::error& error) {
        throw Error(std::string("the network cannot run on this processor: ") + error.what());
    }
}

UNet::~UNet() = default;
UNet::UNet(UNet&&) noexcept = default;
UNet& UNet::operator=(UNet&&) noexcept = default;

void UNet::run(const float* input, float* output, int count) {
    const SingleThreadScope single;
    State& s = *state_;
    for (; count >= s.batch; count -= s.batch) {
        s.graph.run(input, output);
        input += s.batch * s.inputFloats;
        output += s.batch * s.outputFloats;
    }
    if (count <= 0) return;
    std::fill(std::copy_n(input, count * s.inputFloats, s.lastInput.begin()), s.lastInput.end(), 0.f);
    s.graph.run(s.lastInput.data(), s.lastOutput.data());
    std::copy_n(s.lastOutput.begin(), count * s.outputFloats, output);
}

const UNetShape& UNet::shape() const { return state_->weights->shape(); }
int UNet::batch() const { return state_->batch; }
size_t UNet::memoryBytes() const {
    return state_->graph.arenaBytes() + (state_->lastInput.size() + state_->lastOutput.size()) * sizeof(float);
}

float bf16Error(const UNetWeights& weights) {
    constexpr int kMaps = 2;
    UNetShape shape = weights.shape();
    // Smaller maps need a quarter of the time, with as many roundings per texel. The coarsest level keeps two texels
    // along a side.
    shape.size = std::min(shape.size, std::max(16, 2 << (shape.levels - 1)));
    // The noise's standard deviation is between that of noisy encoded radiance (0.1) and that of normals (0.6).
    std::mt19937 generator(1);
    std::normal_distribution<float> normal(0, 0.3f);
    std::vector<float> input(kMaps * size_t(shape.inputs) * texels(shape));
    for (float& v : input) v = normal(generator);
    const auto outputOf = [&](Precision precision) {
        // The fp32 layouts are discarded with the probe, because a renderer that works in bf16 does not need them.
        PackedWeights passing;
        std::vector<float> output(kMaps * size_t(shape.outputs) * texels(shape));
        const SingleThreadScope single;
        Graph graph(precision == Precision::Bf16 ? weights.packed() : passing, typeOf(precision));
        buildNetwork(graph, shape, weights.convs(), kMaps);
        graph.run(input.data(), output.data());
        return output;
    };
    const std::vector<float> full = outputOf(Precision::Fp32), half = outputOf(Precision::Bf16);
    float largest = 0;
    for (size_t i = 0; i < full.size(); ++i) largest = std::max(largest, std::abs(half[i] - full[i]));
    return largest;
}

Precision bestPrecision(const UNetWeights& weights) {
    constexpr float kBorne = 0.008f;
    return cpuHasBf16() && bf16Error(weights) <= kBorne ? Precision::Bf16 : Precision::Fp32;
}

}  // namespace drc
