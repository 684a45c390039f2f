#include "pbrt/filter_factory.h"

#include "pbrt/registry.h"

namespace drc::pbrt {
namespace {

Vec2 radiusOf(const ParamSet& params, float fallback) {
    const Vec2 radius(params.getFloat("xwidth", fallback), params.getFloat("ywidth", fallback));
    // The upper bound is far beyond any use; it catches widths meant for another unit.
    if (!(radius.x > 0 && radius.y > 0 && radius.x <= 64 && radius.y <= 64))
        fail(params.pos(), "the widths of " + params.owner() + " must be above 0 and at most 64 pixels");
    return radius;
}

FilterPtr makeBox(const ParamSet& params) { return makeBoxFilter(radiusOf(params, 0.5f)); }
FilterPtr makeTriangle(const ParamSet& params) { return makeTriangleFilter(radiusOf(params, 2)); }
FilterPtr makeGaussian(const ParamSet& params) {
    return makeGaussianFilter(radiusOf(params, 2), params.getFloat("alpha", 2));
}
FilterPtr makeMitchell(const ParamSet& params) {
    return makeMitchellFilter(radiusOf(params, 2), params.getFloat("B", 1 / 3.f), params.getFloat("C", 1 / 3.f));
}
FilterPtr makeSinc(const ParamSet& params) { return makeSincFilter(radiusOf(params, 4), params.getFloat("tau", 3)); }

using FilterMaker = FilterPtr (*)(const ParamSet&);
constexpr Registered<FilterMaker> kFilters[] = {
    {"box", makeBox},   {"gaussian", makeGaussian}, {"mitchell", makeMitchell},
    {"sinc", makeSinc}, {"triangle", makeTriangle},
};

}  // namespace

FilterPtr makeFilter(const std::string& type, const ParamSet& params) {
    const auto make = findMaker<FilterMaker>(kFilters, "pixel filter", type, params.pos(), "");
    FilterPtr filter = make(params);
    params.warnUnused();
    return filter;
}

}  // namespace drc::pbrt
