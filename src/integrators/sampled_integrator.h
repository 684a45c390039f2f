// The base class of integrators whose picture is one layer of camera samples: its film, with half buffers and a
// G-buffer if they are wanted, and its picture.
#pragma once
#include "integrators/integrator.h"

namespace drc {

// The names of its layers.
inline constexpr const char *kBeautyLayer = "beauty", *kDirectLayer = "direct", *kAlphaLayer = "alpha";
// The film's layers; direct: whether direct light can be told apart.
std::vector<FilmLayerSpec> sampledLayers(const RenderParams& params, const RenderSettings& settings, bool direct);

class SampledIntegrator : public Integrator {
  public:
    explicit SampledIntegrator(const RenderContext& context);
    void sample(int x, int y, uint32_t index, CameraSample& sample, Film& film) override;
    LayeredPicture picture(std::shared_ptr<const Film> film) const override;
    Preview preview(const Film& film) const override;

  protected:
    static constexpr const char *kBeauty = kBeautyLayer, *kDirect = kDirectLayer, *kAlpha = kAlphaLayer;
    // The pixel of a sample, and the index of the sample within it.
    struct Place {
        int x, y;
        uint32_t index;
    };
    // The radiance that arrives along a camera ray of nonzero weight. parts: what else is wanted;
    // direct only if its film has such a layer.
    virtual Rgb radiance(const Ray& ray, Sampler& sampler, const Place& place, Film& film,
                         const SampleParts& parts) = 0;

    const RenderContext context_;

  private:
    // The half buffer that a sample is added to.
    int groupOf(uint32_t index) const;

    // The indices of its film's layers; none: the film does not have it.
    const std::optional<size_t> direct_, gBuffer_, alpha_;
};

// The half buffer that a sample belongs to, at random for each pair of samples: the even samples of a sequence alone
// are poorly stratified.
int halfOf(uint64_t seed, uint32_t index);

}  // namespace drc
