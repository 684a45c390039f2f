// Direct light alone: emission that the camera sees, and light that surfaces scatter once.
#include "integrators/sampled_integrator.h"

namespace drc {
namespace {

class DirectIntegrator final : public SampledIntegrator {
  public:
    using SampledIntegrator::SampledIntegrator;

  private:
    Rgb radiance(const Ray& ray, Sampler& sampler, const Place&, Film&, const SampleParts& parts) override {
        return context_.tracer.direct(ray, sampler, parts.gBuffer);
    }
};

}  // namespace

std::unique_ptr<Integrator> makeDirectIntegrator(const RenderContext& context) {
    return std::make_unique<DirectIntegrator>(context);
}

}  // namespace drc
