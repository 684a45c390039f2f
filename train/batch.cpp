#include "batch.h"

#include <ATen/Parallel.h>

#include <algorithm>
#include <numeric>

#include "base/error.h"
#include "neural/transforms.h"

namespace drc {
namespace {

// A stateless random number (Steele et al., "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014).
uint64_t splitMix(uint64_t x) {
    x += 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}

Batch emptyBatch(int64_t count, int64_t size, int planes) {
    Batch batch;
    batch.input = torch::empty({count, planes, size, size});
    batch.factor = torch::ones({count, kOutputPlanes, size, size});
    batch.target = torch::empty({count, kOutputPlanes, size, size});
    batch.targetMean = torch::empty({count});
    return batch;
}

void encode(const Example& example, const Encoding& encoding, int64_t slot, Batch& batch) {
    const size_t texels = size_t(example.size) * example.size;
    const bool guides = encoding.planes == kGuidedPlanes;
    if (guides && (example.albedo.empty() || example.direct.empty()))
        throw Error("the network sees albedo and direct light, which the data do not contain: train with --planes 7");
    const MapView map{example.radiance.data(),
                      example.normal.data(),
                      example.distance.data(),
                      texels,
                      guides ? example.albedo.data() : nullptr,
                      guides ? example.direct.data() : nullptr};
    float* planes = batch.input.data_ptr<float>() + slot * int64_t(size_t(encoding.planes) * texels);
    float mean = encodeInput(map, planes);
    ablate(encoding.ablation, texels, planes);
    const auto slotOf = [&](torch::Tensor& t) { return t.data_ptr<float>() + slot * int64_t(kOutputPlanes * texels); };
    float* target = slotOf(batch.target);
    std::copy(example.target.begin(), example.target.end(), target);
    if (guides) {
        float* factor = slotOf(batch.factor);
        multiplyByAlbedo(factor, example.albedo.data(), example.albedo.size(), factor);
        divideByAlbedo(target, example.albedo.data(), example.albedo.size(), target);
    }
    if (encoding.mean == TargetMean::Own) mean = meanRadiance(target, example.target.size());
    encodeTarget(target, example.target.size(), mean, target);
    batch.targetMean.data_ptr<float>()[slot] = mean;
}

}  // namespace

TargetMean parseTargetMean(const std::string& name) {
    if (name == "own") return TargetMean::Own;
    if (name == "input") return TargetMean::Input;
    throw Error("--target-mean must be 'own' or 'input', not '" + name + "'");
}

std::string targetMeanName(TargetMean mean) { return mean == TargetMean::Own ? "own" : "input"; }

TrainingBatches::TrainingBatches(const Dataset& dataset, std::vector<size_t> indices, int batch, uint64_t seed,
                                 const Encoding& encoding)
    : dataset_(dataset), indices_(std::move(indices)), batch_(batch), seed_(splitMix(seed)), encoding_(encoding) {}

void TrainingBatches::shuffle(int64_t epoch) {
    if (epoch == epoch_) return;
    epoch_ = epoch;
    // Sorted by random keys, which gives the same order with every standard library, unlike std::shuffle.
    std::vector<std::pair<uint64_t, size_t>> keys;
    for (size_t i : indices_) keys.emplace_back(splitMix(seed_ ^ splitMix(uint64_t(epoch)) ^ (i << 20)), i);
    std::sort(keys.begin(), keys.end());
    order_.clear();
    for (const auto& key : keys) order_.push_back(key.second);
}

Batch TrainingBatches::draw(int64_t step) {
    std::vector<size_t> drawn;
    const uint64_t first = uint64_t(step) * uint64_t(batch_);
    for (uint64_t draw = first; draw < first + uint64_t(batch_); ++draw) {
        shuffle(int64_t(draw / indices_.size()));
        drawn.push_back(order_[draw % order_.size()]);
    }
    Batch batch = emptyBatch(batch_, dataset_.mapSize(), encoding_.planes);
    // On torch's own threads, since decoding and encoding on a single thread takes as long as a training step of a
    // small network.
    at::parallel_for(0, batch_, 1, [&](int64_t begin, int64_t end) {
        Example source, changed;
        for (int64_t slot = begin; slot < end; ++slot) {
            const size_t i = drawn[size_t(slot)];
            const uint64_t bits = splitMix(seed_ + first + uint64_t(slot));
            dataset_.load(i, int((bits >> 32) % uint64_t(dataset_.realisations(i))), source);
            Augmentation::random(dataset_.projection(), bits).apply(source, changed);
            encode(changed, encoding_, slot, batch);
        }
    });
    return batch;
}

Batch plainBatch(const Dataset& dataset, const std::vector<size_t>& indices, size_t first, size_t count,
                 const Encoding& encoding) {
    const int64_t size = dataset.mapSize();
    Batch batch = emptyBatch(int64_t(count), size, encoding.planes);
    batch.radiance = torch::empty({int64_t(count), 3, size, size});
    batch.clean = torch::empty_like(batch.radiance);
    Example example;
    for (size_t k = 0; k < count; ++k) {
        dataset.load(indices[first + k], 0, example);
        encode(example, encoding, int64_t(k), batch);
        const auto copy = [&](const std::vector<float>& from, torch::Tensor& to) {
            std::copy(from.begin(), from.end(), to.data_ptr<float>() + int64_t(k * from.size()));
        };
        copy(example.radiance, batch.radiance);
        copy(example.target, batch.clean);
    }
    return batch;
}

}  // namespace drc
