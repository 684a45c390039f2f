// What a training minimises: the L1 of the network's scale (Jiang & Kainz, section on training), and, if asked for, the
// error of what a diffuse surface would receive. The first cares for every texel alike; the second for the sums that
// pictures are made of, in which small systematic errors of many texels add up.
#pragma once
#include <torch/torch.h>

#include "cache/projection.h"

namespace drc {

class Loss {
  public:
    // irradianceWeight 0: L1 alone.
    Loss(const MapLayout& layout, double irradianceWeight);

    // All [B][3][S][S]; output and target on the network's scale (neural/transforms.h), factor as in Batch. A scalar:
    // each texel counts in proportion to its factor, as what is multiplied by little does little harm.
    torch::Tensor operator()(const torch::Tensor& output, const torch::Tensor& target,
                             const torch::Tensor& factor) const;

    // [B][3][64]: differences of irradiance at 64 normals over the hemisphere, each divided by sqrt(t^2 + 0.01), t the
    // target's irradiance over pi in units of its mean radiance. As in the renderer, the output's channels are scaled
    // to the target's means first. The mean square of these is `drc evaluate`'s irradiance at equal energy.
    torch::Tensor irradianceErrors(const torch::Tensor& output, const torch::Tensor& target,
                                   const torch::Tensor& factor) const;

  private:
    double irradianceWeight_;
    torch::Tensor solidAngles_;  // [texels], sum 1
    torch::Tensor cosines_;      // [texels][64], solid angle times cosine over pi
};

}  // namespace drc
