// emit() must have the pdf that emissionDensity() states, and on average emit the light's power.
#include <gtest/gtest.h>

#include "math/sampler.h"
#include "scene/light.h"
#include "scene/shape_disk.h"
#include "scene/shape_sphere.h"

namespace drc {
namespace {

TriangleMesh tent() {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 3}};
    mesh.indices = {0, 1, 2, 0, 3, 1, 0, 2, 3};
    return mesh;
}

LightImage stripes() {
    LightImage image{8, 4, {}};
    for (int i = 0; i < 32; ++i) image.texels.emplace_back(0.2f + 0.1f * float(i % 7), 0.5f, 0.05f * float(i));
    return image;
}

const Transform kPlaced = Transform::translate(Vec3(1, 2, 3)) * Transform::rotate(50, Vec3(1, 1, 0));

struct EmissionCase {
    const char* name;
    LightPtr light;
};
void PrintTo(const EmissionCase& c, std::ostream* out) { *out << c.name; }

std::vector<EmissionCase> cases() {
    const ShapePtr sphere = makeSphere({.objectToWorld = kPlaced, .radius = 0.7f});
    const ShapePtr disk = makeDisk({.objectToWorld = kPlaced, .radius = 0.7f});
    return {
        {"Point", makePointLight(Vec3(1, 2, 3), Rgb(3, 2, 1))},
        {"Spot", makeSpotLight(kPlaced, Rgb(3, 2, 1), 40, 15)},
        {"WideSpot", makeSpotLight(kPlaced, Rgb(3, 2, 1), 120, 30, SpotEdge::Smooth)},
        {"Goniometric", makeGoniometricLight(kPlaced, Rgb(3, 2, 1), stripes())},
        {"Projection", makeProjectionLight(kPlaced, Rgb(3, 2, 1), 70, stripes())},
        {"Distant", makeDistantLight(Vec3(1, 2, 3), Rgb(3, 2, 1))},
        {"Infinite", makeInfiniteLight(kPlaced, Rgb(3, 2, 1))},
        {"InfiniteMap", makeInfiniteLight(kPlaced, Rgb(3, 2, 1), stripes())},
        {"Mesh", makeMeshAreaLight(tent(), Rgb(3, 2, 1), false)},
        {"TwoSidedMesh", makeMeshAreaLight(tent(), Rgb(3, 2, 1), true)},
        {"Sphere", makeShapeAreaLight(sphere, Rgb(3, 2, 1), false)},
        {"TwoSidedDisk", makeShapeAreaLight(disk, Rgb(3, 2, 1), true)},
    };
}

class LightEmission : public testing::TestWithParam<EmissionCase> {};
INSTANTIATE_TEST_SUITE_P(Lights, LightEmission, testing::ValuesIn(cases()), [](const auto& i) { return i.param.name; });

TEST_P(LightEmission, HasItsDensityAndPower) {
    const Light& light = *GetParam().light;
    const SceneSphere scene{Vec3(4, 5, 6), 3};
    constexpr uint32_t kRays = 1 << 15;
    double power[3] = {};
    for (uint32_t i = 0; i < kRays; ++i) {
        Sampler sampler(7, i);
        const Vec2 uOrigin = sampler.get2D();
        const auto ray = light.emit(uOrigin, sampler.get2D(), scene);
        if (!ray) continue;
        ASSERT_NEAR(length(ray->d), 1, 1e-5);
        const EmissionDensity density = light.emissionDensity(ray->ng, ray->d, scene);
        ASSERT_NEAR(density.origin / ray->density.origin, 1, 1e-4);
        ASSERT_NEAR(density.leaving / ray->density.leaving, 1, 1e-4);
        // For lights at infinity, rays that start on the disk must pass the sphere.
        if (light.bounds().empty()) {
            ASSERT_NEAR(dot(ray->p - scene.center, ray->d), -scene.radius, 1e-4);
            ASSERT_LE(length(ray->p - scene.center - ray->d * -scene.radius), scene.radius * 1.0001f);
        }
        const float cosine = lengthSquared(ray->ng) > 0 ? absDot(ray->ng, ray->d) : 1;
        for (int c = 0; c < 3; ++c)
            power[c] += double(ray->radiance[c] * cosine) / (double(density.origin) * double(density.leaving));
    }
    const Rgb expected = light.power(scene.radius);
    // For non-delta lights at infinity, power() is the flux through a disk, averaged over all directions: a share of 1
    // / (4 pi).
    const double share = light.isInfinite() ? 4 * std::numbers::pi : 1;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(power[c] / kRays / share, expected[c], 0.01 * expected[c]);
}

TEST(EmittersOfOneSide, ShineOnIt) {
    const auto light = makeMeshAreaLight(tent(), Rgb(1.f), false);
    for (uint32_t i = 0; i < 1000; ++i) {
        Sampler sampler(8, i);
        const Vec2 uOrigin = sampler.get2D();
        const auto ray = light->emit(uOrigin, sampler.get2D(), {});
        ASSERT_TRUE(ray);
        EXPECT_GT(dot(ray->ng, ray->d), 0);
    }
    EXPECT_EQ(light->emissionDensity(Vec3(0, 0, 1), Vec3(0, 0, -1), {}).leaving, 0);
}

}  // namespace
}  // namespace drc
