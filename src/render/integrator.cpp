#include "render/integrator.h"

#include <fmt/ranges.h>

#include "base/error.h"

namespace drc {

// Each is defined in the integrator's own file.
std::unique_ptr<Integrator> makeFinalGatherIntegrator(const RenderContext& context);
std::unique_ptr<Integrator> makeMapsIntegrator(const RenderContext& context);
std::unique_ptr<Integrator> makePathIntegrator(const RenderContext& context);
std::unique_ptr<Integrator> makeBdptIntegrator(const RenderContext& context);
std::unique_ptr<Integrator> makeDirectIntegrator(const RenderContext& context);

namespace {

struct Entry {
    const char* name;
    std::unique_ptr<Integrator> (*make)(const RenderContext&);
    bool maps = false;    // there are map passes
    bool media = false;   // participating media are rendered
    bool halves = false;  // the half buffers have all that the picture is made of
};
constexpr Entry kIntegrators[] = {
    {.name = "drc", .make = makeFinalGatherIntegrator, .media = true, .halves = true},
    {.name = "drc-maps", .make = makeMapsIntegrator, .maps = true},
    {.name = "path", .make = makePathIntegrator, .media = true, .halves = true},
    {.name = "bdpt", .make = makeBdptIntegrator},
    {.name = "direct", .make = makeDirectIntegrator, .halves = true},
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

std::vector<std::string> integratorNames() {
    std::vector<std::string> names;
    for (const Entry& e : kIntegrators) names.push_back(e.name);
    return names;
}

bool usesMaps(const std::string& integrator) { return entry(integrator).maps; }
bool rendersMedia(const std::string& integrator) { return entry(integrator).media; }
bool hasHalves(const std::string& integrator) { return entry(integrator).halves; }

}  // namespace drc
