#include "scene/lights/light.h"
#include "scene/shapes/shape_check.h"

namespace drc {
namespace {

EnvironmentMap randomMap(int width, int height, float lit) {
    EnvironmentMap m{width, height, {}};
    Pcg32 rng(9);
    for (int i = 0; i < width * height; ++i) {
        const bool on = rng.nextFloat() < lit;
        const float r = rng.nextFloat(), g = rng.nextFloat(), b = rng.nextFloat();
        m.texels.push_back(on ? Rgb(r, g, b) * 10.f : Rgb(0.f));
    }
    return m;
}

Vec3 direction(float theta, float phi) {
    return Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
}

// Compares sample() with uniform directions, by the means of radiance times moments, and its pdf with pdfEscaped().
void checkSampling(const Light& light, int samples = 60000) {
    Pcg32 rng(3);
    RunningMean bySample[4], byDirection[4], density;
    for (int i = 0; i < samples; ++i) {
        const auto s = light.sample(Vec3(0, 0, 0), rng.nextVec2());
        for (int k = 0; k < 4; ++k)
            bySample[k].add(s ? light.escaped(Vec3(0.f), s->wi).y / s->pdf * (k < 3 ? 1 + double(s->wi[k]) : 1.0)
                              : 0.0);
        if (s) {
            EXPECT_NEAR(length(s->wi), 1, 1e-5);
            EXPECT_EQ(s->distance, kInfinity);
            EXPECT_TRUE(isBlack(s->radiance)) << "escaped() has it";
            // A direction exactly at the edge of a texel may be looked up in the adjacent one.
            const float pdf = light.pdfEscaped(Vec3(0.f), s->wi);
            density.add(std::abs(pdf - s->pdf) > 1e-3f * s->pdf);
        }
        const Vec3 u = sampleUniformSphere(rng.nextVec2());
        const Rgb radiance = light.escaped(Vec3(0.f), u);
        for (int k = 0; k < 4; ++k) byDirection[k].add(radiance.y * 4 * kPi * (k < 3 ? 1 + double(u[k]) : 1.0));
        EXPECT_TRUE(isBlack(radiance) || light.pdfEscaped(Vec3(0.f), u) > 0);
    }
    EXPECT_LT(density.mean(), 1e-3);
    for (int k = 0; k < 4; ++k) expectSame(bySample[k], byDirection[k], 1e-4, "moment");
    // pdfEscaped integrates to one.
    RunningMean integral;
    for (int i = 0; i < samples; ++i)
        integral.add(light.pdfEscaped(Vec3(0.f), sampleUniformSphere(rng.nextVec2())) * 4 * kPi);
    EXPECT_NEAR(integral.mean(), 1, 4 * std::sqrt(integral.variance()) + 1e-4);
}

// A smooth sky is sampled by large cells, but a sun of a single texel by that texel, as the pdf shows.
TEST(InfiniteLight, CellsAreCoarseOnlyWhereThatCostsNothing) {
    EnvironmentMap sky{256, 128, {}};
    sky.texels.resize(256 * 128);
    for (size_t i = 0; i < sky.texels.size(); ++i) sky.texels[i] = Rgb(1 + 0.5f * std::sin(float(i / 256) * 0.02f));
    EnvironmentMap sunny = sky;
    sunny.texels[40 * 256 + 100] = Rgb(2e4f);
    const auto at = [](float column, float row) { return direction(row * kPi / 128, column * 2 * kPi / 256); };
    const LightPtr plain = makeInfiniteLight(Transform(), Rgb(1.f), sky);
    const LightPtr sun = makeInfiniteLight(Transform(), Rgb(1.f), sunny);
    checkSampling(*plain);
    checkSampling(*sun, 400000);
    // Texels of a cell have equal pdf. That of the sun is far larger than that of a texel two away.
    EXPECT_FLOAT_EQ(plain->pdfEscaped(Vec3(0.f), at(104.5f, 40.5f)), plain->pdfEscaped(Vec3(0.f), at(110.5f, 46.5f)));
    EXPECT_GT(sun->pdfEscaped(Vec3(0.f), at(100.5f, 40.5f)), 100 * sun->pdfEscaped(Vec3(0.f), at(102.5f, 40.5f)));
}

TEST(InfiniteLight, ConstantIsUniform) {
    const LightPtr light = makeInfiniteLight(Transform(), Rgb(1, 2, 3));
    EXPECT_TRUE(light->isInfinite());
    EXPECT_FALSE(light->isDelta());
    EXPECT_EQ(light->escaped(Vec3(0.f), Vec3(0, 0, 1)), Rgb(1, 2, 3));
    EXPECT_NEAR(light->pdfEscaped(Vec3(0.f), direction(0.01f, 2)), uniformSpherePdf(), 1e-6);
    EXPECT_NEAR(light->sample(Vec3(0, 0, 0), Vec2(0.1f, 0.2f))->pdf, uniformSpherePdf(), 1e-6);
    EXPECT_NEAR(light->power(2).y, 2 * kPi * 4, 1e-4);
    checkSampling(*light);
}

TEST(InfiniteLight, LooksUpAsPbrt) {
    EnvironmentMap m{4, 2, {}};
    for (int i = 0; i < 8; ++i) m.texels.push_back(Rgb(float(i), 0, 0));
    const LightPtr light = makeInfiniteLight(Transform(), Rgb(2.f), m);
    // Centre of texel (1, 0): phi = 2 pi 1.5 / 4, theta = pi / 4.
    EXPECT_NEAR(light->escaped(Vec3(0.f), direction(kPi / 4, 0.75f * kPi)).x, 2, 1e-5);
    EXPECT_NEAR(light->escaped(Vec3(0.f), direction(3 * kPi / 4, 1.75f * kPi)).x, 14, 1e-5);
    // Between texels (0,0), (1,0), (0,1), (1,1).
    EXPECT_NEAR(light->escaped(Vec3(0.f), direction(kPi / 2, kPi / 2)).x, 2 * (0 + 1 + 4 + 5) / 4.f, 1e-5);
    // phi = 0: between columns 3 and 0, of row 0.
    EXPECT_NEAR(light->escaped(Vec3(0.f), direction(kPi / 4, 0)).x, 3, 1e-5);
    // At a pole the first row and the last are interpolated.
    EXPECT_NEAR(light->escaped(Vec3(0.f), direction(1e-4f, 0.75f * kPi)).x, 2 * (1 + 5) / 2.f, 1e-2);
    // The light's own z axis points towards world x.
    const Transform t = Transform::rotate(90, Vec3(0, 1, 0));
    const LightPtr turned = makeInfiniteLight(t, Rgb(2.f), m);
    EXPECT_NEAR(turned->escaped(Vec3(0.f), t.vector(direction(kPi / 4, 0.75f * kPi))).x, 2, 1e-5);
}

TEST(InfiniteLight, SamplingMatchesDensity) {
    checkSampling(*makeInfiniteLight(Transform(), Rgb(1.f), randomMap(16, 8, 1)));
    checkSampling(*makeInfiniteLight(Transform::rotate(70, Vec3(1, 2, 3)), Rgb(1.f), randomMap(9, 7, 0.1f)));
    checkSampling(*makeInfiniteLight(Transform::scale(1, -1, 1), Rgb(0.5f), randomMap(32, 16, 0.02f)));
    // A transform that is not a rotation changes the pdf.
    checkSampling(*makeInfiniteLight(Transform::scale(1, 2, 3), Rgb(1.f), randomMap(16, 8, 1)));
}

TEST(InfiniteLight, BlackAndBrokenMaps) {
    EnvironmentMap black{2, 2, std::vector<Rgb>(4, Rgb(0.f))};
    const LightPtr light = makeInfiniteLight(Transform(), Rgb(1.f), black);
    EXPECT_TRUE(isBlack(light->power(1)));
    EXPECT_TRUE(isBlack(light->escaped(Vec3(0.f), Vec3(0, 0, 1))));
    EnvironmentMap broken{2, 1, {Rgb(NAN, 0, 0), Rgb(1, 1, 1)}};
    EXPECT_TRUE(isFinite(makeInfiniteLight(Transform(), Rgb(1.f), broken)->escaped(Vec3(0.f), Vec3(0, 0, 1))));
}

TEST(InfiniteLight, InverseGivesBackTheRandomNumbers) {
    for (const Transform& t : {Transform(), Transform::rotate(70, Vec3(1, 2, 3)), Transform::scale(-1, 1, 1)}) {
        const LightPtr light = makeInfiniteLight(t, Rgb(1.f), randomMap(32, 16, 0.7f));
        Pcg32 rng(4);
        int far = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vec2 u = rng.nextVec2();
            const auto s = light->sample(Vec3(0, 0, 0), u);
            ASSERT_TRUE(s);
            // A direction exactly at the edge of a cell may be assigned to the adjacent one.
            far += (light->inverse(Vec3(0.f), s->wi) - u).length() > 1e-3f;
        }
        EXPECT_LE(far, 4);
    }
}

}  // namespace
}  // namespace drc
