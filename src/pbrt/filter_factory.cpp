#include "pbrt/filter_factory.h"

#include "pbrt/registry.h"

namespace drc::pbrt {
namespace {

// The names of the radius parameters in pbrt-v4 or pbrt-v3.
struct RadiusNames {
    const char *x, *y;
};
constexpr RadiusNames kWidths{"xwidth", "ywidth"}, kRadii{"xradius", "yradius"};

Vec2 radiusOf(const ParamSet& params, float fallback, const RadiusNames& names) {
    const Vec2 radius(params.getFloat(names.x, fallback), params.getFloat(names.y, fallback));
    // The upper limit is far above any useful width. It catches widths given in another unit.
    if (!(radius.x > 0 && radius.y > 0 && radius.x <= 64 && radius.y <= 64))
        fail(params.pos(), "the widths of " + params.owner() + " must be above 0 and at most 64 pixels");
    return radius;
}

FilterPtr makeBox(const ParamSet& params, const RadiusNames& names) {
    return makeBoxFilter(radiusOf(params, 0.5f, names));
}
FilterPtr makeTriangle(const ParamSet& params, const RadiusNames& names) {
    return makeTriangleFilter(radiusOf(params, 2, names));
}
FilterPtr makeGaussian(const ParamSet& params, const RadiusNames& names) {
    return makeGaussianFilter(radiusOf(params, 2, names), params.getFloat("alpha", 2));
}
// pbrt-v4's Gaussian exp(-x^2 / (2 sigma^2)), expressed as exp(-alpha x^2).
FilterPtr makeGaussianV4(const ParamSet& params, const RadiusNames& names) {
    const float sigma = params.getPositiveFloat("sigma", 0.5f);
    return makeGaussianFilter(radiusOf(params, 1.5f, names), 1 / (2 * sigma * sigma));
}
FilterPtr makeMitchell(const ParamSet& params, const RadiusNames& names) {
    return makeMitchellFilter(radiusOf(params, 2, names), params.getFloat("B", 1 / 3.f), params.getFloat("C", 1 / 3.f));
}
FilterPtr makeSinc(const ParamSet& params, const RadiusNames& names) {
    return makeSincFilter(radiusOf(params, 4, names), params.getFloat("tau", 3));
}

using FilterMaker = FilterPtr (*)(const ParamSet&, const RadiusNames&);
constexpr Registered<FilterMaker> kFilters[] = {
    {"box", makeBox},   {"gaussian", makeGaussian}, {"mitchell", makeMitchell},
    {"sinc", makeSinc}, {"triangle", makeTriangle},
};
constexpr Registered<FilterMaker> kFiltersV4[] = {
    {"box", makeBox},   {"gaussian", makeGaussianV4}, {"mitchell", makeMitchell},
    {"sinc", makeSinc}, {"triangle", makeTriangle},
};

FilterPtr make(std::span<const Registered<FilterMaker>> table, const RadiusNames& names, const std::string& type,
               const ParamSet& params) {
    FilterPtr filter = findMaker<FilterMaker>(table, "pixel filter", type, params.pos(), "")(params, names);
    params.warnUnused();
    return filter;
}

}  // namespace

FilterPtr makeFilter(const std::string& type, const ParamSet& params) { return make(kFilters, kWidths, type, params); }

FilterPtr makeFilterV4(const std::string& type, const ParamSet& params) {
    return make(kFiltersV4, kRadii, type, params);
}

}  // namespace drc::pbrt
