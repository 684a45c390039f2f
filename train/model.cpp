#include "model.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace drc {
namespace {

// ln(1 + 1/10): the encoded value of a texel equal to its map's mean.
constexpr double kEncodedMean = 0.0953;

std::string moduleName(std::string name) {
    std::replace(name.begin(), name.end(), '.', '_');  // libtorch does not allow dots in names
    return name;
}

// [1][inputs][1][1]: factors for the input planes. The standard deviation of encoded radiance and distance is about a
// tenth, of albedos a quarter, of normals one. With Adam, whose steps have the same size for all weights, a network
// would learn from normals first and from radiance late. Exported weights include the factors. The paper's network is
// left unchanged.
torch::Tensor inputScale(const UNetShape& shape) {
    torch::Tensor scale = torch::ones({1, shape.inputs, 1, 1});
    if (shape.kind == UNetKind::Paper) return scale;
    for (const int plane : {0, 1, 2, 6}) scale[0][plane] = 10;
    for (int plane = kPlainPlanes; plane < shape.inputs; ++plane) scale[0][plane] = plane < kPlainPlanes + 3 ? 4 : 10;
    return scale;
}

}  // namespace

ModelImpl::ModelImpl(const UNetShape& shape) : shape_(shape), inputScale_(inputScale(shape)) {
    const torch::NoGradGuard noGrad;
    for (const Layer& step : shape.layers()) {
        if (step.op != LayerOp::Conv) continue;
        const ConvShape& conv = step.conv;
        torch::nn::Conv2d layer(torch::nn::Conv2dOptions(conv.in, conv.out, conv.kernel)
                                    .padding(conv.kernel / 2)
                                    .groups(conv.depthwise ? conv.in : 1));
        const bool last = conv.name == "out";
        torch::nn::init::normal_(layer->weight, 0, std::sqrt(step.initialVariance()) * (last ? 0.1 : 1));
        torch::nn::init::constant_(layer->bias, last ? kEncodedMean : 0.0);
        layer->weight.set_data(layer->weight.contiguous(torch::MemoryFormat::ChannelsLast));
        convs_.push_back(register_module(moduleName(conv.name), layer));
        seesInput_.push_back(step.source == 0 && step.skip < 0);
        norms_.emplace_back(nullptr);
        if (conv.affine)
            norms_.back() = register_module(moduleName(conv.name) + "_norm", torch::nn::BatchNorm2d(conv.out));
    }
}

torch::Tensor ModelImpl::forward(torch::Tensor x) {
    namespace F = torch::nn::functional;
    const auto up = F::InterpolateFuncOptions()
                        .scale_factor(std::vector<double>{2.0, 2.0})
                        .mode(torch::kBilinear)
                        .align_corners(false)
                        .recompute_scale_factor(false);
    std::vector<torch::Tensor> values{(x * inputScale_).contiguous(torch::MemoryFormat::ChannelsLast)};
    size_t conv = 0;
    for (const Layer& layer : shape_.layers()) {
        torch::Tensor y = values[size_t(layer.source)];
        if (layer.op == LayerOp::MaxPool) {
            y = torch::max_pool2d(y, 2);
        } else if (layer.op == LayerOp::Upsample) {
            y = F::interpolate(y, up);
        } else {
            if (layer.skip >= 0) y = torch::cat({values[size_t(layer.skip)], y}, 1);
            y = convs_[conv]->forward(y);
            if (layer.add >= 0) y = y + values[size_t(layer.add)];
            const bool open = layer.slope == 0 && is_training();
            if (layer.slope != 1 && !open) y = torch::leaky_relu(y, layer.slope);
            if (norms_[conv]) y = norms_[conv]->forward(y);
            ++conv;
        }
        values.push_back(y);
    }
    return values.back();
}

void ModelImpl::setWeights(const UNetWeights& weights) {
    if (!(weights.shape() == shape_)) throw Error("the weights are for a network of another shape");
    const torch::NoGradGuard noGrad;
    for (size_t i = 0; i < convs_.size(); ++i) {
        const UNetWeights::Conv& from = weights.convs()[i];
        const auto copy = [](const std::vector<float>& values, torch::Tensor& to) {
            to.copy_(torch::from_blob(const_cast<float*>(values.data()), to.sizes().vec()));
        };
        copy(from.weight, convs_[i]->weight);
        copy(from.bias, convs_[i]->bias);
        if (seesInput_[i]) convs_[i]->weight.div_(inputScale_);
        if (!norms_[i]) continue;
        copy(from.scale, norms_[i]->weight);
        copy(from.shift, norms_[i]->bias);
        norms_[i]->running_mean.zero_();
        norms_[i]->running_var.fill_(1 - norms_[i]->options.eps());
    }
}

void ModelImpl::copyStatistics(const ModelImpl& other) {
    const torch::NoGradGuard noGrad;
    const auto from = other.buffers();
    auto to = buffers();
    for (size_t i = 0; i < to.size(); ++i) to[i].copy_(from[i]);
}

std::shared_ptr<const UNetWeights> ModelImpl::weights() const {
    const torch::NoGradGuard noGrad;
    std::vector<UNetWeights::Conv> list;
    const auto shapes = shape_.convs();
    for (size_t i = 0; i < convs_.size(); ++i) {
        const auto values = [](const torch::Tensor& t) {
            const torch::Tensor plain = t.detach().contiguous();
            return std::vector<float>(plain.data_ptr<float>(), plain.data_ptr<float>() + plain.numel());
        };
        const torch::Tensor weight = seesInput_[i] ? convs_[i]->weight * inputScale_ : convs_[i]->weight;
        list.push_back({shapes[i], values(weight), values(convs_[i]->bias), {}, {}});
        if (!norms_[i]) continue;
        const torch::Tensor scale = norms_[i]->weight / torch::sqrt(norms_[i]->running_var + norms_[i]->options.eps());
        list.back().scale = values(scale);
        list.back().shift = values(norms_[i]->bias - norms_[i]->running_mean * scale);
    }
    return std::make_shared<UNetWeights>(shape_, std::move(list), shape_.toMetadata());
}

}  // namespace drc
