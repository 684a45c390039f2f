#include "scene/lobes/rough_diffuse.h"

#include "scene/lobes/lambert_reflection.h"
#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

// Both parts, whose sum is the model.
struct Whole {
    Whole(const Rgb& reflectance, float roughness)
        : separable(reflectance, roughness, DiffusePart::Separable), rest(reflectance, roughness, DiffusePart::Rest) {}
    Rgb f(const Vec3& wo, const Vec3& wi) const { return separable.f(wo, wi) + rest.f(wo, wi); }
    Rgb albedo(const Vec3& wo) const { return separable.albedo(wo) + rest.albedo(wo); }

    RoughDiffuse separable, rest;
};

// The albedo towards wo by quadrature: midpoints in the cosine and the azimuth.
template <class L>
Rgb integrated(const L& lobe, const Vec3& wo) {
    constexpr int kSteps = 300;
    double sum[3] = {};
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const float cosine = (float(i) + 0.5f) / kSteps;
            Vec3 wi = direction(cosine, 2 * kPi * (float(j) + 0.5f) / kSteps);
            if (wo.z < 0) wi.z = -wi.z;
            const Rgb f = lobe.f(wo, wi);
            for (int c = 0; c < 3; ++c) sum[c] += double(f[c] * cosine) * double(2 * kPi) / (kSteps * kSteps);
        }
    return Rgb(float(sum[0]), float(sum[1]), float(sum[2]));
}

TEST(RoughDiffuse, Sampling) {
    const Whole lobe(Rgb(0.7f), 0.8f);
    checkSampling(lobe.separable);
    checkSampling(lobe.rest);
}

TEST(RoughDiffuse, EnergyReciprocityAndAlbedo) {
    for (const float roughness : {0.05f, 0.4f, 1.f}) {
        const Whole coloured(Rgb(0.9f, 0.4f, 0.1f), roughness);
        for (const RoughDiffuse& part : {coloured.separable, coloured.rest}) {
            checkReciprocity(part);
            for (const float c : {-0.9f, 0.02f, 0.3f, 0.7f, 1.f})
                expectClose(part.albedo(direction(c)), integrated(part, direction(c)), 2e-3f, "albedo", 0.01f);
        }
    }
}

TEST(RoughDiffuse, NoPartIsNegative) {
    std::mt19937 rng(1);
    for (const float roughness : {0.05f, 0.4f, 1.f}) {
        // Of the rest, a clamp would hide a fault of this size: the sum must be the model's.
        const Whole lobe(Rgb(1.f), roughness);
        const float even = 1 / (kPi + roughness * (kPi / 2 - 2.f / 3));
        for (int i = 0; i < 1000; ++i) {
            const Vec3 wo = direction(uniform(rng), 6 * uniform(rng)), wi = direction(uniform(rng), 6 * uniform(rng));
            EXPECT_GE(lobe.separable.f(wo, wi).x, 0);
            EXPECT_GE(lobe.rest.f(wo, wi).x, 0);
            // Opposite directions: what is scattered once is even (1 - roughness sin sin).
            const Vec3 a = direction(0.3f, 0), b = direction(0.5f, kPi);
            const float once = even * (1 - roughness * std::sqrt(1 - 0.09f) * std::sqrt(1 - 0.25f));
            EXPECT_GE(lobe.f(a, b).x, once - 1e-6f);
        }
    }
}

TEST(RoughDiffuse, OnePartIsSeparable) {
    const Whole lobe(Rgb(0.9f, 0.4f, 0.1f), 0.6f);
    EXPECT_TRUE(lobe.separable.isSeparable());
    EXPECT_FALSE(lobe.rest.isSeparable());
    checkSeparable(lobe.separable);
    // Most of the light, so that caches have much to answer.
    EXPECT_GT(lobe.separable.albedo(direction(0.9f)).x, 0.6f * lobe.albedo(direction(0.9f)).x);
}

TEST(RoughDiffuse, WhiteLosesNothing) {
    for (const float roughness : {0.2f, 1.f})
        for (const float c : {-0.9f, 0.02f, 0.3f, 0.7f, 1.f}) {
            const Whole white(Rgb(1.f), roughness);
            EXPECT_NEAR(white.albedo(direction(c)).x, 1, 1e-5f);
            EXPECT_NEAR(integrated(white, direction(c)).x, 1, 1e-3f) << c;
        }
}

TEST(RoughDiffuse, WithoutRoughnessIsLambertian) {
    std::mt19937 rng(1);
    const Whole lobe(Rgb(0.5f), 0);
    for (int i = 0; i < 100; ++i) {
        const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
        expectClose(lobe.f(wo, wi), LambertReflection(Rgb(0.5f)).f(wo, wi), 1e-6f);
        expectClose(lobe.albedo(wo), Rgb(0.5f), 1e-6f);
    }
}

// Pictures of a plane under a sun by Blender 5.3: the radiance of a diffuse surface of roughness 1 and the reflectances
// 0.3, 1 and 0.1, divided by the cosine of the sun.
TEST(RoughDiffuse, IsBlenders) {
    const Whole lobe(Rgb(0.3f, 1.f, 0.1f), 1);
    const auto towards = [](float degrees, float azimuth) {
        const float t = degrees * kPi / 180, p = azimuth * kPi / 180;
        return Vec3(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t));
    };
    const auto expectSeen = [&](float sun, float azimuth, const Rgb& radiance) {
        const Rgb seen = lobe.f(towards(80, 0), towards(sun, azimuth)) * std::cos(sun * kPi / 180);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c] / radiance[c], 1, 1e-4f) << sun << " " << azimuth << " " << c;
    };
    expectSeen(45, 180, Rgb(0.01680928f, 0.06432933f, 0.00540228f));
    expectSeen(75, 70, Rgb(0.04343965f, 0.14594163f, 0.01445223f));
    expectSeen(75, 180, Rgb(0.00105793f, 0.004669f, 0.00032499f));
}

}  // namespace
}  // namespace drc
