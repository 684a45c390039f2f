// Bidirectional path tracing: each sample connects a path from the camera with a path from a light.
#include "film/splat_filter.h"
#include "integrators/sampled_integrator.h"
#include "transport/bdpt.h"

namespace drc {
namespace {

constexpr const char* kSplats = "splats";

class BdptIntegrator final : public SampledIntegrator {
  public:
    explicit BdptIntegrator(const RenderContext& context)
        : SampledIntegrator(context),
          tracer_(context.scene, *context.sensor.camera, context.accel, context.lights, context.tracer.settings(),
                  double(context.sensor.settings.region().count())),
          splatFilter_(*context.sensor.settings.filter),
          splats_(*layerIndex(context, kSplats)) {}

    LayeredPicture picture(std::shared_ptr<const Film> film) const override {
        LayeredPicture picture = SampledIntegrator::picture(std::move(film));
        const FilmLayer &camera = picture.film->layer(kBeauty), &splats = picture.film->layer(kSplats);
        const PixelRegion& region = picture.film->region();
        // BidirectionalTracer scales splats for a sample pass with one light path per pixel of the whole region.
        double paths = 0;
        for (int y = region.y0; y < region.y1; ++y)
            for (int x = region.x0; x < region.x1; ++x) paths += camera.expected(x, y);
        if (paths == 0) return picture;
        const double scale = double(region.count()) / paths * double(picture.scale);
        PictureLayer layer{kSplats, "", Image(region.width(), region.height()), std::nullopt};
        for (int y = region.y0; y < region.y1; ++y)
            for (int x = region.x0; x < region.x1; ++x) {
                const auto channel = [&](int c) { return float(splats.sum(x, y, c) * scale); };
                layer.mean.setRgb(x - region.x0, y - region.y0, Rgb(channel(0), channel(1), channel(2)));
            }
        picture.layers.push_back(std::move(layer));
        picture.compose();
        return picture;
    }

    // The beauty includes splats, which are added to any row without its lock, so the row-wise preview is of no use.
    Preview preview(const Film& film) const override { return Integrator::preview(film); }

  private:
    Rgb radiance(const Ray& ray, Sampler& sampler, const Place&, Film& film, const SampleParts& parts) override {
        thread_local std::vector<Splat> splats;
        splats.clear();
        const Rgb radiance = tracer_.radiance(ray, sampler, splats, parts.gBuffer);
        FilmLayer& layer = film.layer(splats_);
        for (const Splat& splat : splats) splatFilter_.add(splat, layer);
        return radiance;
    }

    BidirectionalTracer tracer_;
    SplatFilter splatFilter_;
    const size_t splats_;  // index of the layer
};

}  // namespace

std::vector<FilmLayerSpec> bdptLayers(const RenderParams& params, const Scene& scene, const RenderSettings& settings) {
    std::vector<FilmLayerSpec> layers = sampledLayers(params, scene, settings, false);
    // The quantum is smaller than in other layers, because a splat is the contribution of one path divided by the
    // number of pixels of the film.
    layers.push_back({.name = kSplats, .weighted = false, .quantum = layers[0].quantum / 256});
    return layers;
}

std::unique_ptr<Integrator> makeBdptIntegrator(const RenderContext& context) {
    return std::make_unique<BdptIntegrator>(context);
}

}  // namespace drc
