// For every light that is not a delta light, samples must follow the pdf, direction by direction, and lights with an
// image must be sampled in proportion to it. (Curves have a test of their own, because their pdf has too many
// discontinuities for quadrature.)
#include <gtest/gtest.h>

#include <functional>

#include "scene/chi_square.h"
#include "scene/lights/light.h"
#include "scene/lobes/lobe_testing.h"
#include "scene/shapes/shape_cone.h"
#include "scene/shapes/shape_cylinder.h"
#include "scene/shapes/shape_disk.h"
#include "scene/shapes/shape_hyperboloid.h"
#include "scene/shapes/shape_paraboloid.h"
#include "scene/shapes/shape_sphere.h"

namespace drc {
namespace {

using namespace test;

// Called for all points of an emitter on a ray, not only the nearest, because samples may be hidden.
using Visit = std::function<void(const EmitterHit&)>;
using Crossings = std::function<void(const Vec3& o, const Vec3& d, const Visit&)>;

struct Lamp {
    const char* name;
    std::shared_ptr<const AreaLight> light;
    Crossings crossings;
    Vec3 from;  // the lit point
    bool hasImage = false;
};
void PrintTo(const Lamp& lamp, std::ostream* out) { *out << lamp.name; }

// Patches of light, most of them black.
Emission picture(int width, int height) {
    LightImage image{width, height, {}};
    std::mt19937 rng(5);
    for (int i = 0; i < width * height; ++i) {
        const float on = uniform(rng), value = uniform(rng);
        image.texels.push_back(on < 0.6f ? Rgb(0.f) : Rgb(0.2f + value));
    }
    return {std::make_shared<EmissionImage>(std::move(image)), Rgb(1, 2, 3)};
}

Lamp shapeLamp(const char* name, const ShapePtr& shape, const Vec3& from, bool twoSided = false,
               const Emission& emission = Rgb(1.f)) {
    const auto crossings = [shape](const Vec3& o, const Vec3& d, const Visit& visit) {
        Ray ray;
        ray.o = o;
        ray.d = d;
        float after = 0;
        while (const auto hit = shape->intersect(ray, after)) {
            visit({o + d * hit->t, hit->ng, hit->part, hit->uv});
            after = hit->t * 1.0001f;
        }
    };
    return {name, makeShapeAreaLight(shape, emission, twoSided), crossings, from, emission.image() != nullptr};
}

Lamp meshLamp(const char* name, const TriangleMesh& m, const Vec3& from, bool twoSided = false,
              const Emission& emission = Rgb(1.f)) {
    const auto crossings = [m](const Vec3& o, const Vec3& d, const Visit& visit) {
        for (uint32_t i = 0; i < m.triangleCount(); ++i) {
            const Vec3 a = m.positions[m.indices[3 * i]], e1 = m.positions[m.indices[3 * i + 1]] - a,
                       e2 = m.positions[m.indices[3 * i + 2]] - a, h = cross(d, e2), s = o - a, q = cross(s, e1);
            const float det = dot(e1, h), u = dot(s, h) / det, v = dot(d, q) / det, t = dot(e2, q) / det;
            if (!(u >= 0 && v >= 0 && u + v <= 1 && t > 0)) continue;
            const auto uvs = m.textureCoordinates(i);
            visit({o + d * t, m.geometricNormal(i), i, uvs[0] * (1 - u - v) + uvs[1] * u + uvs[2] * v});
        }
    };
    return {name, makeMeshAreaLight(m, emission, twoSided), crossings, from, emission.image() != nullptr};
}

// Three triangles of different sizes, one of them tilted; sampled by area.
TriangleMesh fewTriangles() {
    TriangleMesh m;
    m.positions = {Vec3(-1, -1, 2), Vec3(2, -1, 2), Vec3(2, 1, 2), Vec3(-1, 0.3f, 2), Vec3(-2, 3, 1)};
    m.indices = {0, 2, 1, 0, 3, 2, 3, 4, 2};
    return m;
}

// A parallelogram, with the image turned on it and cut at its edges.
TriangleMesh screen() {
    TriangleMesh m;
    m.positions = {Vec3(-1, -1, 1), Vec3(1, -1.2f, 1.4f), Vec3(1.3f, 1, 1.4f), Vec3(-0.7f, 1.2f, 1)};
    m.uvs = {Vec2(0.1f, -0.1f), Vec2(0.9f, 0.2f), Vec2(0.7f, 1.1f), Vec2(-0.1f, 0.8f)};
    m.indices = {0, 2, 1, 0, 3, 2};
    return m;
}

// A bumpy mesh, some of whose triangles face away; sampled by a light tree.
TriangleMesh manyTriangles() {
    TriangleMesh m;
    constexpr int kSide = 4;
    for (int y = 0; y <= kSide; ++y)
        for (int x = 0; x <= kSide; ++x)
            m.positions.push_back(Vec3(float(x) - 2, float(y) - 2, 1.2f + 0.6f * std::sin(float(3 * x + 5 * y))));
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) {
            const uint32_t a = y * (kSide + 1) + x, b = a + 1, c = a + kSide + 1, d = c + 1;
            m.indices.insert(m.indices.end(), {a, d, b, a, c, d});
        }
    return m;
}

// With an image that covers the mesh, seen along z.
TriangleMesh withCoordinates(TriangleMesh m) {
    for (const Vec3& p : m.positions) m.uvs.push_back(Vec2(0.25f * (p.x + 2), 0.25f * (p.y + 2)));
    return m;
}

std::vector<Lamp> lamps() {
    const Transform t = Transform::translate(Vec3(0.3f, 0.2f, -0.1f)) * Transform::rotate(35, Vec3(1, 2, 0)) *
                        Transform::scale(1, 1.4f, 0.8f);
    const auto at = [&](float x, float y, float z) { return t.point(Vec3(x, y, z)); };
    return {
        meshLamp("Triangles", fewTriangles(), Vec3(0, 0.5f, 0.8f)),
        meshLamp("TrianglesOfTwoSides", fewTriangles(), Vec3(0.2f, 0.5f, 2.8f), true),
        meshLamp("ManyTriangles", manyTriangles(), Vec3(0.3f, 0.2f, 0)),
        shapeLamp("Sphere", makeSphere({}), Vec3(0.9f, 0.7f, 1)),
        shapeLamp("SphereFromWithin", makeSphere({.reverseOrientation = true}), Vec3(0.2f, 0.1f, 0.5f)),
        shapeLamp("Ellipsoid", makeSphere({.objectToWorld = t}), at(0.1f, -0.3f, 0.2f), true),
        shapeLamp("PartOfASphere", makeSphere({.zMin = -0.6f, .zMax = 0.8f, .phiMax = 230}), Vec3(0.1f, 0, 0.2f), true),
        shapeLamp("Disk", makeDisk({.objectToWorld = t}), at(0.3f, -0.2f, 0.6f)),
        shapeLamp("PartOfARing", makeDisk({.objectToWorld = t, .innerRadius = 0.4f, .phiMax = 250}),
                  at(0.1f, 0.2f, -0.5f), true),
        shapeLamp("Cylinder", makeCylinder({.objectToWorld = t}), at(0.4f, 0.1f, 0.3f), true),
        shapeLamp("CylinderFromOutside", makeCylinder({.objectToWorld = t, .phiMax = 270}), at(1.2f, 0.8f, 0.4f)),
        shapeLamp("Cone", makeCone({.objectToWorld = t}), at(0.1f, -0.2f, 0.2f), true),
        shapeLamp("ConeFromOutside", makeCone({.objectToWorld = t}), at(0.9f, 0.3f, 0.8f)),
        shapeLamp("Paraboloid", makeParaboloid({.objectToWorld = t}), at(0.1f, 0.1f, 0.7f), true),
        shapeLamp("Hyperboloid",
                  makeHyperboloid({.objectToWorld = t, .p1 = Vec3(0.8f, 0.6f, -1), .p2 = Vec3(0.8f, -0.6f, 1)}),
                  at(0.2f, 0.1f, 0.3f), true),
        meshLamp("ImageOnAParallelogram", screen(), Vec3(0.2f, 0.1f, 0), false, picture(9, 7)),
        meshLamp("ImageOnTriangles", withCoordinates(fewTriangles()), Vec3(0, 0.5f, 0.8f), false, picture(8, 8)),
        meshLamp("ImageOnEachTriangle", fewTriangles(), Vec3(0, 0.5f, 0.8f), true, picture(5, 6)),
        meshLamp("ImageOnManyTriangles", withCoordinates(manyTriangles()), Vec3(0.3f, 0.2f, 0), false, picture(9, 9)),
        shapeLamp("ImageOnASphere", makeSphere({}), Vec3(1.2f, 0.9f, 1), true, picture(8, 6)),
        shapeLamp("ImageOnASphereFromWithin", makeSphere({.reverseOrientation = true}), Vec3(0.2f, 0.1f, 0.5f), false,
                  picture(8, 6)),
        shapeLamp("ImageOnAnEllipsoid", makeSphere({.objectToWorld = t}), at(0.1f, -0.3f, 0.2f), true, picture(8, 6)),
        shapeLamp("ImageOnADisk", makeDisk({.objectToWorld = t}), at(0.3f, -0.2f, 0.6f), false, picture(9, 5)),
        shapeLamp("ImageOnPartOfARing", makeDisk({.objectToWorld = t, .innerRadius = 0.4f, .phiMax = 250}),
                  at(0.1f, 0.2f, -0.5f), true, picture(9, 5)),
        shapeLamp("ImageOnACylinder", makeCylinder({.objectToWorld = t, .phiMax = 270}), at(0.4f, 0.1f, 0.3f), true,
                  picture(7, 5)),
        shapeLamp("ImageOnACone", makeCone({.objectToWorld = t}), at(0.1f, -0.2f, 0.2f), true, picture(7, 5)),
        shapeLamp("ImageOnAParaboloid", makeParaboloid({.objectToWorld = t, .zMin = 0.2f}), at(0.1f, 0.1f, 0.7f), true,
                  picture(7, 5)),
        shapeLamp("ImageOnAHyperboloid",
                  makeHyperboloid({.objectToWorld = t, .p1 = Vec3(0.8f, 0.6f, -1), .p2 = Vec3(0.8f, -0.6f, 1)}),
                  at(0.2f, 0.1f, 0.3f), true, picture(7, 5)),
    };
}

class AreaLightSampling : public testing::TestWithParam<Lamp> {};
INSTANTIATE_TEST_SUITE_P(EveryShape, AreaLightSampling, testing::ValuesIn(lamps()),
                         [](const auto& i) { return i.param.name; });

TEST_P(AreaLightSampling, DirectionsFollowTheDensity) {
    const Lamp& lamp = GetParam();
    const auto sample = [&](std::mt19937& rng) -> std::optional<Vec3> {
        const auto s = lamp.light->sample(lamp.from, uniform2(rng));
        if (!s) return std::nullopt;
        return s->wi;
    };
    const auto pdf = [&](const Vec3& w) {
        float sum = 0;
        lamp.crossings(lamp.from, w, [&](const EmitterHit& hit) {
            if (!isBlack(lamp.light->emitted(hit, -w))) sum += lamp.light->pdf(lamp.from, w, hit);
        });
        return sum;
    };
    // The density of an image has many edges.
    const ChiSquare r = chiSquareTest(sample, pdf, 20000, 7, lamp.hasImage ? 1e-6 : 1e-4);
    EXPECT_GT(r.pValue, kChiSquareLevel) << "chi2 " << r.statistic << " dof " << r.degreesOfFreedom;
    EXPECT_GT(r.degreesOfFreedom, 20) << "too small a part of the sphere to tell";
    EXPECT_LE(r.pdfIntegral, 1 + 2e-3);
    EXPECT_GT(r.pdfIntegral, 0.2);
}

EnvironmentMap patches(int width, int height, float lit) {
    EnvironmentMap m{width, height, {}};
    std::mt19937 rng(9);
    for (int i = 0; i < width * height; ++i) {
        const bool on = uniform(rng) < lit;
        m.texels.push_back(on ? Rgb(0.2f + uniform(rng)) : Rgb(0.f));
    }
    return m;
}

struct Sky {
    const char* name;
    LightPtr light;
};
void PrintTo(const Sky& sky, std::ostream* out) { *out << sky.name; }

std::vector<Sky> skies() {
    const Transform turned = Transform::rotate(70, Vec3(1, 2, 3)), none;
    EnvironmentMap sunny = patches(64, 32, 1);
    sunny.texels[10 * 64 + 25] = Rgb(300.f);
    return {{"Constant", makeInfiniteLight(turned, Rgb(2.f))},
            {"Map", makeInfiniteLight(none, Rgb(1.f), patches(16, 8, 1))},
            {"MapTurned", makeInfiniteLight(turned, Rgb(0.5f), patches(9, 7, 0.6f))},
            {"MapMirrored", makeInfiniteLight(Transform::scale(1, -1, 1), Rgb(1.f), patches(12, 10, 0.3f))},
            {"MapStretched", makeInfiniteLight(Transform::scale(1, 2, 3), Rgb(1.f), patches(16, 8, 1))},
            {"Sun", makeInfiniteLight(turned, Rgb(1.f), sunny)}};
}

class InfiniteLightSampling : public testing::TestWithParam<Sky> {};
INSTANTIATE_TEST_SUITE_P(EverySky, InfiniteLightSampling, testing::ValuesIn(skies()),
                         [](const auto& i) { return i.param.name; });

TEST_P(InfiniteLightSampling, DirectionsFollowTheDensity) {
    const Light& light = *GetParam().light;
    const auto sample = [&](std::mt19937& rng) -> std::optional<Vec3> {
        const auto s = light.sample(Vec3(1, 2, 3), uniform2(rng));
        if (!s) return std::nullopt;
        return s->wi;
    };
    const ChiSquare r = chiSquareTest(
        sample, [&](const Vec3& w) { return light.pdfEscaped(Vec3(0.f), w); }, 60000, 8, 4e-5);
    EXPECT_GT(r.pValue, kChiSquareLevel) << "chi2 " << r.statistic << " dof " << r.degreesOfFreedom;
    EXPECT_GT(r.degreesOfFreedom, 100);
    EXPECT_NEAR(r.pdfIntegral, 1, 2e-3);
}

}  // namespace
}  // namespace drc
