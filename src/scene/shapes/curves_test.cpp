#include "scene/shapes/curves.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"
#include "base/memory_testing.h"
#include "math/frame.h"
#include "scene/chi_square.h"
#include "scene/shapes/shape_check.h"

namespace drc {
namespace {

const std::array<Vec3, 4> kStraight = {Vec3(-1.5f, 0, 0), Vec3(-0.5f, 0, 0), Vec3(0.5f, 0, 0), Vec3(1.5f, 0, 0)};
const std::array<Vec3, 4> kBent = {Vec3(-1, 0, 0), Vec3(-0.5f, 1, 0.4f), Vec3(0.5f, -0.6f, 0.8f), Vec3(1, 0.3f, -0.2f)};

std::unique_ptr<Curves> make(CurveType type, const std::array<Vec3, 4>& points, float width0, float width1,
                             bool flip = false) {
    auto curves = std::make_unique<Curves>(type, flip);
    curves->add(points, {width0, width1}, {normalize(Vec3(0.1f, 0.2f, 1)), normalize(Vec3(0, -1, 1))});
    return curves;
}

TEST(Curves, FlatFacesTheRay) {
    const auto curve = make(CurveType::Flat, kStraight, 0.2f, 0.4f);
    for (const Vec3& from : {Vec3(0, 0, 5), Vec3(0, 5, 0), Vec3(0, -3, 4)}) {
        const Vec3 d = -normalize(from);
        const Vec3 side = normalize(cross(d, Vec3(1, 0, 0)));  // the direction in which v increases
        const auto hit = curve->intersect(rayFrom(from + side * 0.075f, d), 0);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->t, 5, 1e-5);
        EXPECT_NEAR(hit->uv.x, 0.5, 1e-5);
        EXPECT_NEAR(hit->uv.y, 0.75, 1e-5);
        EXPECT_NEAR(dot(hit->ng, -d), 1, 1e-6);
        EXPECT_NEAR(length(hit->dpdu - Vec3(3, 0, 0)), 0, 1e-5);
        EXPECT_NEAR(length(hit->dpdv - side * 0.3f), 0, 1e-6);
        EXPECT_TRUE(curve->intersect(rayFrom(from + side * 0.149f, d), 0));
        EXPECT_FALSE(curve->intersect(rayFrom(from + side * 0.151f, d), 0));
        EXPECT_FALSE(curve->intersect(rayFrom(from, -d), 0));
    }
    EXPECT_FALSE(curve->intersect(rayFrom(Vec3(1.51f, 0, 5), Vec3(0, 0, -1)), 0));
    EXPECT_LT(make(CurveType::Flat, kStraight, 1, 1, true)->intersect(rayFrom(Vec3(0, 0, 5), Vec3(0, 0, -1)), 0)->ng.z,
              0);
}

// As in the pbrt program: the normals of the far inside of a tube.
TEST(Curves, CylinderLooksLikeAHollowTube) {
    const auto curve = make(CurveType::Cylinder, kStraight, 0.2f, 0.2f);
    // At half the radius; the normal varies in equal steps of angle, so it is at 45 degrees, towards the axis.
    const auto above = curve->intersect(rayFrom(Vec3(0, 0.05f, 5), Vec3(0, 0, -1)), 0);
    const auto below = curve->intersect(rayFrom(Vec3(0, -0.05f, 5), Vec3(0, 0, -1)), 0);
    ASSERT_TRUE(above && below);
    EXPECT_LT(length(above->ng - normalize(Vec3(0, -1, 1))), 1e-5f);
    EXPECT_LT(length(below->ng - normalize(Vec3(0, 1, 1))), 1e-5f);
    for (const auto& hit : {above, below})
        EXPECT_LT(length(normalize(cross(hit->dpdu, hit->dpdv)) + hit->ng), 1e-5f) << "pbrt's looks away";
}

// The picture of a round tube has its normals: at half the radius, that of 30 degrees from the axis to the eye.
TEST(Curves, TubeLooksLikeARoundOne) {
    const auto curve = make(CurveType::Tube, kStraight, 0.2f, 0.2f);
    for (const float share : {-0.9f, -0.5f, 0.f, 0.3f, 0.8f}) {
        const auto hit = curve->intersect(rayFrom(Vec3(0, share * 0.1f, 5), Vec3(0, 0, -1)), 0);
        ASSERT_TRUE(hit);
        EXPECT_LT(length(hit->ng - Vec3(0, share, std::sqrt(1 - share * share))), 1e-4f);
        EXPECT_LT(length(normalize(cross(hit->dpdu, hit->dpdv)) + hit->ng), 1e-5f);
    }
}

TEST(Curves, RibbonKeepsItsSide) {
    Curves ribbon(CurveType::Ribbon, false);
    ribbon.add(kStraight, {0.2f, 0.2f}, {Vec3(0, 0, 1), Vec3(0, 1, 0)});
    // The normals rotate by 90 degrees and are diagonal in the middle. Edge-on, a ribbon is invisible.
    const Vec3 diagonal = normalize(Vec3(0, 1, 1));
    const auto hit = ribbon.intersect(rayFrom(diagonal * 5, -diagonal), 0);
    ASSERT_TRUE(hit);
    EXPECT_GT(dot(hit->ng, diagonal), 0.999f);
    EXPECT_GT(dot(ribbon.intersect(rayFrom(diagonal * -5, diagonal), 0)->ng, diagonal), 0.999f);
    const Vec3 edge = normalize(Vec3(0, 1, -1));
    EXPECT_TRUE(ribbon.intersect(rayFrom(diagonal * 5 + edge * 0.09f, -diagonal), 0));
    EXPECT_FALSE(ribbon.intersect(rayFrom(diagonal * 0.01f + edge * 5, -edge), 0));
    // v must increase along dpdv.
    const auto off = ribbon.intersect(rayFrom(diagonal * 5 + hit->dpdv * 0.25f, -diagonal), 0);
    ASSERT_TRUE(off);
    EXPECT_NEAR(off->uv.y, 0.75, 2e-3);
    EXPECT_NEAR(ribbon.area(), 0.6, 1e-5);
}

TEST(Curves, PiecesJoin) {
    // A sharp bend in a thin curve needs many pieces, and u must run through all of them.
    const auto curve = make(CurveType::Flat, kBent, 0.004f, 0.004f);
    EXPECT_GT(curve->pieceCount(), 2u);
    Curves whole(CurveType::Flat, false);
    whole.add(kBent, {4, 4});
    ASSERT_EQ(whole.pieceCount(), 1u);
    for (int i = 1; i < 40; ++i) {
        const float u = float(i) / 40, v = 1 - u;
        const Vec3 p =
            kBent[0] * (v * v * v) + kBent[1] * (3 * v * v * u) + kBent[2] * (3 * v * u * u) + kBent[3] * (u * u * u);
        const auto hit = curve->intersect(rayFrom(p + Vec3(0, 0, 3), Vec3(0, 0, -1)), 0);
        ASSERT_TRUE(hit) << u;
        EXPECT_NEAR(hit->uv.x, u, 2e-3);
        EXPECT_NEAR(hit->t, 3, 1e-3);
    }
    // Pieces from an appended set must be hit as well.
    Curves both(CurveType::Flat, false);
    both.add(kStraight, {0.1f, 0.1f});
    ASSERT_TRUE(both.looksLike(whole));
    Curves moved(CurveType::Flat, false);
    moved.add({Vec3(-1, 5, 0), Vec3(-0.3f, 5, 0), Vec3(0.3f, 5, 0), Vec3(1, 5, 0)}, {0.1f, 0.1f});
    both.append(moved);
    EXPECT_EQ(both.intersect(rayFrom(Vec3(0.3f, 5, 1), Vec3(0, 0, -1)), 0)->part, 1u);
    EXPECT_GT(both.bounds().max.y, 5);
    // A curve without length is ignored.
    both.add({Vec3(1.f), Vec3(1.f), Vec3(1.f), Vec3(1.f)}, {1, 1});
    EXPECT_EQ(both.pieceCount(), 2u);
}

// Compares sampleFrom() with uniform directions around the curve, by the solid angle it subtends and its first moments.
void checkSolidAngle(const Curves& curves, const Vec3& p) {
    Pcg32 rng(9);
    const Bounds box = curves.bounds();
    const Frame frame = Frame::fromNormal(normalize(box.center() - p));
    const float sine = std::min(0.999f, box.radius() / length(box.center() - p)), cosine = std::sqrt(1 - sine * sine);
    RunningMean bySample[4], byDirection[4];
    for (int i = 0; i < 6000; ++i) {
        const ShapeSample s = curves.sampleFrom(p, rng.nextVec2());
        const Vec3 w = normalize(s.p - p);
        for (int k = 0; k < 4; ++k) bySample[k].add(s.pdf > 0 ? (k < 3 ? w[k] : 1) / s.pdf : 0);
        const Vec2 u = rng.nextVec2();
        const float z = lerp(u.x, cosine, 1), r = safeSqrt(1 - z * z);
        const Vec3 d = frame.toWorld(Vec3(r * std::cos(2 * kPi * u.y), r * std::sin(2 * kPi * u.y), z));
        const auto hit = curves.intersect(rayFrom(p, d), 0);
        for (int k = 0; k < 4; ++k) byDirection[k].add(hit ? (k < 3 ? d[k] : 1) * 2 * kPi * (1 - cosine) : 0);
        if (!hit || i % 8 != 0 || std::abs(hit->uv.y - 0.5f) > 0.49f) continue;
        // Every visible point must have a positive pdf.
        const float pdf = curves.pdfFrom(p, d, {p + d * hit->t, hit->ng, hit->uv, hit->part});
        EXPECT_GT(pdf, 0);
    }
    const char* names[] = {"x", "y", "z", "solid angle"};
    for (int k = 0; k < 4; ++k) expectSame(bySample[k], byDirection[k], 5e-3 * byDirection[3].mean(), names[k]);
}

TEST(Curves, SamplesFillTheSolidAngle) {
    for (const CurveType type : {CurveType::Flat, CurveType::Cylinder, CurveType::Tube, CurveType::Ribbon})
        checkSolidAngle(*make(type, kBent, 0.2f, 0.1f), Vec3(0.3f, 0.5f, 4));
}

TEST(Curves, PdfIsThatOfSampleFrom) {
    for (const CurveType type : {CurveType::Flat, CurveType::Cylinder, CurveType::Tube, CurveType::Ribbon}) {
        const auto curves = make(type, kBent, 0.05f, 0.1f);
        const Vec3 p(0.3f, 0.5f, 4);
        Pcg32 rng(2);
        int compared = 0, different = 0;
        for (int i = 0; i < 300; ++i) {
            const ShapeSample s = curves->sampleFrom(p, rng.nextVec2());
            const Vec3 w = normalize(s.p - p);
            const auto hit = curves->intersect(rayFrom(p, w), 0);
            // Missed exactly at the edge, or hidden behind another bend.
            if (!hit || std::abs(hit->t - length(s.p - p)) > 0.06f) continue;
            const float pdf = curves->pdfFrom(p, w, {p + w * hit->t, hit->ng, hit->uv, hit->part});
            different += std::abs(pdf - s.pdf) > 0.05f * s.pdf;
            EXPECT_GT(dot(hit->ng, s.ng), 0.98f);
            ++compared;
        }
        EXPECT_GT(compared, 200);
        EXPECT_LT(different, compared / 40);  // some where the curve or ribbon is seen end-on
    }
}

// From closer to the axis than a quarter of the radius, no sample is visible, and the pdf of hits must be zero.
TEST(Curves, NoDensityWhereNoSampleLies) {
    for (const CurveType type : {CurveType::Flat, CurveType::Cylinder, CurveType::Tube}) {
        const auto curves = make(type, kStraight, 1, 1);
        const Vec3 p(0, 0.1f, 0);
        Pcg32 rng(2);
        int none = 0;
        for (int i = 0; i < 200; ++i) {
            const Vec2 u = rng.nextVec2();
            const bool met = curves->sampleFrom(p, u).pdf > 0;
            // The straight curve is a single piece, in which equal steps of u have equal lengths.
            EXPECT_EQ(curves->pdfFrom(p, Vec3(0, 1, 0), {p, Vec3(0, 1, 0), Vec2(u.x, u.y), 0}) > 0, met) << u.x;
            none += !met;
        }
        EXPECT_GT(none, 5);
        EXPECT_LT(none, 100);
    }
}

// Chi-square test over bands of directions. The expected counts are themselves estimated with random directions, and
// their variance is included, since the pdf of a thin curve has too many discontinuities for quadrature.
TEST(Curves, DirectionsFollowTheDensity) {
    constexpr int kBands = 16, kSamples = 12000, kDirections = 25000;
    for (const CurveType type : {CurveType::Flat, CurveType::Cylinder, CurveType::Tube, CurveType::Ribbon}) {
        const auto curves = make(type, kBent, 0.1f, 0.25f);
        const Vec3 p(0.3f, 0.5f, 3);
        Pcg32 rng(10);
        // Directions are chosen by a window in front of the curve.
        const Bounds box = curves->bounds();
        const Vec2 low(box.min.x - p.x, box.min.y - p.y), high(box.max.x - p.x, box.max.y - p.y);
        const float depth = p.z - box.max.z,
                    reach = depth / (p.z - box.min.z);  // ratio of the near to the far distance
        const auto edge = [&](float a) { return std::max(a, a * reach); };
        const Vec2 from(-edge(-low.x), -edge(-low.y)), to(edge(high.x), edge(high.y));
        const auto band = [&](const Vec3& w) {
            return std::clamp(int((-w.x / w.z * depth - from.x) / (to.x - from.x) * kBands), 0, kBands - 1);
        };
        double observed[kBands] = {}, expected[kBands] = {}, squares[kBands] = {};
        for (int i = 0; i < kSamples; ++i) {
            const ShapeSample s = curves->sampleFrom(p, rng.nextVec2());
            if (s.pdf > 0) ++observed[band(normalize(s.p - p))];
        }
        for (int i = 0; i < kDirections; ++i) {
            const Vec2 u = rng.nextVec2();
            const Vec3 at(lerp(u.x, from.x, to.x), lerp(u.y, from.y, to.y), -depth), d = normalize(at);
            const auto hit = curves->intersect(rayFrom(p, d), 0);
            if (!hit) continue;
            const double solidAngle = (to.x - from.x) * (to.y - from.y) * std::abs(d.z) / lengthSquared(at);
            const double pdf = curves->pdfFrom(p, d, {p + d * hit->t, hit->ng, hit->uv, hit->part});
            const double share = kSamples * pdf * solidAngle / kDirections;
            expected[band(d)] += share;
            squares[band(d)] += share * share;
        }
        double chiSquare = 0, sum = 0, variance = 0;
        int counted = 0;
        for (int i = 0; i < kBands; ++i) {
            sum += expected[i];
            variance += squares[i];
            if (expected[i] < 50) continue;
            chiSquare += std::pow(observed[i] - expected[i], 2) / (expected[i] + squares[i]);
            ++counted;
        }
        EXPECT_GT(counted, 8);
        EXPECT_GT(chiSquareUpperTail(chiSquare, counted), test::kChiSquareLevel) << chiSquare << " of " << counted;
        // The total must be 1, except for a few samples that miss exactly at edges.
        EXPECT_NEAR(sum / kSamples, 1, 4 * std::sqrt(variance) / kSamples + 5e-3);
        // Where a ribbon is seen edge-on, its pdf has a singularity.
        EXPECT_LT(std::sqrt(variance) / kSamples, type == CurveType::Ribbon ? 0.08 : 0.015);
    }
}

TEST(Curves, SamplesByAreaCoverATube) {
    const auto curves = make(CurveType::Flat, kStraight, 0.2f, 0.2f);
    EXPECT_NEAR(curves->area(), 3 * 0.2f * kPi, 1e-4);
    Pcg32 rng(8);
    for (int i = 0; i < 100; ++i) {
        const ShapeSample s = curves->sample(rng.nextVec2());
        EXPECT_NEAR(1 / s.pdf, curves->area(), 1e-3);
        EXPECT_NEAR(length(s.p - Vec3(s.p.x, 0, 0)), 0.1f, 1e-5);
    }
}

TEST(Curves, PiecesAreCountedAsTheyAreMade) {
    for (const CurveType type : {CurveType::Flat, CurveType::Cylinder, CurveType::Tube, CurveType::Ribbon})
        for (const float width : {0.f, 1e-6f, 1e-3f, 0.1f, 1.f})
            for (const std::array<Vec3, 4>& points : {kStraight, kBent, {Vec3(1), Vec3(1), Vec3(1), Vec3(1)}}) {
                Curves curves(type, false);
                const std::array<Vec3, 2> normals = {Vec3(0, 0, 1), normalize(Vec3(0, 1, -2))};
                curves.add(points, {width, width}, normals);
                EXPECT_EQ(curves.piecesOf(points, {width, width}, normals), int(curves.pieceCount())) << width;
            }
}

TEST(Curves, AsLightsAndTogetherAreWithinMemory) {
    Curves curves(CurveType::Flat, false);
    for (int i = 0; i < 1024; ++i) curves.add(kBent, {1e-7f, 1e-7f});
    ASSERT_EQ(curves.pieceCount(), 1024u * 64);
    const std::string light = errorOf([&] {
        const AddressSpaceLimit limit(3 << 20);
        (void)curves.area();
    });
    EXPECT_THAT(light, testing::StartsWith("a light of curves of 65536 pieces needs about 4 MiB of memory"));
    EXPECT_GT(curves.area(), 0) << "it can be tried again";
    Curves both(CurveType::Flat, false);
    both.append(curves);
    const std::string together = errorOf([&] {
        const AddressSpaceLimit limit(16 << 20);
        both.append(curves);
    });
    EXPECT_THAT(together, testing::StartsWith("curves of 131072 pieces needs about "));
    EXPECT_EQ(both.pieceCount(), curves.pieceCount());
}

}  // namespace
}  // namespace drc
