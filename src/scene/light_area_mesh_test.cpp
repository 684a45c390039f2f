#include "scene/light.h"
#include "scene/shape_check.h"

namespace drc {
namespace {

// An irregular emitter: a quad made of two triangles of different size, and a third one, tilted.
TriangleMeshPtr emitter(bool flip) {
    auto m = std::make_shared<TriangleMesh>();
    m->positions = {Vec3(-1, -1, 2), Vec3(2, -1, 2), Vec3(2, 1, 2), Vec3(-1, 0.3f, 2), Vec3(-2, 3, 1)};
    m->indices = {0, 2, 1, 0, 3, 2, 3, 4, 2};
    m->flipNormal = flip;
    return m;
}

// Nearest hit, by solving for barycentric coordinates.
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

void checkIrradiance(bool flip, bool twoSided, const Vec3& p) {
    const TriangleMeshPtr mesh = emitter(flip);
    const auto light = makeMeshAreaLight(*mesh, Rgb(3, 2, 1), twoSided);
    Pcg32 rng(11);
    RunningMean bySample[4], byDirection[4];
    for (int i = 0; i < 60000; ++i) {
        double value = 0;
        Vec3 w(0, 0, 0);
        float t;
        if (const auto s = light->sample(p, rng.nextVec2())) {
            w = s->wi;
            const auto hit = intersect(*mesh, p, w, t);
            if (hit && std::abs(t - s->distance) < 1e-3f * t) {
                value = s->radiance.x / s->pdf;
                EXPECT_NEAR(light->pdf(p, w, *hit), s->pdf, 1e-3f * s->pdf);
                EXPECT_EQ(light->emitted(*hit, -w), s->radiance);
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
    for (int k = 0; k < 4; ++k) expectSame(bySample[k], byDirection[k], 1e-5, "moment");
}

TEST(MeshAreaLight, IrradianceMatchesUniformDirections) {
    checkIrradiance(false, false, Vec3(0, 0.5f, 0));
    checkIrradiance(true, false, Vec3(0, 0.5f, 3));
    checkIrradiance(false, true, Vec3(0.5f, 0.5f, 3));
}

TEST(MeshAreaLight, EmitsFromTheSideOfTheNormal) {
    // The winding makes the quad look down.
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
    // No area, no light; and no division by zero.
    auto empty = std::make_shared<TriangleMesh>();
    EXPECT_FALSE(makeMeshAreaLight(*empty, Rgb(1.f), false)->sample(Vec3(0, 0, 0), Vec2(0.5f, 0.5f)));
}

}  // namespace
}  // namespace drc
