#include "scene/lights/light.h"
#include "scene/shapes/shape_check.h"

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
        const auto uvs = m.textureCoordinates(i);
        hit.uv = uvs[0] * (1 - u - v) + uvs[1] * u + uvs[2] * v;
        result = hit;
    }
    return result;
}

void checkIrradiance(const TriangleMeshPtr& mesh, bool twoSided, const Vec3& p, int samples = 60000,
                     const Emission& emission = Rgb(3, 2, 1)) {
    const auto light = makeMeshAreaLight(*mesh, emission, twoSided);
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
                           length(light->emitted(*hit, -w) - s->radiance) > 1e-3f * length(s->radiance);
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

// Dark, with a bright corner and a bright stripe.
Emission shown(int side) {
    LightImage image{side, side, {}};
    for (int i = 0; i < side * side; ++i) {
        const int x = i % side, y = i / side;
        const bool bright = (x < side / 8 && y < side / 8) || x == side * 3 / 4;
        image.texels.push_back(bright ? Rgb(8, 7, 6) : Rgb(0.1f));
    }
    return {std::make_shared<EmissionImage>(std::move(image)), Rgb(1.f)};
}
TriangleMeshPtr withCoordinates(TriangleMesh m) {
    for (const Vec3& p : m.positions) m.uvs.push_back(Vec2(0.25f * (p.x + 2), 0.25f * (p.y + 2)));
    return std::make_shared<TriangleMesh>(std::move(m));
}

TEST(MeshAreaLight, AnImageGivesTheSameIrradiance) {
    checkIrradiance(withCoordinates(*emitter(false)), false, Vec3(0, 0.5f, 0), 60000, shown(16));
    checkIrradiance(emitter(false), true, Vec3(0.5f, 0.5f, 3), 60000, shown(8));
    checkIrradiance(withCoordinates(*cap()), false, Vec3(0, 0.5f, 0), 30000, shown(32));
    checkIrradiance(withCoordinates(*cap()), true, Vec3(0.5f, 0.5f, 4), 30000, shown(8));
}

// Variance of the irradiance that a far light causes, in units of its square, for one sample.
double relativeVariance(const AreaLight& light, const Vec3& p) {
    Pcg32 rng(4);
    RunningMean mean;
    constexpr int kSamples = 20000;
    for (int i = 0; i < kSamples; ++i) {
        const auto s = light.sample(p, rng.nextVec2());
        mean.add(s ? double(luminance(s->radiance) / s->pdf) : 0.0);
    }
    return mean.variance() * kSamples / (mean.mean() * mean.mean());
}

TEST(MeshAreaLight, AnImageIsSampledByWhatItEmits) {
    // By area, the relative variance would be that of the image: mean of squares over square of mean, minus 1.
    const Emission image = shown(64);
    double sum = 0, squares = 0;
    for (int i = 0; i < 256 * 256; ++i) {
        const double l =
            double(luminance(image.at(Vec2((float(i % 256) + 0.5f) / 256, (float(i / 256) + 0.5f) / 256))));
        sum += l / (256 * 256);
        squares += l * l / (256 * 256);
    }
    const double byArea = squares / (sum * sum) - 1;
    EXPECT_GT(byArea, 10);
    TriangleMesh quad;
    quad.positions = {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0)};
    quad.uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    quad.indices = {0, 1, 2, 0, 2, 3};
    const Vec3 far(0, 0, 50);
    const double whole = relativeVariance(*makeMeshAreaLight(quad, image, false), far);
    EXPECT_LT(whole, 0.1 * byArea);
    // On a single triangle, and on many.
    TriangleMesh half = quad;
    half.indices.resize(3);
    EXPECT_LT(relativeVariance(*makeMeshAreaLight(half, image, false), far), 0.1 * byArea);
    TriangleMesh many;
    constexpr uint32_t kSide = 16;
    for (uint32_t y = 0; y <= kSide; ++y)
        for (uint32_t x = 0; x <= kSide; ++x) {
            many.uvs.emplace_back(float(x) / kSide, float(y) / kSide);
            many.positions.emplace_back(2 * many.uvs.back().x - 1, 2 * many.uvs.back().y - 1, 0.f);
        }
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) {
            const uint32_t a = y * (kSide + 1) + x, b = a + 1, c = a + kSide + 1, d = c + 1;
            many.indices.insert(many.indices.end(), {a, b, d, a, d, c});
        }
    EXPECT_LT(relativeVariance(*makeMeshAreaLight(many, image, false), far), 0.15 * byArea);
    RecordProperty("byArea", std::to_string(byArea));
    RecordProperty("byImage", std::to_string(whole));
}

TEST(MeshAreaLight, PowerAndReachAreThoseOfTheImage) {
    LightImage image{2, 1, {Rgb(1.f), Rgb(3.f)}};
    const Emission halves(std::make_shared<EmissionImage>(image), Rgb(1, 2, 3));
    TriangleMesh quad;
    quad.positions = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(0, 1, 0)};
    quad.uvs = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    quad.indices = {0, 1, 2, 0, 2, 3};
    const auto light = makeMeshAreaLight(quad, halves, false);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(light->power(1)[c], kPi * 2 * 2 * float(c + 1), 1e-3f);
    EXPECT_NEAR(light->reach().intensity, 4 * luminance(Rgb(1, 2, 3)), 0.05f);
    // Of a part of the image, only that part.
    for (Vec2& uv : quad.uvs) uv.x *= 0.25f;
    EXPECT_NEAR(makeMeshAreaLight(quad, halves, true)->power(1).x, kPi * 2 * 2, 1e-3f);
    // Nothing where it is black.
    const Emission black(std::make_shared<EmissionImage>(LightImage{1, 1, {Rgb(0.f)}}), Rgb(1.f));
    const auto none = makeMeshAreaLight(quad, black, false);
    EXPECT_FALSE(none->sample(Vec3(1, 0.5f, 1), Vec2(0.3f, 0.4f)));
    EXPECT_FALSE(none->emit(Vec2(0.3f, 0.4f), Vec2(0.3f, 0.4f), {}));
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
