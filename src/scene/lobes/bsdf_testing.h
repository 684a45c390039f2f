// For tests: properties that every Bsdf must have, whatever its lobes.
#pragma once
#include "scene/lobes/bsdf.h"
#include "scene/lobes/lobe_testing.h"

namespace drc::test {

// Checks sample() against pdf() and f() for a mask. Specular samples count as none, because they have no pdf.
inline void checkBsdf(const Bsdf& bsdf, const LobeMask& mask, std::vector<float> cosines = {0.9f, 0.25f, -0.7f}) {
    for (const float c : cosines) {
        SCOPED_TRACE("cos theta_o = " + std::to_string(c) + ", mask " + std::to_string(int(mask.flags)));
        const Vec3 wo = bsdf.frame().toWorld(direction(c));
        const auto draw = [&](std::mt19937& rng) {
            const float uLobe = uniform(rng);
            return bsdf.sample(wo, uLobe, uniform2(rng), mask);
        };
        const auto sample = [&](std::mt19937& rng) -> std::optional<Vec3> {
            const auto s = draw(rng);
            if (!s || s->isSpecular()) return std::nullopt;
            return s->wi;
        };
        // Where the BSDF is zero, having a sample or none makes no difference.
        const auto pdf = [&](const Vec3& wi) { return isBlack(bsdf.f(wo, wi, mask)) ? 0.f : bsdf.pdf(wo, wi, mask); };
        const ChiSquare r = chiSquareTest(sample, pdf, 50000, 11);
        EXPECT_GT(r.pValue, kChiSquareLevel) << "chi2 " << r.statistic << " dof " << r.degreesOfFreedom;
        EXPECT_LE(r.pdfIntegral, 1 + 1e-3);

        std::mt19937 rng(12);
        for (int i = 0; i < 500; ++i) {
            const auto s = draw(rng);
            if (!s) continue;
            EXPECT_NEAR(length(s->wi), 1, 1e-4);
            EXPECT_GT(s->pdf, 0);
            EXPECT_TRUE(isFinite(s->f));
            if (s->isSpecular()) continue;
            const float cosine = absDot(s->wi, bsdf.frame().n);
            const float pdfAgain = bsdf.pdf(wo, s->wi, mask);
            EXPECT_NEAR(s->pdf, pdfAgain, 5e-3f * s->pdf);
            expectClose(s->f * (cosine / s->pdf), bsdf.f(wo, s->wi, mask) * (cosine / pdfAgain), 5e-3f, "weight");
        }
    }
}

// Mean weight of samples and the standard error of its largest channel.
struct Mean {
    Rgb value{0.f};
    float error = 0;
};
inline Mean meanWeight(
    const Bsdf& bsdf, const Vec3& wo, const LobeMask& mask = LobeFlags::All, int samples = 20000,
    TransportMode mode = TransportMode::Importance,
    float (*scale)(const BsdfSample&) = [](const BsdfSample&) { return 1.f; }) {
    std::mt19937 rng(13);
    double sum[3] = {}, squares = 0;
    for (int i = 0; i < samples; ++i) {
        const float uLobe = uniform(rng);
        const auto s = bsdf.sample(wo, uLobe, uniform2(rng), mask, mode);
        if (!s) continue;
        const Rgb w = s->f * (absDot(s->wi, bsdf.frame().n) / s->pdf * scale(*s));
        for (int c = 0; c < 3; ++c) sum[c] += w[c];
        squares += sqr(maxComponent(w));
    }
    Mean m;
    for (int c = 0; c < 3; ++c) m.value[c] = float(sum[c] / samples);
    m.error = float(std::sqrt(std::max(0.0, squares / samples - sqr(maxComponent(m.value))) / samples));
    return m;
}

// The factor by which a sample's radiance must be multiplied to be a share of the light that arrives: refraction scales
// radiance. In importance mode nothing is scaled, but a BSDF that is not reciprocal has another mean there. If a
// surface both refracts and transmits without a change of medium, no one factor fits, and importance mode must do.
enum class Furnace { OfImportance, OfRadiance };
inline Mean albedoBySamples(const Bsdf& bsdf, const Vec3& wo, Furnace furnace, const LobeMask& mask = LobeFlags::All,
                            int samples = 20000) {
    if (furnace == Furnace::OfImportance) return meanWeight(bsdf, wo, mask, samples);
    return meanWeight(bsdf, wo, mask, samples, TransportMode::Radiance, [](const BsdfSample& s) { return sqr(s.eta); });
}

// Checks that no more light is scattered than arrives.
inline void checkBsdfEnergy(const Bsdf& bsdf, Furnace furnace = Furnace::OfImportance) {
    for (float c = -0.95f; c < 1; c += 0.2f) {
        const Mean m = albedoBySamples(bsdf, bsdf.frame().toWorld(direction(c)), furnace);
        EXPECT_LE(maxComponent(m.value), 1 + 1e-3f + 4 * m.error) << c;
    }
}

// Checks that the mean weight of the non-specular lobes is the integral of f cos.
inline void checkUnbiased(const Bsdf& bsdf, const LobeMask& mask = LobeFlags::NonSpecular) {
    for (const float c : {0.8f, -0.4f}) {
        const Vec3 wo = bsdf.frame().toWorld(direction(c));
        const Mean m = meanWeight(bsdf, wo, mask, 100000, TransportMode::Radiance);
        const double exact = integrateSphere(
            [&](const Vec3& wi) { return maxComponent(bsdf.f(wo, wi, mask)) * absDot(wi, bsdf.frame().n); }, 1e-5);
        EXPECT_NEAR(maxComponent(m.value), exact, 5 * m.error + 2e-3) << c;
    }
}

// Checks reciprocity: a camera path transports from wi to wo what a light path transports from wo to wi. Pairs on whose
// sides the two normals disagree are left out, because shading normals are known to break reciprocity there.
inline void checkBsdfReciprocity(const Bsdf& bsdf) {
    std::mt19937 rng(14);
    int compared = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
        const auto side = [&](const Vec3& w) { return dot(w, bsdf.ng()) * dot(w, bsdf.frame().n); };
        // In the tail of a very glossy lobe, and near the critical angle, rounding errors dominate, so there is nothing
        // to compare.
        if (side(wo) < 1e-3f || side(wi) < 1e-3f) continue;
        const Rgb f = bsdf.f(wo, wi, LobeFlags::All, TransportMode::Radiance);
        expectClose(f, bsdf.f(wi, wo, LobeFlags::All, TransportMode::Importance), 2e-3f, "reciprocity", 1e-2f);
        compared += !isBlack(f);
    }
    if (bsdf.hasNonSpecular()) {
        EXPECT_GT(compared, 500);
    }
}

// Checks that what the separable lobes scatter, divided by their view factor, is the same for all views of a side.
inline void checkSeparableLobes(const Bsdf& bsdf) {
    const LobeSet lobes = bsdf.separableLobes();
    if (lobes == 0) return;
    const LobeMask mask(LobeFlags::All, lobes);
    std::mt19937 rng(16);
    int compared = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 a = randomDirection(rng), b = randomDirection(rng), wi = randomDirection(rng);
        // Views from below the horizon of the shading frame are no concern of caches.
        const auto side = [&](const Vec3& w) { return dot(w, bsdf.ng()) * dot(w, bsdf.frame().n); };
        if (side(a) < 1e-3f || side(b) < 1e-3f || dot(a, bsdf.ng()) * dot(b, bsdf.ng()) < 0) continue;
        const Rgb fa = bsdf.f(a, wi, mask), fb = bsdf.f(b, wi, mask);
        expectClose(fa * bsdf.viewFactor(b, lobes), fb * bsdf.viewFactor(a, lobes), 1e-3f, "separable", 1e-3f);
        compared += !isBlack(fa);
    }
    EXPECT_GT(compared, 500);
}

// The same for specular lobes: the reverse of a sample's path is one of the paths that samples from its end take, with
// the same share of the light. (Refraction narrows a beam by the squared relative index, which is in the delta
// distribution of one direction only.)
inline void checkSpecularReciprocity(const Bsdf& bsdf) {
    constexpr LobeFlags kMask = LobeFlags::Specular | LobeFlags::Reflection | LobeFlags::Transmission;
    constexpr int kChoices = 256;
    const auto share = [&](const BsdfSample& s) { return s.f * absDot(s.wi, bsdf.frame().n); };
    std::mt19937 rng(15);
    for (const float c : {0.9f, 0.4f, -0.8f})
        for (int i = 0; i < 20; ++i) {
            const Vec3 wo = bsdf.frame().toWorld(direction(c));
            const float uLobe = uniform(rng);
            const auto s = bsdf.sample(wo, uLobe, Vec2(0.5f, 0.5f), kMask);
            if (!s) continue;
            float nearest = kInfinity;
            for (int k = 0; k < kChoices; ++k) {
                const auto back = bsdf.sample(s->wi, (float(k) + 0.5f) / kChoices, Vec2(0.5f, 0.5f), kMask,
                                              TransportMode::Importance);
                if (!back || length(back->wi - wo) > 1e-4f) continue;
                nearest = std::min(nearest, length(share(*s) * sqr(s->eta) - share(*back)));
            }
            EXPECT_LT(nearest, 1e-3f) << c << ", weight " << share(*s);
        }
}

}  // namespace drc::test
