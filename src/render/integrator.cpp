#include "render/integrator.h"

#include <fmt/ranges.h>

#include "base/error.h"

// One line for each integrator: its name, the function that makes it, which its own file defines, whether it has map
// passes, and whether it renders participating media.
#define DRC_INTEGRATORS(X)                           \
    X("drc", makeFinalGatherIntegrator, false, true) \
    X("drc-maps", makeMapsIntegrator, true, false)   \
    X("path", makePathIntegrator, false, true)       \
    X("bdpt", makeBdptIntegrator, false, false)      \
    X("direct", makeDirectIntegrator, false, false)

namespace drc {

#define DRC_DECLARE(name, make, maps, media) std::unique_ptr<Integrator> make(const RenderContext& context);
DRC_INTEGRATORS(DRC_DECLARE)
#undef DRC_DECLARE

namespace {

struct Entry {
    const char* name;
    std::unique_ptr<Integrator> (*make)(const RenderContext&);
    bool maps, media;
};
#define DRC_ENTRY(name, make, maps, media) {name, make, maps, media},
constexpr Entry kIntegrators[] = {DRC_INTEGRATORS(DRC_ENTRY)};
#undef DRC_ENTRY

const Entry& entry(const std::string& name) {
    for (const Entry& e : kIntegrators)
        if (e.name == name) return e;
    throw Error(fmt::format("there is no integrator '{}'; there are {}", name, fmt::join(integratorNames(), ", ")));
}

}  // namespace

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

}  // namespace drc
