#include "neural/unet_weights.h"

#include <fmt/core.h>

#include <cmath>
#include <random>

#include "base/error.h"
#include "neural/packed_weights.h"

namespace drc {
namespace {

std::string shapeText(const std::vector<int64_t>& shape) {
    std::string text = "[";
    for (size_t i = 0; i < shape.size(); ++i) text += (i ? ", " : "") + std::to_string(shape[i]);
    return text + "]";
}

std::vector<float> readTensor(const SafetensorsFile& file, const std::string& name,
                              const std::vector<int64_t>& expected) {
    const SourceLocation where{file.path()};
    const TensorView& view = file.tensor(name);
    if (view.shape != expected)
        throw Error(where,
                    fmt::format("tensor '{}' has shape {}, not {}", name, shapeText(view.shape), shapeText(expected)));
    std::vector<float> values = view.toFloat();
    bool finite = true;
    for (float v : values) finite &= std::isfinite(v);
    if (!finite) throw Error(where, fmt::format("tensor '{}' holds a value that is not finite", name));
    return values;
}

}  // namespace

UNetWeights::UNetWeights(const UNetShape& shape, std::vector<Conv> convs, StringMap metadata, std::string hash)
    : shape_(shape),
      convs_(std::move(convs)),
      metadata_(std::move(metadata)),
      hash_(std::move(hash)),
      packed_(std::make_unique<PackedWeights>()) {}

UNetWeights::~UNetWeights() = default;

std::shared_ptr<const UNetWeights> UNetWeights::load(const std::string& path) {
    const SafetensorsFile file(path);
    const UNetShape shape = UNetShape::fromMetadata(file);
    std::vector<Conv> convs;
    for (const ConvShape& conv : shape.convs())
        convs.push_back({conv, readTensor(file, conv.name + ".weight", {conv.out, conv.in, conv.kernel, conv.kernel}),
                         readTensor(file, conv.name + ".bias", {conv.out})});
    if (file.tensors().size() != 2 * convs.size())
        throw Error(SourceLocation{path},
                    fmt::format("holds {} tensors; this architecture has {}", file.tensors().size(), 2 * convs.size()));
    return std::make_shared<UNetWeights>(shape, std::move(convs), file.metadata(), file.contentHash());
}

std::shared_ptr<const UNetWeights> UNetWeights::random(const UNetShape& shape, uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::vector<Conv> convs;
    for (const ConvShape& conv : shape.convs()) {
        const float fanIn = float(conv.in * conv.kernel * conv.kernel);
        std::normal_distribution<float> normal(0, std::sqrt(2 / ((1 + kLeakySlope * kLeakySlope) * fanIn)));
        std::uniform_real_distribution<float> uniform(-0.1f, 0.1f);
        Conv c{conv, std::vector<float>(conv.weightCount()), std::vector<float>(size_t(conv.out))};
        for (float& w : c.weight) w = normal(generator);
        for (float& b : c.bias) b = uniform(generator);
        convs.push_back(std::move(c));
    }
    return std::make_shared<UNetWeights>(shape, std::move(convs), shape.toMetadata());
}

void UNetWeights::save(const std::string& path, const StringMap& provenance, DType type) const {
    std::vector<TensorToWrite> tensors;
    for (const Conv& c : convs_) {
        tensors.push_back({c.shape.name + ".weight",
                           {c.shape.out, c.shape.in, c.shape.kernel, c.shape.kernel},
                           c.weight.data(),
                           type});
        tensors.push_back({c.shape.name + ".bias", {c.shape.out}, c.bias.data(), type});
    }
    StringMap metadata = provenance;
    for (const auto& [key, value] : shape_.toMetadata()) metadata[key] = value;
    writeSafetensors(path, tensors, metadata);
}

std::string UNetWeights::projection() const {
    const auto found = metadata_.find("projection");
    return found == metadata_.end() ? "" : found->second;
}

}  // namespace drc
