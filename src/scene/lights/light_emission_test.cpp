// emit() must have the pdf that emissionDensity() states, and on average emit the light's power.
#include <gtest/gtest.h>

#include "math/sampler.h"
#include "scene/lights/light.h"
#include "scene/shapes/curves.h"
#include "scene/shapes/shape_cone.h"
#include "scene/shapes/shape_disk.h"
#include "scene/shapes/shape_sphere.h"

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

TriangleMesh screen() {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0.5f}, {0, 1, 0.5f}};
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

// A fan of triangles, each of which shows another part of an image.
TriangleMesh manyTriangles() {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 1}};
    mesh.uvs = {{0.5f, 0.5f}};
    for (uint32_t i = 0; i < 12; ++i) {
        const float x = std::cos(0.5f * float(i)), y = std::sin(0.5f * float(i));
        mesh.positions.emplace_back(x, 2 * y, 0.f);
        mesh.uvs.emplace_back(0.5f + 0.5f * x, 0.5f + 0.5f * y);
        mesh.indices.insert(mesh.indices.end(), {0, i + 1, (i + 1) % 12 + 1});
    }
    return mesh;
}

const Transform kStretched = Transform::rotate(40, Vec3(1, 0, 1)) * Transform::scale(1, 2, 0.5f);
const Transform kPlaced = Transform::translate(Vec3(1, 2, 3)) * Transform::rotate(50, Vec3(1, 1, 0));

struct EmissionCase {
    const char* name;
    LightPtr light;
};
void PrintTo(const EmissionCase& c, std::ostream* out) { *out << c.name; }

std::vector<EmissionCase> cases() {
    const ShapePtr sphere = makeSphere({.objectToWorld = kPlaced, .radius = 0.7f});
    const ShapePtr disk = makeDisk({.objectToWorld = kPlaced, .radius = 0.7f});
    const std::array<Vec3, 4> portal = {Vec3(4, 5, 6), Vec3(4, 6, 6), Vec3(4, 6, 7.5f), Vec3(4, 5, 7.5f)};
    const auto ribbon = std::make_shared<Curves>(CurveType::Ribbon, false);
    ribbon->add({Vec3(-1, 0, 0), Vec3(-0.5f, 0.5f, 0), Vec3(0.5f, -0.5f, 0), Vec3(1, 0, 0.4f)}, {0.5f, 0.4f},
                {Vec3(0, 0, 1), normalize(Vec3(0, 0.6f, 1))});
    const Emission shown(std::make_shared<EmissionImage>(stripes()), Rgb(3, 2, 1));
    return {
        {"Point", makePointLight(Vec3(1, 2, 3), Rgb(3, 2, 1))},
        {"Spot", makeSpotLight(kPlaced, Rgb(3, 2, 1), {40, 15})},
        {"WideSpot", makeSpotLight(kPlaced, Rgb(3, 2, 1), {120, 30, SpotEdge::Smooth})},
        {"Goniometric", makeGoniometricLight(kPlaced, Rgb(3, 2, 1), stripes())},
        {"Projection", makeProjectionLight(kPlaced, Rgb(3, 2, 1), 70, stripes())},
        {"Distant", makeDistantLight(Vec3(1, 2, 3), Rgb(3, 2, 1))},
        {"Infinite", makeInfiniteLight(kPlaced, Rgb(3, 2, 1))},
        {"InfiniteMap", makeInfiniteLight(kPlaced, Rgb(3, 2, 1), stripes())},
        {"Portal", makePortalLight(makeInfiniteLight(kPlaced, Rgb(3, 2, 1), stripes()), portal)},
        {"ConstantPortal", makePortalLight(makeInfiniteLight(kPlaced, Rgb(3, 2, 1)), portal)},
        {"Mesh", makeMeshAreaLight(tent(), Rgb(3, 2, 1), false)},
        {"TwoSidedMesh", makeMeshAreaLight(tent(), Rgb(3, 2, 1), true)},
        {"Sphere", makeShapeAreaLight(sphere, Rgb(3, 2, 1), false)},
        {"NarrowMesh", makeMeshAreaLight(tent(), Emission(Rgb(3, 2, 1)).with(EmissionProfile::narrowed(70)), false)},
        {"NarrowDisk", makeShapeAreaLight(disk, Emission(Rgb(3, 2, 1)).with(EmissionProfile::narrowed(1)), true)},
        {"SpotOnASphere",
         makeShapeAreaLight(sphere, Emission(Rgb(3, 2, 1)).with(EmissionProfile({normalize(Vec3(1, 2, 3)), {50, 20}})),
                            false)},
        {"TwoSidedDisk", makeShapeAreaLight(disk, Rgb(3, 2, 1), true)},
        {"ImageOnAScreen", makeMeshAreaLight(screen(), shown, false)},
        {"ImageOnAMesh", makeMeshAreaLight(tent(), shown, true)},
        {"ImageOnManyTriangles", makeMeshAreaLight(manyTriangles(), shown, false)},
        {"ImageOnASphere", makeShapeAreaLight(sphere, shown, false)},
        {"ImageOnAnEllipsoid", makeShapeAreaLight(makeSphere({.objectToWorld = kStretched}), shown, true)},
        {"ImageOnADisk", makeShapeAreaLight(disk, shown, true)},
        {"ImageOnACone", makeShapeAreaLight(makeCone({.objectToWorld = kStretched}), shown, false)},
        {"ImageOnACurve", makeShapeAreaLight(ribbon, shown, true)},
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
        const EmissionDensity density = light.emissionDensity({ray->p, ray->ng, ray->triangle, ray->uv}, ray->d, scene);
        ASSERT_NEAR(density.origin / ray->density.origin, 1, 1e-4);
        ASSERT_NEAR(density.leaving / ray->density.leaving, 1, 1e-4);
        // For lights at infinity, rays that start on the disk must pass the sphere.
        if (light.isAtInfinity()) {
            ASSERT_NEAR(dot(ray->p - scene.center, ray->d), -scene.radius, 1e-4);
            ASSERT_LE(length(ray->p - scene.center - ray->d * -scene.radius), scene.radius * 1.0001f);
        }
        const float cosine = lengthSquared(ray->ng) > 0 ? absDot(ray->ng, ray->d) : 1;
        for (int c = 0; c < 3; ++c)
            power[c] += double(ray->radiance[c] * cosine) / (double(density.origin) * double(density.leaving));
    }
    const Rgb expected = light.power(scene.radius);
    // For environments without a portal, power() is the flux through a disk, averaged over all directions: a share of 1
    // / (4 pi).
    const double share = light.isInfinite() && light.bounds().empty() ? 4 * std::numbers::pi : 1;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(power[c] / kRays / share, expected[c], 0.01 * expected[c]);
}

// The density by area must be that of the points, also where a transformation stretches. With f = |p|^2 + x, say, the
// mean of f / density must be the integral of f over the surface, which two lights with different images estimate in
// different ways.
TEST(Emission, OriginsHaveTheirDensity) {
    const ShapePtr shapes[] = {makeSphere({.objectToWorld = kStretched}), makeCone({.objectToWorld = kStretched}),
                               makeDisk({.objectToWorld = kStretched}),
                               makeSphere({.objectToWorld = kStretched, .zMin = -0.3f, .phiMax = 200})};
    for (const ShapePtr& shape : shapes) {
        const Emission shown(std::make_shared<EmissionImage>(stripes()), Rgb(1.f));
        const auto plain = makeShapeAreaLight(shape, Rgb(1.f), false), image = makeShapeAreaLight(shape, shown, false);
        const auto integral = [](const Light& light) {
            constexpr uint32_t kPoints = 1 << 15;
            double sum = 0;
            for (uint32_t i = 0; i < kPoints; ++i) {
                Sampler sampler(9, i);
                const auto ray = light.emit(sampler.get2D(), Vec2(0.5f, 0.5f), {});
                if (ray) sum += double(lengthSquared(ray->p) + ray->p.x) / double(ray->density.origin) / kPoints;
            }
            return sum;
        };
        // Quadrature over (u, v).
        constexpr int kSide = 256;
        double expected = 0;
        for (int i = 0; i < kSide; ++i)
            for (int j = 0; j < kSide; ++j) {
                const auto spot = shape->spotAt(Vec2((float(i) + 0.5f) / kSide, (float(j) + 0.5f) / kSide));
                expected += double((lengthSquared(spot->p) + spot->p.x) * spot->area) / (kSide * kSide);
            }
        EXPECT_NEAR(integral(*plain), expected, 0.004 * expected);
        EXPECT_NEAR(integral(*image), expected, 0.01 * expected);
    }
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
    EXPECT_EQ(light->emissionDensity({Vec3(0.f), Vec3(0, 0, 1)}, Vec3(0, 0, -1), {}).leaving, 0);
}

}  // namespace
}  // namespace drc
