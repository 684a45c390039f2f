// Compares every delta light with the formulas in PBR 3e, sections 12.3 and 12.4, at random points.
#include <functional>

#include "math/rng.h"
#include "scene/lights/light_testing.h"

namespace drc {
namespace {

// The lights are at kPlace, rotated and scaled by 1.5.
const Vec3 kPlace(1, -2, 0.5f);
Transform placed() {
    return Transform::translate(kPlace) * Transform::rotate(50, Vec3(2, -1, 3)) * Transform::scale(1.5f, 1.5f, 1.5f);
}

// An image in which no two texels are equal.
LightImage picture() {
    LightImage image{5, 3, {}};
    for (int i = 0; i < 15; ++i) image.texels.push_back(Rgb(1 + 0.1f * float(i), 0.5f, 2 - 0.1f * float(i)));
    return image;
}

struct DeltaLight {
    const char* name;
    LightPtr light;
    // Share of the light's intensity towards a unit vector in its own space.
    std::function<Rgb(const Vec3& w)> share;
};
void PrintTo(const DeltaLight& light, std::ostream* out) { *out << light.name; }

const Rgb kIntensity(3, 5, 7);

std::vector<DeltaLight> deltaLights() {
    const auto falloff = [](const Vec3& w) {  // of a cone of 60 degrees, the outer 25 fading
        const double edge = std::cos(60 * std::numbers::pi / 180), full = std::cos(35 * std::numbers::pi / 180);
        return std::clamp((double(w.z) - edge) / (full - edge), 0.0, 1.0);
    };
    const auto projected = [](const Vec3& w) {  // 80 degrees of the shorter side, 5 texels by 3
        const float tangent = std::tan(40 * kPi / 180);
        const Vec2 at(w.x / w.z / (tangent * 5 / 3), w.y / w.z / tangent);
        if (w.z <= 0 || std::abs(at.x) > 1 || std::abs(at.y) > 1) return Rgb(0.f);
        return picture().lookup(Vec2(0.5f + 0.5f * at.x, 0.5f + 0.5f * at.y), false);
    };
    const auto measured = [](const Vec3& w) {  // about +y, from +x towards +z
        float phi = std::atan2(w.z, w.x) / (2 * kPi);
        if (phi < 0) phi += 1;
        return picture().lookup(Vec2(phi, std::acos(w.y) / kPi), true);
    };
    return {
        {"Point", makePointLight(kPlace, kIntensity), [](const Vec3&) { return Rgb(1.f); }},
        {"Spot", makeSpotLight(placed(), kIntensity, {60, 25}),
         [=](const Vec3& w) { return Rgb(float(std::pow(falloff(w), 4))); }},
        {"SmoothSpot", makeSpotLight(placed(), kIntensity, {60, 25, SpotEdge::Smooth}),
         [=](const Vec3& w) { return Rgb(float(falloff(w) * falloff(w) * (3 - 2 * falloff(w)))); }},
        {"Goniometric", makeGoniometricLight(placed(), kIntensity, picture()), measured},
        {"Projection", makeProjectionLight(placed(), kIntensity, 80, picture()), projected},
    };
}

class DeltaLights : public testing::TestWithParam<DeltaLight> {};
INSTANTIATE_TEST_SUITE_P(Every, DeltaLights, testing::ValuesIn(deltaLights()),
                         [](const auto& i) { return i.param.name; });

TEST_P(DeltaLights, BringTheirIntensityOverTheSquaredDistance) {
    const Light& light = *GetParam().light;
    EXPECT_TRUE(light.isDelta());
    EXPECT_FALSE(light.isInfinite());
    Pcg32 rng(5);
    int lit = 0, dark = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 w = sampleUniformSphere(rng.nextVec2());  // from the light, in world space
        const float distance = 0.1f + 9 * rng.nextFloat();
        const Rgb expected =
            kIntensity * GetParam().share(normalize(placed().inverse().vector(w))) * (1 / sqr(distance));
        const auto s = light.sample(kPlace + w * distance, rng.nextVec2());
        if (!s) {
            EXPECT_LT(maxComponent(expected) * sqr(distance), 1e-3f);
            ++dark;
            continue;
        }
        ++lit;
        EXPECT_LT(length(s->wi + w), 1e-5f);
        EXPECT_NEAR(s->distance, distance, 1e-5f * distance + 1e-6f);
        EXPECT_EQ(s->pdf, 1);
        EXPECT_TRUE(s->delta);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(s->radiance[c] * sqr(distance), expected[c] * sqr(distance), 2e-3f) << "towards " << w;
    }
    EXPECT_GT(lit, 200);
    const std::string name = GetParam().name;
    const bool allAround = name == "Point" || name == "Goniometric";
    EXPECT_EQ(dark == 0, allAround) << dark;
}

TEST(DistantLight, BringsItsRadianceFromOneDirectionEverywhere) {
    const LightPtr light = makeDistantLight(Vec3(2, -1, 2), kIntensity);
    Pcg32 rng(6);
    for (int i = 0; i < 100; ++i) {
        const auto s = light->sample(Vec3(rng.nextFloat(), rng.nextFloat(), rng.nextFloat()) * 1e4f, rng.nextVec2());
        ASSERT_TRUE(s);
        EXPECT_LT(length(s->wi - Vec3(2, -1, 2) / 3.f), 1e-6f);
        EXPECT_EQ(s->radiance, kIntensity);
        EXPECT_EQ(s->pdf, 1);
        EXPECT_EQ(s->distance, kInfinity);
        EXPECT_TRUE(s->delta);
    }
    // A delta light is only found by light sampling; rays that escape must not see it.
    EXPECT_TRUE(isBlack(light->escaped(Vec3(0.f), Vec3(2, -1, 2) / 3.f)));
    EXPECT_EQ(light->pdfEscaped(Vec3(0.f), Vec3(2, -1, 2) / 3.f), 0);
}

}  // namespace
}  // namespace drc
