// The base class of integrators whose picture is one layer of camera samples: makes the film, with half buffers and a
// G-buffer if requested, and the picture.
#pragma once
#include "integrators/integrator.h"

namespace drc {

// The names of the film's layers.
inline constexpr const char *kBeautyLayer = "beauty", *kDirectLayer = "direct", *kAlphaLayer = "alpha";
// The film's layers. direct: whether the integrator can separate direct light.
std::vector<FilmLayerSpec> sampledLayers(const RenderParams& params, const Scene& scene, const RenderSettings& settings,
                                         bool direct);

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
    // The radiance along a camera ray, which has nonzero weight. parts: further outputs; each is null if the film has
    // no layer for it.
    virtual Rgb radiance(const Ray& ray, Sampler& sampler, const Place& place, Film& film,
                         const SampleParts& parts) = 0;

    const RenderContext context_;

  private:
    // The group (half buffer) that a sample is added to.
    int groupOf(uint32_t index) const;

    // The indices of the film's layers; none: the film has no such layer.
    const std::optional<size_t> direct_, gBuffer_, alpha_, met_;
};

// The half buffer of a sample. The two samples of each pair are divided at random: the even samples of a sequence alone
// are poorly stratified.
int halfOf(uint64_t seed, uint32_t index);

}  // namespace drc
