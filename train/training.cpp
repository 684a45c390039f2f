#include "training.h"

#include <ATen/autocast_mode.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "base/error.h"

namespace drc {
namespace {

// While it lives, layers that gain from bf16 run in bf16. The loss stays in float.
class Autocast {
  public:
    explicit Autocast(bool enabled) : enabled_(enabled) {
        if (!enabled_) return;
        at::autocast::set_autocast_cpu_dtype(at::kBFloat16);
        at::autocast::set_cpu_enabled(true);
    }
    ~Autocast() {
        if (!enabled_) return;
        at::autocast::set_cpu_enabled(false);
        at::autocast::clear_cache();
    }
    Autocast(const Autocast&) = delete;
    Autocast& operator=(const Autocast&) = delete;

  private:
    bool enabled_;
};

Model seededModel(const UNetShape& shape, uint64_t seed) {
    torch::manual_seed(seed);
    return Model(shape);
}

}  // namespace

Training::Training(const UNetShape& shape, const Dataset& dataset, std::vector<size_t> indices,
                   const TrainingOptions& options)
    : options_(options),
      batches_(dataset, std::move(indices), options.batch, options.seed, options.encoding),
      loss_(MapLayout(dataset.projection(), dataset.mapSize()), options.irradianceWeight),
      model_(seededModel(shape, options.seed)),
      average_(shape),
      optimizer_(model_->parameters(), torch::optim::AdamOptions(options.learningRate)) {
    startFrom(*model_->weights());
    model_->train();
    average_->eval();
    for (torch::Tensor& p : average_->parameters()) p.set_requires_grad(false);
}

void Training::startFrom(const UNetWeights& weights) {
    model_->setWeights(weights);
    average_->setWeights(weights);
}

double Training::learningRate() const {
    const double total = double(options_.steps()), warm = std::max(1.0, options_.warmUp * total);
    const double t = double(step_) + 1;
    if (t < warm) return options_.learningRate * t / warm;
    const double progress = std::min(1.0, (t - warm) / std::max(1.0, total - warm));
    return options_.learningRate * 0.5 * (1 + std::cos(std::numbers::pi * progress));
}

torch::Tensor Training::forwardLoss(const Batch& batch) {
    torch::Tensor output;
    {
        const Autocast autocast(options_.bf16);
        output = model_->forward(batch.input);
    }
    return loss_(output.to(torch::kFloat32), batch.target, batch.factor);
}

double Training::step() {
    for (auto& group : optimizer_.param_groups())
        static_cast<torch::optim::AdamOptions&>(group.options()).lr(learningRate());
    optimizer_.zero_grad();
    const torch::Tensor loss = forwardLoss(batches_.draw(step_));
    loss.backward();
    const double value = loss.item<double>();
    if (!std::isfinite(value)) throw Error(fmt::format("the loss is not finite at step {}: lower --lr", step_));
    if (options_.clipNorm > 0) torch::nn::utils::clip_grad_norm_(model_->parameters(), options_.clipNorm);
    optimizer_.step();
    ++step_;
    updateAverage();
    return value;
}

void Training::updateAverage() {
    const torch::NoGradGuard noGrad;
    // Starts with a short memory, otherwise the average would contain the random initial weights for long.
    const double decay = std::min(options_.averageDecay, double(step_) / double(step_ + 10));
    auto to = average_->parameters();
    const auto from = model_->parameters();
    for (size_t i = 0; i < to.size(); ++i) to[i].lerp_(from[i], 1 - decay);
    average_->copyStatistics(*model_);
}

std::string Training::signature() const {
    const TrainingOptions& o = options_;
    // The version number is increased when the same parameters come to mean another network.
    return fmt::format(
        "model 2 kind {} planes {} width {} levels {} size {} batch {} examples {} lr {} seed {} irradiance {} "
        "target-mean {} "
        "ablation "
        "{}",
        unetKindName(model_->shape().kind), model_->shape().inputs, model_->shape().width, model_->shape().levels,
        model_->shape().size, o.batch, o.examples, o.learningRate, o.seed, o.irradianceWeight,
        targetMeanName(o.encoding.mean), ablationName(o.encoding.ablation));
}

void Training::save(const std::string& path) {
    torch::serialize::OutputArchive archive, model, average, optimizer;
    model_->save(model);
    average_->save(average);
    optimizer_.save(optimizer);
    archive.write("model", model);
    archive.write("average", average);
    archive.write("optimizer", optimizer);
    archive.write("step", c10::IValue(step_));
    archive.write("signature", c10::IValue(signature()));
    archive.save_to(path + ".tmp");
    std::error_code error;
    std::filesystem::rename(path + ".tmp", path, error);
    if (error) throw Error(SourceLocation{path}, "cannot write the checkpoint: " + error.message());
}

void Training::load(const std::string& path) {
    const SourceLocation where{path};
    c10::IValue value;
    try {
        torch::serialize::InputArchive archive, model, average, optimizer;
        archive.load_from(path);
        archive.read("signature", value);
        if (value.toStringRef() != signature())
            throw Error(where, fmt::format("a checkpoint of another training run ({}), not of this one ({})",
                                           value.toStringRef(), signature()));
        archive.read("model", model);
        archive.read("average", average);
        archive.read("optimizer", optimizer);
        model_->load(model);
        average_->load(average);
        optimizer_.load(optimizer);
        archive.read("step", value);
        step_ = value.toInt();
    } catch (const c10::Error& error) {
        throw Error(where, "not a checkpoint of drc-train");
    }
}

}  // namespace drc
