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

std::string valueOr(const StringMap& map, const std::string& key, const std::string& fallback) {
    const auto found = map.find(key);
    return found == map.end() ? fallback : found->second;
}

std::vector<int64_t> weightDims(const ConvShape& conv) {
    return {conv.out, conv.inputsPerFilter(), conv.kernel, conv.kernel};
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
      ablation_(parseAblation(valueOr(metadata_, "ablation", "none"))),
      hash_(std::move(hash)),
      packed_(std::make_unique<PackedWeights>()) {}

UNetWeights::~UNetWeights() = default;

std::shared_ptr<const UNetWeights> UNetWeights::load(const std::string& path) {
    const SafetensorsFile file(path);
    const UNetShape shape = UNetShape::fromMetadata(file);
    try {
        parseAblation(file.metadata("ablation", "none"));
    } catch (const Error& error) {
        throw Error(SourceLocation{path}, fmt::format("metadata 'ablation': {}", error.what()));
    }
    std::vector<Conv> convs;
    size_t tensors = 0;
    for (const ConvShape& conv : shape.convs()) {
        Conv c{conv,
               readTensor(file, conv.name + ".weight", weightDims(conv)),
               readTensor(file, conv.name + ".bias", {conv.out}),
               {},
               {}};
        tensors += 2;
        if (conv.affine) {
            c.scale = readTensor(file, conv.name + ".scale", {conv.out});
            c.shift = readTensor(file, conv.name + ".shift", {conv.out});
            tensors += 2;
        }
        convs.push_back(std::move(c));
    }
    if (file.tensors().size() != tensors)
        throw Error(SourceLocation{path},
                    fmt::format("holds {} tensors; this architecture has {}", file.tensors().size(), tensors));
    return std::make_shared<UNetWeights>(shape, std::move(convs), file.metadata(), file.contentHash());
}

std::shared_ptr<const UNetWeights> UNetWeights::random(const UNetShape& shape, uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::vector<Conv> convs;
    for (const Layer& layer : shape.layers()) {
        if (layer.op != LayerOp::Conv) continue;
        const ConvShape& conv = layer.conv;
        std::normal_distribution<float> normal(0, float(std::sqrt(layer.initialVariance())));
        std::uniform_real_distribution<float> uniform(-0.1f, 0.1f);
        Conv c{conv, std::vector<float>(conv.weightCount()), std::vector<float>(size_t(conv.out)), {}, {}};
        for (float& w : c.weight) w = normal(generator);
        for (float& b : c.bias) b = uniform(generator);
        for (int i = 0; conv.affine && i < conv.out; ++i) {
            c.scale.push_back(1 + uniform(generator));
            c.shift.push_back(uniform(generator));
        }
        convs.push_back(std::move(c));
    }
    return std::make_shared<UNetWeights>(shape, std::move(convs), shape.toMetadata());
}

void UNetWeights::save(const std::string& path, const StringMap& provenance, DType type) const {
    std::vector<TensorToWrite> tensors;
    for (const Conv& c : convs_) {
        tensors.push_back({c.shape.name + ".weight", weightDims(c.shape), c.weight.data(), type});
        tensors.push_back({c.shape.name + ".bias", {c.shape.out}, c.bias.data(), type});
        if (!c.shape.affine) continue;
        tensors.push_back({c.shape.name + ".scale", {c.shape.out}, c.scale.data(), type});
        tensors.push_back({c.shape.name + ".shift", {c.shape.out}, c.shift.data(), type});
    }
    StringMap metadata = provenance;
    for (const auto& [key, value] : shape_.toMetadata()) metadata[key] = value;
    writeSafetensors(path, tensors, metadata);
}

std::string UNetWeights::projection() const { return valueOr(metadata_, "projection", ""); }

}  // namespace drc
