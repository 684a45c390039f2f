// How good a network is on examples it has not learnt from, and how good doing nothing or a blur would have been.
#pragma once
#include <torch/torch.h>

#include "batch.h"
#include "loss.h"
#include "model.h"

namespace drc {

// Of radiance, each map divided by its own mean: energy is matched after the network, so that only the shape counts.
// `log` and `intensity` are mean absolute errors, `log` on the network's scale (neural/transforms.h).
struct MapErrors {
    double log = 0, intensity = 0;
    double irradiance = 0;  // mean square of Loss::irradianceErrors
};

struct Validation {
    MapErrors network, none, gaussian;  // none: the noisy map as it is; gaussian: blurred, sigma 1 texel
    size_t examples = 0;
};

Validation validate(Model& model, const Dataset& dataset, const std::vector<size_t>& indices, const Encoding& encoding);

// Each channel blurred with a Gaussian of `sigma` texels; texels outside the map have no weight.
torch::Tensor gaussianBlur(const torch::Tensor& maps, double sigma);

}  // namespace drc
