#include "neural/unet.h"

#include <algorithm>

#include "base/error.h"
#include "neural/graph.h"
#include "neural/onednn_thread.h"

namespace drc {

bool cpuHasBf16() {
    const auto bf16 = unsigned(dnnl::cpu_isa::avx512_core_bf16);
    return (unsigned(dnnl::get_effective_cpu_isa()) & bf16) == bf16;
}

Precision defaultPrecision() { return cpuHasBf16() ? Precision::Bf16 : Precision::Fp32; }

bool runsInBf16(UNetKind kind) { return kind != UNetKind::Separable; }

struct UNet::State {
    State(std::shared_ptr<const UNetWeights> weights_, int batch_, Precision precision_)
        : weights(std::move(weights_)),
          batch(batch_),
          precision(runsInBf16(weights->shape().kind) ? precision_ : Precision::Fp32),
          graph(weights->packed(),
                precision == Precision::Bf16 ? dnnl::memory::data_type::bf16 : dnnl::memory::data_type::f32) {
        const UNetShape& shape = weights->shape();
        const size_t texels = size_t(shape.size) * shape.size;
        inputFloats = shape.inputs * texels;
        outputFloats = shape.outputs * texels;
        lastInput.resize(batch * inputFloats);
        lastOutput.resize(batch * outputFloats);
        build(shape);
    }

    void build(const UNetShape& shape) {
        auto conv = weights->convs().begin();
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
                // Costs nothing, and rounding to bf16 here would be the largest error of all where results are large.
                options.inFloat = &layer == &layers.back();
                options.firstIn = layer.skip < 0 ? 0 : channels[size_t(layer.skip)];
                options.countIn = channels[source];
                if (layer.add >= 0) options.addTo = values[size_t(layer.add)];
                // A convolution of two stacked arrays is the sum of one of each: no copy to stack them.
                if (layer.skip >= 0) options.addTo = onSkip(layer, values, *conv, options.firstIn);
                result(graph.conv(values[source], *conv++, options), layer.conv.out);
            }
        }
        graph.output(values.back());
        graph.compile();
    }

    Graph::TensorId onSkip(const Layer& layer, const std::vector<Graph::TensorId>& values,
                           const UNetWeights::Conv& conv, int count) {
        Graph::ConvOptions options;
        options.countIn = count;
        options.bias = options.affine = false;
        return graph.conv(values[size_t(layer.skip)], conv, options);
    }

    std::shared_ptr<const UNetWeights> weights;
    int batch;
    Precision precision;
    Graph graph;
    size_t inputFloats = 0, outputFloats = 0;  // of one map
    std::vector<float> lastInput, lastOutput;  // for a batch that is not full
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
Precision UNet::precision() const { return state_->precision; }
size_t UNet::memoryBytes() const {
    return state_->graph.arenaBytes() + (state_->lastInput.size() + state_->lastOutput.size()) * sizeof(float);
}

}  // namespace drc
