// For tests: properties that every lobe must have.
#pragma once
#include <gtest/gtest.h>

#include "scene/chi_square.h"
#include "scene/lobes/lobe.h"
#include "scene/lobes/local_directions.h"

namespace drc::test {

inline float uniform(std::mt19937& rng) { return float(rng() >> 8) * 0x1p-24f; }
inline Vec2 uniform2(std::mt19937& rng) {
    const float x = uniform(rng);
    return Vec2(x, uniform(rng));
}
inline Vec3 randomDirection(std::mt19937& rng) {
    const float z = 1 - 2 * uniform(rng), r = safeSqrt(1 - z * z), phi = 2 * kPi * uniform(rng);
    return Vec3(r * std::cos(phi), r * std::sin(phi), z);
}
inline Vec3 direction(float cosTheta, float phi = 0.7f) {
    const float r = safeSqrt(1 - cosTheta * cosTheta);
    return Vec3(r * std::cos(phi), r * std::sin(phi), cosTheta);
}
// The tolerance is relative to the larger value, or to `least` if both are smaller.
inline void expectClose(const Rgb& a, const Rgb& b, float relative, const char* what = "", float least = 1e-4f) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(a[c], b[c], relative * std::max({std::abs(a[c]), std::abs(b[c]), least})) << what << " " << c;
}

// Checks sample() against pdf() and f(): the distribution, pdfs that integrate to at most one, and equal values.
template <typename L>
void checkSampling(const L& lobe, std::vector<float> cosines = {0.97f, 0.4f, 0.08f, -0.6f}) {
    for (const float c : cosines) {
        SCOPED_TRACE("cos theta_o = " + std::to_string(c));
        const Vec3 wo = direction(c);
        const auto sample = [&](std::mt19937& rng) -> std::optional<Vec3> {
            const float uLobe = uniform(rng);
            const LobeSample s = lobe.sample(wo, uLobe, uniform2(rng), TransportMode::Radiance);
            if (!(s.pdf > 0)) return std::nullopt;
            return s.wi;
        };
        const ChiSquare r = chiSquareTest(
            sample, [&](const Vec3& wi) { return lobe.pdf(wo, wi); }, 60000, 1);
        EXPECT_GT(r.pValue, kChiSquareLevel) << "chi2 " << r.statistic << " dof " << r.degreesOfFreedom;
        EXPECT_LE(r.pdfIntegral, 1 + 1e-3);

        std::mt19937 rng(2);
        for (int i = 0; i < 1000; ++i) {
            const float uLobe = uniform(rng);
            const LobeSample s = lobe.sample(wo, uLobe, uniform2(rng), TransportMode::Radiance);
            if (!(s.pdf > 0)) continue;
            EXPECT_NEAR(length(s.wi), 1, 1e-4);
            EXPECT_TRUE(LobeMask(lobe.flags()).has(s.flags, lobe.alpha()));
            EXPECT_NEAR(s.pdf, lobe.pdf(wo, s.wi), 1e-4f * s.pdf);
            expectClose(s.f, lobe.f(wo, s.wi), 1e-4f, "f");
        }
    }
}

// The albedo of the lobe: the mean weight of samples, without the scaling of radiance by refraction.
template <typename L>
Rgb furnace(const L& lobe, const Vec3& wo, int samples = 20000) {
    std::mt19937 rng(3);
    double sum[3] = {};
    for (int i = 0; i < samples; ++i) {
        const float uLobe = uniform(rng);
        const LobeSample s = lobe.sample(wo, uLobe, uniform2(rng), TransportMode::Radiance);
        if (!(s.pdf > 0)) continue;
        for (int c = 0; c < 3; ++c) sum[c] += double(s.f[c]) * sqr(s.eta) * absCosTheta(s.wi) / s.pdf;
    }
    return Rgb(float(sum[0] / samples), float(sum[1] / samples), float(sum[2] / samples));
}

template <typename L>
void checkEnergy(const L& lobe, float tolerance = 0.01f) {
    for (float c = -0.95f; c < 1; c += 0.1f) EXPECT_LE(maxComponent(furnace(lobe, direction(c))), 1 + tolerance) << c;
}

// f(wo, wi) = f(wi, wo).
template <typename L>
void checkReciprocity(const L& lobe) {
    std::mt19937 rng(4);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
        if (sameHemisphere(wo, wi)) expectClose(lobe.f(wo, wi), lobe.f(wi, wo), 1e-3f, "reciprocity");
    }
}

// f(wo, wi) = viewFactor(wo) g(wi): the quotient of two views is the same for all directions of the light.
template <typename L>
void checkSeparable(const L& lobe) {
    std::mt19937 rng(5);
    for (int i = 0; i < 2000; ++i) {
        Vec3 a = randomDirection(rng), b = randomDirection(rng);
        if (!sameHemisphere(a, b)) b = -b;
        const Vec3 wi = randomDirection(rng);
        expectClose(lobe.f(a, wi) * lobe.viewFactor(b), lobe.f(b, wi) * lobe.viewFactor(a), 1e-4f, "separable");
    }
}

// Checks that albedo() is within `absolute` of the lobe's true albedo.
template <typename L>
void checkAlbedo(const L& lobe, float absolute) {
    for (const float c : {-0.8f, 0.3f, 0.9f})
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(lobe.albedo(direction(c))[k], furnace(lobe, direction(c))[k], absolute) << c;
}

}  // namespace drc::test
