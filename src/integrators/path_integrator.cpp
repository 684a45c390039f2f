// Path tracing: all light in one layer of camera samples.
#include "integrators/sampled_integrator.h"

namespace drc {
namespace {

class PathIntegrator final : public SampledIntegrator {
  public:
    using SampledIntegrator::SampledIntegrator;
    bool cameraMoved() override { return true; }

  private:
    Rgb radiance(const Ray& ray, Sampler& sampler, const Place&, Film&, const SampleParts& parts) override {
        return context_.tracer.radiance(ray, sampler, parts);
    }
};

}  // namespace

std::unique_ptr<Integrator> makePathIntegrator(const RenderContext& context) {
    return std::make_unique<PathIntegrator>(context);
}

}  // namespace drc
