#include "transport/environment_guide.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/folder_testing.h"
#include "math/rng.h"
#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

constexpr int kBlocks = EnvironmentGuide::kBlocks;

struct Guide : testing::Test {
    LightPtr light = makeInfiniteLight(Transform(), Rgb(1.f));
    EnvironmentGuide guide{*light, 1};
    Pcg32 rng{1};
    int group = guide.group(Vec3(0.2f, 0.3f, 0.4f), Vec3(0, 0, 1));

    // One sample pass, in which samples of each block arrive with the given probability.
    template <typename Rate>
    void samplePass(int samples, Rate rate) {
        for (int i = 0; i < samples; ++i) {
            const int slot = guide.sample(group, rng.nextVec2()).slot;
            guide.learn(slot, rng.nextFloat() < rate(slot % kBlocks));
        }
        guide.update();
    }
    float densityOf(int block) const {
        constexpr int columns = EnvironmentGuide::kColumns, rows = EnvironmentGuide::kRows;
        return guide.density(group,
                             Vec2((float(block % columns) + 0.5f) / columns, (float(block / columns) + 0.5f) / rows));
    }
};

TEST_F(Guide, ChangesNothingBeforeItHasLearned) {
    for (int i = 0; i < 1000; ++i) {
        const Vec2 u = rng.nextVec2();
        const auto g = guide.sample(group, u);
        EXPECT_LT((g.u - u).length(), 2e-4f);
        EXPECT_NEAR(g.density, 1, 2e-3f);
    }
}

TEST_F(Guide, SamplesHaveTheDensityThatItSays) {
    for (int i = 0; i < 8; ++i) samplePass(4000, [](int block) { return float(block % 7) / 7; });
    std::vector<double> counts(kBlocks);
    double sum = 0;
    const int n = 400000;
    Vec2 mean(0, 0);
    for (int i = 0; i < n; ++i) {
        const auto g = guide.sample(group, rng.nextVec2());
        ASSERT_GE(g.u.x, 0);
        ASSERT_LT(g.u.x, 1);
        ASSERT_GE(g.u.y, 0);
        ASSERT_LT(g.u.y, 1);
        ASSERT_EQ(g.density, guide.density(group, g.u));
        counts[size_t(g.slot % kBlocks)] += 1;
        // Position within the block.
        mean += Vec2(g.u.x * EnvironmentGuide::kColumns, g.u.y * EnvironmentGuide::kRows);
        mean -= Vec2(std::floor(g.u.x * EnvironmentGuide::kColumns), std::floor(g.u.y * EnvironmentGuide::kRows));
        sum += 1 / g.density;
    }
    double chiSquare = 0, integral = 0;
    for (int b = 0; b < kBlocks; ++b) {
        const double expected = n * double(densityOf(b)) / kBlocks;
        chiSquare += sqr(float(counts[size_t(b)] - expected)) / expected;
        integral += densityOf(b) / kBlocks;
    }
    EXPECT_LT(chiSquare, 181.99);  // 99.9 % quantile for 127 degrees of freedom
    EXPECT_NEAR(integral, 1, 1e-5);
    EXPECT_NEAR(sum / n, 1, 0.01);  // the area of the unit square
    EXPECT_NEAR(mean.x / float(n), 0.5, 0.003);
    EXPECT_NEAR(mean.y / float(n), 0.5, 0.003);
}

// Tests the density over directions that multiple importance sampling uses: the sky's pdf times the guide's factor.
TEST(GuidedDirections, FollowTheirDensity) {
    EnvironmentMap map{24, 12, {}};
    Pcg32 rng(3);
    for (int i = 0; i < 24 * 12; ++i) map.texels.push_back(Rgb(0.2f + rng.nextFloat()));
    const LightPtr sky = makeInfiniteLight(Transform::rotate(50, Vec3(1, 3, 2)), Rgb(1.f), map);
    EnvironmentGuide guide(*sky, 1);
    const int group = guide.group(Vec3(0.2f, 0.3f, 0.4f), Vec3(0, 0, 1));
    for (int pass = 0; pass < 8; ++pass) {
        for (int i = 0; i < 4000; ++i) {
            const int slot = guide.sample(group, rng.nextVec2()).slot;
            guide.learn(slot, rng.nextFloat() < float(slot % kBlocks % 7) / 7);
        }
        guide.update();
    }
    const auto sample = [&](std::mt19937& random) -> std::optional<Vec3> {
        return sky->sample(Vec3(0, 0, 0), guide.sample(group, test::uniform2(random)).u)->wi;
    };
    const auto pdf = [&](const Vec3& w) {
        return sky->pdfEscaped(Vec3(0.f), w) * guide.density(group, sky->inverse(Vec3(0.f), w));
    };
    const test::ChiSquare r = test::chiSquareTest(sample, pdf, 60000, 4, 4e-5);
    EXPECT_GT(r.pValue, test::kChiSquareLevel) << "chi2 " << r.statistic << " dof " << r.degreesOfFreedom;
    EXPECT_NEAR(r.pdfIntegral, 1, 2e-3);
}

TEST_F(Guide, LearnsWhereLightArrives) {
    const auto window = [](int block) { return block / 16 == 3 && block % 16 >= 4 && block % 16 < 8; };
    for (int i = 0; i < 8; ++i) samplePass(2000, [&](int block) { return window(block) ? 1.f : 0.f; });
    for (int b = 0; b < kBlocks; ++b) {
        // The factor inside the window would be up to 24 (three quarters of 32) if the rest got nothing; the rest
        // always gets some.
        EXPECT_GT(densityOf(b), window(b) ? 8.f : 0.2f) << b;
    }
    // At other positions and for other normals, nothing was learned.
    EXPECT_NEAR(guide.density(guide.group(Vec3(5.2f, 0.3f, 0.4f), Vec3(0, 0, 1)), Vec2(0.3f, 0.4f)), 1, 2e-3f);
    EXPECT_NEAR(guide.density(guide.group(Vec3(0.2f, 0.3f, 0.4f), Vec3(1, 0, 0)), Vec2(0.3f, 0.4f)), 1, 2e-3f);
}

TEST_F(Guide, DensityFollowsTheRootOfTheRate) {
    for (int i = 0; i < 16; ++i) samplePass(20000, [](int block) { return block % 2 ? 0.04f : 0.64f; });
    double odd = 0, even = 0;
    for (int b = 0; b < kBlocks; ++b) (b % 2 ? odd : even) += densityOf(b);
    // The rates are four to one, so the square roots two to one, apart from the unguided quarter.
    EXPECT_NEAR(even / kBlocks * 2, 0.75 * 1.6 + 0.25, 0.05);
    EXPECT_NEAR(odd / kBlocks * 2, 0.75 * 0.4 + 0.25, 0.05);
}

TEST_F(Guide, ManyTriesDoNotOverflow) {
    for (int i = 0; i < 4; ++i) samplePass(1 << 20, [](int block) { return block == 5 ? 1.f : 0.f; });
    EXPECT_GT(densityOf(5), 20);
    for (int b = 0; b < kBlocks; ++b)
        if (b != 5) {
            EXPECT_LT(densityOf(b), 2) << b;
        }
}

TEST_F(Guide, NorDoManyPasses) {
    // Eight blocks in a row, every other one with sixteen times the rate of the rest.
    const auto rateOf = [](int block) { return block / 8 != 3 ? 0.f : block % 2 ? 0.04f : 0.64f; };
    for (int i = 0; i < 64; ++i) samplePass(20000, rateOf);
    double odd = 0, even = 0;
    for (int b = 24; b < 32; ++b) (b % 2 ? odd : even) += densityOf(b) / 4;
    EXPECT_GT(even + odd, 18);  // of 24
    EXPECT_NEAR((even - 0.25) / (odd - 0.25), 4, 0.4);
}

// With a checksum that is right: someone has made the file.
TEST_F(Guide, TablesThatAreNoneAreRefused) {
    TemporaryFolder folder;
    const auto loads = [&](size_t at, uint16_t number) {
        constexpr size_t kTables = 1 << 14, kNumbers = EnvironmentGuide::kRows + EnvironmentGuide::kBlocks;
        const auto uniform = [](size_t i, size_t n) { return uint16_t((i * (1 << 16)) / n); };
        std::vector<uint16_t> numbers;
        for (size_t t = 0; t < kTables; ++t) {
            for (size_t i = 0; i < EnvironmentGuide::kRows; ++i) numbers.push_back(uniform(i, EnvironmentGuide::kRows));
            for (size_t i = 0; i < EnvironmentGuide::kBlocks; ++i)
                numbers.push_back(uniform(i % EnvironmentGuide::kColumns, EnvironmentGuide::kColumns));
        }
        EXPECT_EQ(numbers.size(), kTables * kNumbers);
        numbers[at] = number;
        StateWriter file(folder.path("guide"), "guide");
        file.value(int32_t(64));
        file.values(std::span<const uint16_t>(numbers));
        file.commit();
        StateReader reader(folder.path("guide"), "guide", "guide");
        return errorOf([&] { guide.load(reader); });
    };
    EXPECT_EQ(loads(3, uint16_t(3 << 13)), "");  // as it was
    for (const auto& [at, number] : {std::pair<size_t, uint16_t>(0, 1), {3, 2 << 13}, {5, 0}, {1000, 65535}})
        EXPECT_THAT(loads(at, number), testing::HasSubstr("there cannot be such a table")) << at;
}

TEST_F(Guide, GroupsArePointsNearEachOther) {
    const Vec3 n(0, 1, 0);
    int same = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p(10 * rng.nextFloat(), 10 * rng.nextFloat(), 10 * rng.nextFloat());
        EXPECT_EQ(guide.group(p, n), guide.group(p, n));
        same += guide.group(p, n) == guide.group(p + Vec3(0.01f, 0, 0), n);
        EXPECT_GE(guide.group(p, n), 0);
    }
    EXPECT_GT(same, 200);  // points are jittered by up to half a voxel in each direction
    EXPECT_GE(guide.group(Vec3(1e30f, -1e30f, 0), n), 0);
}

}  // namespace
}  // namespace drc
