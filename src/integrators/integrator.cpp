#include "integrators/integrator.h"

#include <fmt/ranges.h>

#include "base/error.h"
#include "integrators/sampled_integrator.h"

namespace drc {

// Each function is defined in the integrator's own file.
std::vector<FilmLayerSpec> mapsLayers(const RenderParams& params, const Scene& scene, const RenderSettings& settings);
std::vector<FilmLayerSpec> bdptLayers(const RenderParams& params, const Scene& scene, const RenderSettings& settings);
std::unique_ptr<Integrator> makeFinalGatherIntegrator(const RenderContext& context);
std::unique_ptr<Integrator> makeMapsIntegrator(const RenderContext& context);
std::unique_ptr<Integrator> makePathIntegrator(const RenderContext& context);
std::unique_ptr<Integrator> makeBdptIntegrator(const RenderContext& context);
std::unique_ptr<Integrator> makeDirectIntegrator(const RenderContext& context);

namespace {

template <bool direct>
std::vector<FilmLayerSpec> oneLayer(const RenderParams& params, const Scene& scene, const RenderSettings& settings) {
    return sampledLayers(params, scene, settings, direct);
}

struct Entry {
    const char* name;
    std::unique_ptr<Integrator> (*make)(const RenderContext&);
    std::vector<FilmLayerSpec> (*layers)(const RenderParams&, const Scene&, const RenderSettings&);
    IntegratorTraits traits;
};
constexpr Entry kIntegrators[] = {
    {.name = "drc",
     .make = makeFinalGatherIntegrator,
     .layers = oneLayer<true>,
     .traits = {.cells = true, .media = true, .halves = true, .guided = true}},
    {.name = "drc-maps", .make = makeMapsIntegrator, .layers = mapsLayers, .traits = {.maps = true, .guided = true}},
    {.name = "path",
     .make = makePathIntegrator,
     .layers = oneLayer<true>,
     .traits = {.media = true, .halves = true, .guided = true}},
    {.name = "bdpt", .make = makeBdptIntegrator, .layers = bdptLayers, .traits = {}},
    {.name = "direct",
     .make = makeDirectIntegrator,
     .layers = oneLayer<false>,
     .traits = {.halves = true, .guided = true}},
};

const Entry& entry(const std::string& name) {
    for (const Entry& e : kIntegrators)
        if (e.name == name) return e;
    throw Error(fmt::format("there is no integrator '{}'; there are {}", name, fmt::join(integratorNames(), ", ")));
}

}  // namespace

Preview Integrator::preview(const Film& film) const {
    LayeredPicture all = picture(film.snapshot());
    return {std::move(all.beauty), std::move(all.alpha), sampleCounts(all.film->layer(0))};
}

std::unique_ptr<Integrator> makeIntegrator(const std::string& name, const RenderContext& context) {
    return entry(name).make(context);
}

std::vector<FilmLayerSpec> filmLayers(const std::string& integrator, const RenderParams& params, const Scene& scene,
                                      const RenderSettings& settings) {
    return entry(integrator).layers(params, scene, settings);
}

std::optional<size_t> layerIndex(const RenderContext& context, std::string_view name) {
    const auto layers = filmLayers(context.params.integrator, context.params, context.scene, context.sensor.settings);
    for (size_t i = 0; i < layers.size(); ++i)
        if (layers[i].name == name) return i;
    return {};
}

std::vector<std::string> integratorNames() {
    std::vector<std::string> names;
    for (const Entry& e : kIntegrators) names.push_back(e.name);
    return names;
}

const IntegratorTraits& traitsOf(const std::string& integrator) { return entry(integrator).traits; }

}  // namespace drc
