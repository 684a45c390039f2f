#include "validation.h"

#include <algorithm>
#include <cmath>

namespace drc {
namespace {

torch::Tensor meanOf(const torch::Tensor& maps) { return maps.mean({1, 2, 3}, true).clamp_min(1e-30); }

// Radiance encoded by its own mean.
torch::Tensor encoded(const torch::Tensor& maps) { return torch::log1p(maps / (10 * meanOf(maps))); }

double l1(const torch::Tensor& a, const torch::Tensor& b) { return (a - b).abs().mean().item<double>(); }

}  // namespace

torch::Tensor gaussianBlur(const torch::Tensor& maps, double sigma) {
    const int64_t radius = int64_t(std::ceil(4 * sigma)), size = maps.size(3);
    const torch::Tensor offsets = torch::arange(-radius, radius + 1, torch::kFloat32);
    const torch::Tensor kernel = torch::exp(-0.5 * (offsets / sigma).square());
    namespace F = torch::nn::functional;
    const auto pass = [&](const torch::Tensor& planes) {
        const torch::Tensor columns =
            F::conv2d(planes, kernel.view({1, 1, -1, 1}), F::Conv2dFuncOptions().padding({radius, 0}));
        return F::conv2d(columns, kernel.view({1, 1, 1, -1}), F::Conv2dFuncOptions().padding({0, radius}));
    };
    const torch::Tensor planes = maps.contiguous().view({-1, 1, maps.size(2), size});
    return (pass(planes) / pass(torch::ones_like(planes.slice(0, 0, 1)))).view(maps.sizes());
}

Validation validate(Model& model, const Dataset& dataset, const std::vector<size_t>& indices,
                    const Encoding& encoding) {
    constexpr size_t kBatch = 32;
    const torch::NoGradGuard noGrad;
    const bool wasTraining = model->is_training();
    model->eval();
    const Loss loss(MapLayout(dataset.projection(), dataset.mapSize()), 0);
    Validation result;
    for (size_t first = 0; first < indices.size(); first += kBatch) {
        const size_t count = std::min(kBatch, indices.size() - first);
        const Batch batch = plainBatch(dataset, indices, first, count, encoding);
        const torch::Tensor truth = batch.clean / meanOf(batch.clean), target = encoded(batch.clean);
        const torch::Tensor ones = torch::ones_like(target);
        const auto add = [&](MapErrors& sum, const torch::Tensor& radiance) {
            const torch::Tensor log = encoded(radiance);
            sum.log += double(count) * l1(log, target);
            sum.intensity += double(count) * l1(radiance / meanOf(radiance), truth);
            sum.irradiance += double(count) * loss.irradianceErrors(log, target, ones).square().mean().item<double>();
        };
        const torch::Tensor output = model->forward(batch.input).contiguous();
        add(result.network, torch::expm1(torch::relu(output)) * batch.factor);
        const torch::Tensor noisy = batch.radiance.nan_to_num(0, 0, 0).clamp_min(0);
        add(result.none, noisy);
        add(result.gaussian, gaussianBlur(noisy, 1));
    }
    result.examples = indices.size();
    if (!indices.empty())
        for (MapErrors* sum : {&result.network, &result.none, &result.gaussian}) {
            sum->log /= double(indices.size());
            sum->intensity /= double(indices.size());
            sum->irradiance /= double(indices.size());
        }
    model->train(wasTraining);
    return result;
}

}  // namespace drc
