// Stands in for the final gather, as path tracing: all light in one layer of camera samples.
#include "render/sampled_integrator.h"

namespace drc {
namespace {

class FinalGatherIntegrator final : public SampledIntegrator {
  public:
    using SampledIntegrator::SampledIntegrator;

  private:
    Rgb radiance(const Ray& ray, Sampler& sampler, Film&, GBufferSample* gBuffer) const override {
        return context_.tracer.radiance(ray, sampler, gBuffer);
    }
};

}  // namespace

std::unique_ptr<Integrator> makeFinalGatherIntegrator(const RenderContext& context) {
    return std::make_unique<FinalGatherIntegrator>(context);
}

}  // namespace drc
