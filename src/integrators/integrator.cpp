#include "integrators/integrator.h"

#include <fmt/ranges.h>

#include "base/error.h"
#include "integrators/sampled_integrator.h"

namespace drc {

// Each is defined in the integrator's own file.
std::vector<FilmLayerSpec> mapsLayers(const RenderParams& params, const Scene& scene);
std::vector<FilmLayerSpec> bdptLayers(const RenderParams& params, const Scene& scene);
std::unique_ptr<Integrator> makeFinalGatherIntegrator(const RenderContext& context);
std::unique_ptr<Integrator> makeMapsIntegrator(const RenderContext& context);
std::unique_ptr<Integrator> makePathIntegrator(const RenderContext& context);
std::unique_ptr<Integrator> makeBdptIntegrator(const RenderContext& context);
std::unique_ptr<Integrator> makeDirectIntegrator(const RenderContext& context);

namespace {

template <bool direct>
std::vector<FilmLayerSpec> oneLayer(const RenderParams& params, const Scene& scene) {
    return sampledLayers(params, scene.settings, direct);
}

struct Entry {
    const char* name;
    std::unique_ptr<Integrator> (*make)(const RenderContext&);
    std::vector<FilmLayerSpec> (*layers)(const RenderParams&, const Scene&);
    bool maps = false;    // there are map passes
    bool media = false;   // participating media are rendered
    bool halves = false;  // the half buffers have all that the picture is made of
};
constexpr Entry kIntegrators[] = {
    {.name = "drc", .make = makeFinalGatherIntegrator, .layers = oneLayer<true>, .media = true, .halves = true},
    {.name = "drc-maps", .make = makeMapsIntegrator, .layers = mapsLayers, .maps = true},
    {.name = "path", .make = makePathIntegrator, .layers = oneLayer<true>, .media = true, .halves = true},
    {.name = "bdpt", .make = makeBdptIntegrator, .layers = bdptLayers},
    {.name = "direct", .make = makeDirectIntegrator, .layers = oneLayer<false>, .halves = true},
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

std::vector<FilmLayerSpec> filmLayers(const std::string& integrator, const RenderParams& params, const Scene& scene) {
    return entry(integrator).layers(params, scene);
}

std::vector<std::string> integratorNames() {
    std::vector<std::string> names;
    for (const Entry& e : kIntegrators) names.push_back(e.name);
    return names;
}

bool usesMaps(const std::string& integrator) { return entry(integrator).maps; }
bool rendersMedia(const std::string& integrator) { return entry(integrator).media; }
bool hasHalves(const std::string& integrator) { return entry(integrator).halves; }

}  // namespace drc
