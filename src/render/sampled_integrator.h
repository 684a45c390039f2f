// What integrators have in common whose picture is one layer of camera samples: its film, with half buffers and a
// G-buffer if they are asked for, and its picture.
#pragma once
#include "render/integrator.h"

namespace drc {

class SampledIntegrator : public Integrator {
  public:
    explicit SampledIntegrator(const RenderContext& context) : context_(context) {}
    std::vector<FilmLayerSpec> layers() const override;
    void sample(int x, int y, uint32_t index, CameraSample& sample, Film& film) const override;
    LayeredPicture picture(std::shared_ptr<const Film> film) const override;

  protected:
    static constexpr const char* kBeauty = "beauty";
    // Radiance along the ray, which the camera lets through. gBuffer: null if it is not wanted.
    virtual Rgb radiance(const Ray& ray, Sampler& sampler, Film& film, GBufferSample* gBuffer) const = 0;

    const RenderContext context_;
};

// Which of two groups a pixel's sample belongs to, at random for each pair of samples: the even ones of a sequence
// alone are not well distributed.
int halfOf(uint64_t seed, uint32_t index);

}  // namespace drc
