#include "model.h"

#include <algorithm>

#include "base/error.h"

namespace drc {
namespace {

// ln(1 + 1/10): the encoded value of a texel as bright as its map's mean.
constexpr double kEncodedMean = 0.0953;

std::string moduleName(std::string name) {
    std::replace(name.begin(), name.end(), '.', '_');  // libtorch allows no dots
    return name;
}

}  // namespace

ModelImpl::ModelImpl(const UNetShape& shape) : shape_(shape) {
    const torch::NoGradGuard noGrad;
    for (const ConvShape& conv : shape.convs()) {
        torch::nn::Conv2d layer(torch::nn::Conv2dOptions(conv.in, conv.out, conv.kernel).padding(conv.kernel / 2));
        const bool last = conv.name == "out";
        torch::nn::init::kaiming_normal_(layer->weight, last ? 1.0 : kLeakySlope, torch::kFanIn, torch::kLeakyReLU);
        if (last) layer->weight.mul_(0.1);
        torch::nn::init::constant_(layer->bias, last ? kEncodedMean : 0.0);
        layer->weight.set_data(layer->weight.contiguous(torch::MemoryFormat::ChannelsLast));
        convs_.push_back(register_module(moduleName(conv.name), layer));
    }
}

torch::Tensor ModelImpl::forward(torch::Tensor x) {
    namespace F = torch::nn::functional;
    const auto leaky = [](const torch::Tensor& t) { return torch::leaky_relu(t, kLeakySlope); };
    const auto up = F::InterpolateFuncOptions()
                        .scale_factor(std::vector<double>{2.0, 2.0})
                        .mode(torch::kBilinear)
                        .align_corners(false)
                        .recompute_scale_factor(false);
    auto next = convs_.begin();
    x = x.contiguous(torch::MemoryFormat::ChannelsLast);
    std::vector<torch::Tensor> skips;
    for (int l = 0; l < shape_.levels; ++l) {
        if (l > 0) x = torch::max_pool2d(x, 2);
        for (int i = 0; i < 2; ++i) x = leaky((*next++)->forward(x));
        skips.push_back(x);
    }
    for (int l = shape_.levels - 2; l >= 0; --l) {
        x = torch::cat({skips[size_t(l)], F::interpolate(x, up)}, 1);
        for (int i = 0; i < 2; ++i) x = leaky((*next++)->forward(x));
    }
    x = (*next)->forward(x);
    return is_training() ? x : torch::relu(x);
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
    }
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
        list.push_back({shapes[i], values(convs_[i]->weight), values(convs_[i]->bias)});
    }
    return std::make_shared<UNetWeights>(shape_, std::move(list), shape_.toMetadata());
}

}  // namespace drc
