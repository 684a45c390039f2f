#include "scene/light.h"
#include "scene/shape_check.h"

namespace drc {
namespace {

// An irregular emitter: a quad of two triangles of different sizes, and a third, tilted triangle.
TriangleMeshPtr emitter(bool flip) {
    auto m = std::make_shared<TriangleMesh>();
    m->positions = {Vec3(-1, -1, 2), Vec3(2, -1, 2), Vec3(2, 1, 2), Vec3(-1, 0.3f, 2), Vec3(-2, 3, 1)};
    m->indices = {0, 2, 1, 0, 3, 2, 3, 4, 2};
    m->flipNormal = flip;
    return m;
}

// The nearest hit, found by solving for barycentric coordinates.
std::optional<EmitterHit> intersect(const TriangleMesh& m, const Vec3& o, const Vec3& d, float& nearest) {
    std::optional<EmitterHit> result;
    nearest = kInfinity;
    for (uint32_t i = 0; i < m.triangleCount(); ++i) {
        const Vec3 a = m.positions[m.indices[3 * i]], e1 = m.positions[m.indices[3 * i + 1]] - a,
                   e2 = m.positions[m.indices[3 * i + 2]] - a, h = cross(d, e2), s = o - a, q = cross(s, e1);
        const float det = dot(e1, h), u = dot(s, h) / det, v = dot(d, q) / det, t = dot(e2, q) / det;
        if (!(u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < nearest)) continue;
        nearest = t;
        EmitterHit hit;
        hit.p = o + d * t;
        hit.ng = m.geometricNormal(i);
        hit.triangle = i;
        result = hit;
    }
    return result;
}

void checkIrradiance(const TriangleMeshPtr& mesh, bool twoSided, const Vec3& p, int samples = 60000) {
    const auto light = makeMeshAreaLight(*mesh, Rgb(3, 2, 1), twoSided);
    Pcg32 rng(11);
    int differs = 0;
    RunningMean bySample[4], byDirection[4];
    for (int i = 0; i < samples; ++i) {
        double value = 0;
        Vec3 w(0, 0, 0);
        float t;
        if (const auto s = light->sample(p, rng.nextVec2())) {
            w = s->wi;
            const auto hit = intersect(*mesh, p, w, t);
            if (hit && std::abs(t - s->distance) < 1e-3f * t) {
                value = s->radiance.x / s->pdf;
                // Close to an edge, the ray may hit the adjacent triangle.
                differs += std::abs(light->pdf(p, w, *hit) - s->pdf) > 1e-3f * s->pdf ||
                           light->emitted(*hit, -w) != s->radiance;
            }
        }
        const Vec3 u = sampleUniformSphere(rng.nextVec2());
        const auto seen = intersect(*mesh, p, u, t);
        const double other = seen ? light->emitted(*seen, -u).x * 4 * kPi : 0;
        for (int k = 0; k < 4; ++k) {
            bySample[k].add(value * (k < 3 ? double(w[k]) : 1.0));
            byDirection[k].add(other * (k < 3 ? double(u[k]) : 1.0));
        }
    }
    EXPECT_LT(differs, samples / 500);
    for (int k = 0; k < 4; ++k) expectSame(bySample[k], byDirection[k], 1e-5, "moment");
}

TEST(MeshAreaLight, IrradianceMatchesUniformDirections) {
    checkIrradiance(emitter(false), false, Vec3(0, 0.5f, 0));
    checkIrradiance(emitter(true), false, Vec3(0, 0.5f, 3));
    checkIrradiance(emitter(false), true, Vec3(0.5f, 0.5f, 3));
}

TEST(MeshAreaLight, AParallelogramIsSampledAsOne) {
    // Two parallelograms with a triangle between them in the list; all have the same area except the triangle.
    TriangleMesh m;
    m.positions = {Vec3(0, 0, 1), Vec3(0, 1, 1), Vec3(2, 0, 1), Vec3(2, 1, 1), Vec3(5, 0, 1),
                   Vec3(5, 2, 1), Vec3(6, 0, 1), Vec3(8, 0, 1), Vec3(8, 1, 1), Vec3(6, 1, 1)};
    m.indices = {0, 1, 2, 2, 1, 3, 3, 5, 4, 6, 9, 7, 9, 8, 7};
    checkIrradiance(std::make_shared<TriangleMesh>(m), false, Vec3(3, 0.5f, 0));

    // With a single parallelogram, points are an affine image of the unit square.
    m.indices.resize(6);
    const auto light = makeMeshAreaLight(m, Rgb(1.f), true);
    const Vec3 p(0.5f, 0.5f, 0);
    const auto pointAt = [&](float u, float v) {
        const auto s = light->sample(p, Vec2(u, v));
        return s ? p + s->wi * s->distance : Vec3(kInfinity);
    };
    const Vec3 corner = pointAt(0, 0), u = pointAt(1 - 0x1p-24f, 0) - corner, v = pointAt(0, 1 - 0x1p-24f) - corner;
    EXPECT_NEAR(length(cross(u, v)), 2, 1e-5f);
    Pcg32 rng(3);
    for (int i = 0; i < 100; ++i) {
        const Vec2 at = rng.nextVec2();
        EXPECT_LT(length(pointAt(at.x, at.y) - (corner + u * at.x + v * at.y)), 1e-5f);
    }
}

// A mesh large enough for a light tree: a bumpy cap that faces down, and a part of it that faces away.
TriangleMeshPtr cap() {
    auto m = std::make_shared<TriangleMesh>();
    constexpr int kSide = 5;
    Pcg32 rng(2);
    for (int y = 0; y <= kSide; ++y)
        for (int x = 0; x <= kSide; ++x)
            m->positions.push_back(
                Vec3(float(x) - 2, float(y) - 2, 2 - 0.1f * sqr(float(x) - 2) + 0.3f * rng.nextFloat()));
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) {
            const uint32_t a = y * (kSide + 1) + x, b = a + 1, c = a + kSide + 1, d = c + 1;
            m->indices.insert(m->indices.end(), {a, d, b, a, c, d});
        }
    std::swap(m->indices[1], m->indices[2]);
    return m;
}

TEST(MeshAreaLight, ManyTrianglesGiveTheSameIrradiance) {
    checkIrradiance(cap(), false, Vec3(0, 0.5f, 0), 30000);
    checkIrradiance(cap(), true, Vec3(0.5f, 0.5f, 4), 30000);
}

TEST(MeshAreaLight, OfManyTrianglesThoseThatMatterAreChosen) {
    // Two emitting walls, far apart.
    auto m = std::make_shared<TriangleMesh>();
    for (int i = 0; i < 200; ++i) {
        const Vec3 at(i % 2 ? 100.f : 0.f, float(i / 2 % 10), float(i / 20));
        const auto first = uint32_t(m->positions.size());
        m->positions.insert(m->positions.end(), {at, at + Vec3(0, 0.5f, 0), at + Vec3(0, 0, 0.5f)});
        m->indices.insert(m->indices.end(), {first, first + 1, first + 2});
    }
    const auto light = makeMeshAreaLight(*m, Rgb(1.f), true);
    const Vec3 p(2, 5, 5);
    Pcg32 rng(1);
    int far = 0;
    for (int i = 0; i < 2000; ++i) far += light->sample(p, rng.nextVec2())->distance > 50;
    EXPECT_LT(far, 40);
    // Both walls face along x, so from there all of the light is visible.
    EXPECT_NEAR(std::abs(light->reach().axis.x), 1, 1e-4);
    EXPECT_NEAR(light->reach().intensity, 200 * 0.125f, 1e-2);
}

TEST(MeshAreaLight, ReachOfWhatFacesAllWays) {
    // Two triangles back to back emit in both directions, although not around a single axis.
    TriangleMesh m;
    m.positions = {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    m.indices = {0, 1, 2, 0, 2, 1};
    const auto light = makeMeshAreaLight(m, Rgb(1.f), false);
    EXPECT_EQ(light->reach().spread, kPi);
    EXPECT_NEAR(light->reach().intensity, 0.25f, 1e-5);
}

TEST(MeshAreaLight, EmitsFromTheSideOfTheNormal) {
    // The winding makes the quad face down.
    const auto light = makeMeshAreaLight(*emitter(false), Rgb(1.f), false);
    EXPECT_TRUE(light->sample(Vec3(0, 0, 0), Vec2(0.1f, 0.5f)));
    EXPECT_FALSE(light->sample(Vec3(0, 0, 4), Vec2(0.1f, 0.5f)));
    EXPECT_TRUE(makeMeshAreaLight(*emitter(true), Rgb(1.f), false)->sample(Vec3(0, 0, 4), Vec2(0.1f, 0.5f)));
    EXPECT_TRUE(makeMeshAreaLight(*emitter(false), Rgb(1.f), true)->sample(Vec3(0, 0, 4), Vec2(0.1f, 0.5f)));
}

TEST(MeshAreaLight, PowerAndBounds) {
    const TriangleMeshPtr mesh = emitter(false);
    const float area = mesh->area(0) + mesh->area(1) + mesh->area(2);
    EXPECT_NEAR(makeMeshAreaLight(*mesh, Rgb(2.f), false)->power(1).x, 2 * kPi * area, 1e-4);
    EXPECT_NEAR(makeMeshAreaLight(*mesh, Rgb(2.f), true)->power(1).x, 4 * kPi * area, 1e-4);
    EXPECT_EQ(makeMeshAreaLight(*mesh, Rgb(2.f), true)->bounds().max, Vec3(2, 3, 2));
    // An empty mesh emits nothing, and must not divide by zero.
    auto empty = std::make_shared<TriangleMesh>();
    EXPECT_FALSE(makeMeshAreaLight(*empty, Rgb(1.f), false)->sample(Vec3(0, 0, 0), Vec2(0.5f, 0.5f)));
}

}  // namespace
}  // namespace drc
