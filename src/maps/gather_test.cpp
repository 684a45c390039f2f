#include "maps/gather.h"

#include <gtest/gtest.h>

#include "scene/materials/material_matte.h"
#include "scene/materials/material_metal.h"
#include "scene/materials/material_plastic.h"
#include "scene/materials/material_translucent.h"

namespace drc {
namespace {

// A map about n at the origin whose radiance is a function of world direction.
template <typename F>
RadianceMap mapOf(const Vec3& n, F&& radiance, int size = 32) {
    const MapLayout layout(Projection::EqualArea, size);
    CapturedMap map;
    map.origin = Vec3(0, 0, 0);
    map.frame = Frame::fromNormal(n);
    const auto texels = size_t(layout.texels());
    map.radiance.resize(3 * texels);
    map.normal.assign(3 * texels, 0.f);
    map.distance.assign(texels, -1.f);
    for (int i = 0; i < layout.texels(); ++i) {
        const Rgb value = radiance(map.frame.toWorld(layout.direction(i % size, i / size, Vec2(0.5f, 0.5f))));
        for (size_t c = 0; c < 3; ++c) map.radiance[c * texels + size_t(i)] = value[int(c)];
    }
    return RadianceMap(map, layout);
}

struct Case {
    Primitive primitive;
    PrimaryHit hit;
    MapSite site;
};

template <typename F>
void makeCase(const MaterialPtr& material, F&& radiance, Case& s) {
    s.primitive.material = material;
    s.hit.surface.primitive = &s.primitive;
    s.hit.surface.p = Vec3(0, 0, 0);
    s.hit.surface.ng = s.hit.surface.ns = Vec3(0, 0, 1);
    s.hit.surface.dpdu = Vec3(1, 0, 0);
    s.hit.surface.dpdv = Vec3(0, 1, 0);
    s.hit.surface.wo = normalize(Vec3(0.5f, 0.2f, 1));
    s.hit.bsdf = s.hit.surface.bsdf();
    s.site.n = Vec3(0, 0, 1);
    s.site.front = mapOf(Vec3(0, 0, 1), radiance);
    s.site.back = mapOf(Vec3(0, 0, -1), radiance);
    s.site.hasFront = s.site.hasBack = true;
}

struct Mean {
    double value, sigma;
};

Mean gatherMean(const Case& s, int samples) {
    const WeightedSite one{&s.site, 0.37f};
    double sum = 0, squares = 0;
    const int runs = 2000;
    for (int i = 0; i < runs; ++i) {
        const double g = gather(s.hit, broadLobes(0.2f), {&one, 1}, samples, 99, uint32_t(i * samples)).y;
        sum += g;
        squares += g * g;
    }
    const double mean = sum / runs;
    return {mean, std::sqrt(std::max(1e-12, squares / runs - mean * mean) / runs)};
}

// The integral of f R cos by brute force: the midpoint rule over the sphere.
template <typename F>
double integrate(const PrimaryHit& hit, F&& radiance) {
    const int n = 1500;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const float z = -1 + 2 * (float(i) + 0.5f) / float(n), phi = 2 * kPi * (float(j) + 0.5f) / float(n);
            const float r = safeSqrt(1 - z * z);
            const Vec3 d(r * std::cos(phi), r * std::sin(phi), z);
            sum += double((hit.bsdf.f(hit.surface.wo, d, LobeFlags::NonSpecular) * radiance(d)).y) * std::abs(z);
        }
    return sum * 4 * std::numbers::pi / (double(n) * n);
}

// On a curved surface no map sees the whole hemisphere of its neighbours; a twelfth of the irradiance is missed here.
TEST(Gather, MapsThatAreTurnedAwayLoseNoLight) {
    const Vec3 tilted = normalize(Vec3(std::sin(0.6f), 0, std::cos(0.6f)));
    for (const bool transmits : {false, true}) {
        const auto half = std::make_shared<ConstantTexture<Rgb>>(Rgb(0.5f));
        Case s;
        makeCase(
            transmits ? makeTranslucent({}) : makeMatte({half, nullptr, nullptr, {}}), [](Vec3) { return Rgb(3.f); },
            s);
        const double expected = integrate(s.hit, [](Vec3) { return Rgb(3.f); });
        s.site.n = tilted;
        s.site.front = mapOf(tilted, [](Vec3) { return Rgb(3.f); });
        s.site.back = mapOf(-tilted, [](Vec3) { return Rgb(3.f); });
        const Mean m = gatherMean(s, 8);
        EXPECT_NEAR(m.value, expected, 4 * m.sigma + 1e-3) << (transmits ? "translucent" : "matte");
    }
}

TEST(Gather, ConstantRadianceOnALambertianSurfaceGivesItsAlbedo) {
    Case s;
    makeCase(
        makeMatte({std::make_shared<ConstantTexture<Rgb>>(Rgb(0.5f)), nullptr, nullptr, {}}),
        [](Vec3) { return Rgb(3.f); }, s);
    const Mean m = gatherMean(s, 8);
    EXPECT_NEAR(m.value, 1.5, 4 * m.sigma + 1e-3);
    EXPECT_LT(m.sigma, 0.005);
}

// Smooth radiance, so that what 32x32 texels cannot resolve does not matter.
Rgb smooth(const Vec3& d) { return Rgb(1 + 0.6f * d.x + 0.3f * d.y * d.z); }

TEST(Gather, IsTheIntegralForEachKindOfLobe) {
    const std::pair<const char*, MaterialPtr> materials[] = {
        {"matte", makeMatte({})},
        {"plastic", makePlastic({})},
        {"metal",
         makeMetal({nullptr, nullptr, std::make_shared<ConstantTexture<float>>(0.3f), nullptr, nullptr, true, {}})},
        {"translucent", makeTranslucent({})}};
    for (const auto& [name, material] : materials) {
        Case s;
        makeCase(material, smooth, s);
        const double expected = integrate(s.hit, smooth);
        const Mean m = gatherMean(s, 8);
        EXPECT_NEAR(m.value, expected, 4 * m.sigma + 0.004 * expected) << name;
    }
}

TEST(Gather, MapsAreMixedByWeight) {
    Case a, b;
    makeCase(
        makeMatte({}), [](Vec3) { return Rgb(1.f); }, a);
    makeCase(
        makeMatte({}), [](Vec3) { return Rgb(5.f); }, b);
    const WeightedSite sites[] = {{&a.site, 0.3f}, {&b.site, 0.1f}};
    double sum = 0;
    for (int i = 0; i < 4000; ++i) sum += gather(a.hit, broadLobes(0.2f), sites, 4, 5, uint32_t(4 * i)).y / 4000;
    const double albedo = gatherMean(a, 8).value;
    EXPECT_NEAR(sum / albedo, 0.75 * 1 + 0.25 * 5, 0.03);
}

}  // namespace
}  // namespace drc
