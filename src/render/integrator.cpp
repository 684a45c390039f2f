#include "render/integrator.h"

#include <fmt/ranges.h>

#include "base/error.h"

// One line for each integrator: its name, the function that makes it, which its own file defines, and whether it has
// map passes.
#define DRC_INTEGRATORS(X)                     \
    X("drc", makeFinalGatherIntegrator, false) \
    X("drc-maps", makeMapsIntegrator, true)    \
    X("path", makePathIntegrator, false)       \
    X("bdpt", makeBdptIntegrator, false)       \
    X("direct", makeDirectIntegrator, false)

namespace drc {

#define DRC_DECLARE(name, make, maps) std::unique_ptr<Integrator> make(const RenderContext& context);
DRC_INTEGRATORS(DRC_DECLARE)
#undef DRC_DECLARE

namespace {

struct Entry {
    const char* name;
    std::unique_ptr<Integrator> (*make)(const RenderContext&);
    bool maps;
};
#define DRC_ENTRY(name, make, maps) {name, make, maps},
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

}  // namespace drc
