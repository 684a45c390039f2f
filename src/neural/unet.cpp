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

struct UNet::State {
    State(std::shared_ptr<const UNetWeights> weights_, int batch_, Precision precision_)
        : weights(std::move(weights_)),
          batch(batch_),
          precision(precision_),
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
        auto next = weights->convs().begin();
        Graph::ConvOptions leaky;
        leaky.slope = kLeakySlope;
        std::vector<Graph::TensorId> skips;
        Graph::TensorId x = graph.input(batch, shape.inputs, shape.size);
        for (int l = 0; l < shape.levels; ++l) {
            if (l > 0) x = graph.maxPool2(x);
            x = graph.conv(x, *next++, leaky);
            x = graph.conv(x, *next++, leaky);
            skips.push_back(x);
        }
        for (int l = shape.levels - 2; l >= 0; --l) {
            const UNetWeights::Conv& both = *next++;
            // A convolution of two stacked arrays is the sum of one of each: no copy to stack them.
            Graph::ConvOptions onSkip = leaky, onUp = leaky;
            onSkip.countIn = shape.channels(l);
            onSkip.activate = false;
            onSkip.bias = false;
            onUp.firstIn = shape.channels(l);
            onUp.countIn = shape.channels(l + 1);
            x = graph.upsample2(x);
            onUp.addTo = graph.conv(skips[size_t(l)], both, onSkip);
            x = graph.conv(x, both, onUp);
            x = graph.conv(x, *next++, leaky);
        }
        x = graph.conv(x, *next, Graph::ConvOptions{});
        graph.output(x);
        graph.compile();
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
