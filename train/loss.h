// The training loss: L1 of encoded radiance (Jiang & Kainz, section on training) and, optionally, the error of the
// irradiance on diffuse surfaces. The first weights all texels equally. The second measures the sums that pixels
// consist of, in which small systematic errors of many texels add up.
#pragma once
#include <torch/torch.h>

#include "maps/projection.h"

namespace drc {

class Loss {
  public:
    // With an irradianceWeight of 0, the loss is L1 only.
    Loss(const MapLayout& layout, double irradianceWeight);

    // All tensors are [B][3][S][S]; output and target are encoded (neural/transforms.h), factor is as in Batch. Returns
    // a scalar. Texels are weighted by their factor, since errors that are multiplied by a small albedo do little harm.
    torch::Tensor operator()(const torch::Tensor& output, const torch::Tensor& target,
                             const torch::Tensor& factor) const;

    // [B][3][64]: differences of irradiance at 64 normals over the hemisphere, each divided by sqrt(t^2 + 0.01), where
    // t is the target's irradiance over pi in units of its mean radiance. As in the renderer, each output channel is
    // first scaled to the target's mean. Their mean square is `drc evaluate`'s irradiance error at equal energy.
    torch::Tensor irradianceErrors(const torch::Tensor& output, const torch::Tensor& target,
                                   const torch::Tensor& factor) const;

  private:
    double irradianceWeight_;
    torch::Tensor solidAngles_;  // [texels], normalised to the sum 1
    torch::Tensor cosines_;      // [texels][64], solid angle times cosine over pi
};

}  // namespace drc
