// Errors of a network on examples that it was not trained on, compared with doing nothing and with a Gaussian blur.
#pragma once
#include <torch/torch.h>

#include "batch.h"
#include "loss.h"
#include "model.h"

namespace drc {

// Errors of radiance, with each map divided by its own mean: the energy is matched after the network, so only the shape
// matters. `log` and `intensity` are mean absolute errors, `log` of encoded radiance (neural/transforms.h).
struct MapErrors {
    double log = 0, intensity = 0;
    double irradiance = 0;  // mean square of Loss::irradianceErrors()
};

struct Validation {
    MapErrors network, none, gaussian;  // none: the noisy map unchanged; gaussian: blurred, sigma 1 texel
    size_t examples = 0;
};

Validation validate(Model& model, const Dataset& dataset, const std::vector<size_t>& indices, const Encoding& encoding);

// Blurs each channel with a Gaussian of `sigma` texels. Texels outside the map have weight zero.
torch::Tensor gaussianBlur(const torch::Tensor& maps, double sigma);

}  // namespace drc
