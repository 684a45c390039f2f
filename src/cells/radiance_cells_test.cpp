#include "cells/radiance_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <numeric>

#include "base/parallel.h"
#include "math/rng.h"

namespace drc {
namespace {

constexpr float kSize = 0.05f;
constexpr float kFar = 1000 * kSize;  // a reach for all sizes
constexpr Vec3 kUp{0, 0, 1};

using Deposits = std::vector<CacheDeposit>;

RadianceCellSettings settingsOf(int sizes = 4) {
    RadianceCellSettings settings;
    settings.size = kSize;
    settings.sizes = sizes;
    return settings;
}

float largest(const RadianceCellSettings& s) { return s.size * float(1 << (s.sizes - 1)); }

CacheDeposit deposit(const Vec3& p, const Vec3& n, float light, float viewFactor = 1, float reach = kFar) {
    return {{p, n, reach}, Rgb(light), cacheableFactor(Rgb(viewFactor))};
}

void commit(RadianceCells& cells, Deposits deposits) {
    const size_t count = deposits.size();
    std::vector<CacheDeposit>* const list[] = {&deposits};
    EXPECT_EQ(cells.commit(list), count);
    EXPECT_TRUE(deposits.empty());
}

// The answer's red; -1: none.
float answerAt(const RadianceCells& cells, const Vec3& p, const Vec3& n = kUp, float reach = kFar) {
    CacheAnswer answer;
    return cells.lookUp({p, n, reach}, answer) ? answer.perFactor.x : -1;
}

// Points all over a square of the plane z = height that is several of the largest cells wide, so many that each of the
// finest ones has enough.
std::vector<Vec3> floorPoints(float height = 0, int perCell = 256) {
    const float width = 3 * largest(settingsOf());
    const int n = int(std::ceil(width / kSize * std::sqrt(float(perCell))));
    std::vector<Vec3> points;
    for (int i = 0; i < n * n; ++i)
        points.emplace_back((float(i % n) + 0.5f) / float(n) * width, (float(i / n) + 0.5f) / float(n) * width, height);
    return points;
}

Deposits depositsAt(const std::vector<Vec3>& points, const std::function<float(const Vec3&)>& light,
                    float reach = kFar) {
    Deposits deposits;
    for (const Vec3& p : points) deposits.push_back(deposit(p, kUp, light(p), 1, reach));
    return deposits;
}

double meanOf(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

// The least reach that the cells accept.
float leastReach(const RadianceCells& cells) {
    float no = 0, yes = kFar;
    for (int i = 0; i < 60; ++i) {
        const float middle = (no + yes) / 2;
        (cells.accepts({Vec3(0.f), kUp, middle}) ? yes : no) = middle;
    }
    return yes;
}

TEST(RadianceCells, AConstantFieldIsAnsweredExactly) {
    RadianceCells cells(settingsOf());
    const std::vector<Vec3> points = floorPoints();
    commit(cells, depositsAt(points, [](const Vec3&) { return 0.375f; }));
    Pcg32 random;
    const float inside = largest(settingsOf());
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p(inside * (1 + random.nextFloat()), inside * (1 + random.nextFloat()), 0);
        EXPECT_FLOAT_EQ(answerAt(cells, p, kUp, kFar), 0.375f);
    }
}

// Light divided by the view factor, each summed up for itself: surfaces of any albedo in one light have one answer, and
// a dark patch counts for no more than the light that it scatters.
TEST(RadianceCells, AnswersAreRatiosOfSums) {
    Pcg32 random;
    RadianceCells cells(settingsOf(1));
    Deposits deposits;
    for (int i = 0; i < 500; ++i) {
        const float albedo = cacheableFactor(Rgb(0.05f + 1.9f * random.nextFloat())).x;
        deposits.push_back(deposit(Vec3(0.f), kUp, 3 * albedo, albedo));
        deposits.push_back(deposit(Vec3(1, 0, 0), kUp, 0.5f, i % 2 == 0 ? 0.25f : 0.75f));
    }
    commit(cells, deposits);
    EXPECT_NEAR(answerAt(cells, Vec3(0.f)), 3, 1e-5);
    EXPECT_FLOAT_EQ(answerAt(cells, Vec3(1, 0, 0)), 1);
    // Channels are each by themselves, and one without a view factor is black.
    Deposits red;
    for (int i = 0; i < 500; ++i) red.push_back({{Vec3(2, 0, 0), kUp, kFar}, Rgb(0.5f, 0.25f, 0), Rgb(0.5f, 1, 0)});
    commit(cells, red);
    CacheAnswer answer;
    ASSERT_TRUE(cells.lookUp({Vec3(2, 0, 0), kUp, kFar}, answer));
    EXPECT_EQ(answer.perFactor, Rgb(1, 0.25f, 0));
}

TEST(RadianceCells, NothingIsAnsweredBeforeEnoughDeposits) {
    RadianceCellSettings settings = settingsOf();
    settings.deposits = 10;
    RadianceCells cells(settings);
    EXPECT_EQ(answerAt(cells, Vec3(0.f)), -1);
    commit(cells, Deposits(9, deposit(Vec3(0.f), kUp, 1)));
    EXPECT_EQ(answerAt(cells, Vec3(0.f)), -1);
    commit(cells, {});
    EXPECT_EQ(answerAt(cells, Vec3(0.f)), -1);
    commit(cells, Deposits(1, deposit(Vec3(0.f), kUp, 1)));
    EXPECT_FLOAT_EQ(answerAt(cells, Vec3(0.f)), 1);
    EXPECT_EQ(cells.commits(), 3);
}

// Two halves of a floor, one of them three times as bright.
TEST(RadianceCells, SmallCellsReplaceLargerOnesOnceTheyHaveLittleNoise) {
    const float inside = largest(settingsOf());
    const auto light = [&](const Vec3& p) { return p.x < 1.5f * inside ? 1.f : 3.f; };
    const std::vector<Vec3> points = floorPoints();
    Pcg32 random;
    // One point in fifty sees light.
    const auto noisy = [&](const Vec3& p) { return random.nextUint(50) == 0 ? 50 * light(p) : 0.f; };
    const auto spread = [&](const RadianceCells& cells) {
        std::vector<float> squares;
        for (size_t i = 0; i < points.size(); i += 7) {
            const float answer = answerAt(cells, points[i]);
            if (answer < 0) continue;  // at the border
            squares.push_back((answer - light(points[i])) * (answer - light(points[i])));
        }
        return meanOf(squares);
    };
    RadianceCells exact(settingsOf()), cells(settingsOf());
    commit(exact, depositsAt(points, light));
    EXPECT_LT(spread(exact), 0.05);  // but for cells at the border between both halves
    std::vector<Vec3> few;
    for (size_t i = 0; i < points.size(); i += 127) few.push_back(points[i]);
    commit(cells, depositsAt(few, noisy));
    // Too noisy for small cells: all points of a large one have the same answer.
    EXPECT_EQ(answerAt(cells, Vec3(inside, inside, 0)), answerAt(cells, Vec3(inside + 2 * kSize, inside + kSize, 0)));
    const double first = spread(cells);
    for (int i = 0; i < 12; ++i) commit(cells, depositsAt(points, noisy));
    EXPECT_LT(spread(cells), 0.25 * first);
    EXPECT_LT(spread(cells), 0.2);
}

// Which size answers is decided for all parts of a cell alike, by the noise within them. If those that happen to have
// seen no outlier were preferred, light would be lost.
TEST(RadianceCells, EnergyIsConserved) {
    const std::vector<Vec3> points = floorPoints();
    for (const uint32_t rare : {20u, 1000u}) {
        Pcg32 random(rare);
        RadianceCells cells(settingsOf());
        std::vector<float> given, answered;
        const Deposits deposits = depositsAt(points, [&](const Vec3&) {
            given.push_back(1 + (random.nextUint(rare) == 0 ? float(rare) : 0.f));
            return given.back();
        });
        commit(cells, deposits);
        for (const Vec3& p : points) answered.push_back(answerAt(cells, p));
        EXPECT_NEAR(meanOf(answered) / meanOf(given), 1, 1e-4) << rare;
    }
}

// What is too rare for few deposits counts in full once there are many.
TEST(RadianceCells, BoundedDepositsLoseNothingInTheEnd) {
    const std::vector<Vec3> points = floorPoints();
    RadianceCells cells(settingsOf());
    Pcg32 random;
    constexpr int kRare = 4000;  // of which the mean is 1
    std::vector<double> shares;
    for (int i = 0; i < 48; ++i) {
        std::vector<float> given, answered;
        commit(cells, depositsAt(points, [&](const Vec3&) { return random.nextUint(kRare) == 0 ? 1400.f : 0.65f; }));
        if (i % 16 != 15) continue;
        for (const Vec3& p : points) answered.push_back(answerAt(cells, p));
        shares.push_back(meanOf(answered) / (0.65 + 1400.0 / kRare));
    }
    // 1024 of 1400 at first.
    EXPECT_LT(shares[0], shares[1]);
    EXPECT_LT(shares[1], shares[2]);
    EXPECT_NEAR(shares[2], 1, 0.02);
}

TEST(RadianceCells, AnOutlierDoesNotStandOut) {
    RadianceCells cells(settingsOf());
    const std::vector<Vec3> points = floorPoints(0, 64);
    Deposits deposits = depositsAt(points, [](const Vec3&) { return 1.f; });
    // By itself, the smallest cell that it lies in would be 46 times too bright.
    deposits[deposits.size() / 2 + 90].light = Rgb(46 * 64.f);
    commit(cells, deposits);
    std::vector<float> answers;
    for (const Vec3& p : points) answers.push_back(answerAt(cells, p));
    EXPECT_LT(*std::ranges::max_element(answers), 4);
    EXPECT_GE(*std::ranges::min_element(answers), 1);
}

TEST(RadianceCells, BothSidesOfAThinWallHaveTheirOwnAnswers) {
    RadianceCells cells(settingsOf());
    Pcg32 random;
    Deposits deposits;
    for (int i = 0; i < 20'000; ++i) {
        const float y = random.nextFloat(), z = random.nextFloat();
        deposits.push_back(deposit(Vec3(0, y, z), Vec3(1, 0, 0), 100));
        deposits.push_back(deposit(Vec3(-0.001f, y, z), Vec3(-1, 0, 0), 1));
    }
    commit(cells, deposits);
    for (int i = 0; i < 1000; ++i) {
        const float y = random.nextFloat(), z = random.nextFloat();
        EXPECT_FLOAT_EQ(answerAt(cells, Vec3(0, y, z), Vec3(1, 0, 0), kFar), 100);
        EXPECT_FLOAT_EQ(answerAt(cells, Vec3(-0.001f, y, z), Vec3(-1, 0, 0), kFar), 1);
    }
}

// A table top a little above the floor, with cells of several sizes in which both lie.
TEST(RadianceCells, ATableTopHasItsOwnAnswer) {
    const float height = 1.5f * kSize;
    RadianceCells cells(settingsOf());
    Deposits deposits = depositsAt(floorPoints(0), [](const Vec3&) { return 1.f; });
    const Deposits top = depositsAt(floorPoints(height), [](const Vec3&) { return 5.f; });
    deposits.insert(deposits.end(), top.begin(), top.end());
    commit(cells, deposits);
    for (const Vec3& p : floorPoints(0, 4)) {
        EXPECT_FLOAT_EQ(answerAt(cells, p), 1);
        EXPECT_FLOAT_EQ(answerAt(cells, p + Vec3(0, 0, height)), 5);
    }
}

// A look-up never has the answer of a surface that is half a cell away or more, wherever the cells' borders are, nor
// that of one which faces another way.
TEST(RadianceCells, OtherSurfacesAreNotMistakenForThePoints) {
    Pcg32 random;
    int answered = 0;
    for (int i = 0; i < 300; ++i) {
        RadianceCells cells(settingsOf(1));
        const Vec3 p(random.nextFloat(), random.nextFloat(), random.nextFloat());
        commit(cells, Deposits(100, deposit(p, kUp, 1)));
        answered += answerAt(cells, p) == 1;
        for (const float d : {0.5f, 0.7f, 0.99f, 1.5f})
            for (const float sign : {-1.f, 1.f})
                EXPECT_EQ(answerAt(cells, p + Vec3(0, 0, sign * d * kSize), kUp, kFar), -1) << d;
        // Walls that meet the floor here, and a roof's slope.
        for (const Vec3& n : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1), normalize(Vec3(0, 1, 1))})
            EXPECT_EQ(answerAt(cells, p, n, kFar), -1);
    }
    EXPECT_EQ(answered, 300);
}

// Where a look-up is allowed must not depend on what is known: deposits are made at the same points.
TEST(RadianceCells, WhatIsAcceptedDependsOnTheReachAlone) {
    RadianceCells cells(settingsOf());
    const float least = leastReach(cells);
    EXPECT_GT(least, kSize);
    const auto accepted = [&] {
        std::vector<bool> result;
        Pcg32 random;
        for (int i = 0; i < 1000; ++i)
            result.push_back(cells.accepts({Vec3(random.nextFloat(), 0, 0), kUp, 2 * least * random.nextFloat()}));
        return result;
    };
    const std::vector<bool> empty = accepted();
    for (int i = 0; i < 3; ++i)
        commit(cells, depositsAt(
                          floorPoints(), [](const Vec3& p) { return p.x; }, 1.001f * least));
    EXPECT_EQ(accepted(), empty);
    // What is not accepted has no answer, though it would be known.
    EXPECT_GE(answerAt(cells, Vec3(0.3f, 0.3f, 0), kUp, 1.001f * least), 0);
    EXPECT_EQ(answerAt(cells, Vec3(0.3f, 0.3f, 0), kUp, 0.999f * least), -1);
    // A short segment, and a narrow lobe.
    const float diffuse = float(std::numbers::inv_pi) * 0.7f;
    EXPECT_TRUE(cells.accepts({Vec3(0.f), kUp, CachePoint::reachOf(4, diffuse)}));
    EXPECT_FALSE(cells.accepts({Vec3(0.f), kUp, CachePoint::reachOf(kSize, diffuse)}));
    EXPECT_FALSE(cells.accepts({Vec3(0.f), kUp, CachePoint::reachOf(4, 1e6f)}));
    EXPECT_FALSE(cells.accepts({Vec3(0.f), kUp, CachePoint::reachOf(4, 0)}));
}

TEST(RadianceCells, LargerCellsAreForPointsOfLargerReach) {
    RadianceCells cells(settingsOf());
    const float least = 1.001f * leastReach(cells), corner = 1.1f * largest(settingsOf());
    // So few that only large cells know enough.
    std::vector<Vec3> few;
    Pcg32 random;
    for (int i = 0; i < 4000; ++i) few.emplace_back(4 * random.nextFloat(), 4 * random.nextFloat(), 0.f);
    commit(cells, depositsAt(few, [](const Vec3&) { return 1.f; }));
    EXPECT_FLOAT_EQ(answerAt(cells, Vec3(corner, corner, 0)), 1);
    EXPECT_EQ(answerAt(cells, Vec3(corner, corner, 0), kUp, least), -1);
    // Nor do deposits of a small reach count in them.
    RadianceCells others(settingsOf());
    commit(others, depositsAt(
                       few, [](const Vec3&) { return 1.f; }, least));
    EXPECT_EQ(answerAt(others, Vec3(corner, corner, 0)), -1);
    commit(others, depositsAt(
                       floorPoints(), [](const Vec3&) { return 2.f; }, least));
    EXPECT_GT(answerAt(others, Vec3(corner, corner, 0), kUp, least), 1.5f);
}

// Deposits of all reaches, normals, and brightness.
Deposits randomDeposits(int count, float width, uint64_t seed) {
    Pcg32 random(seed);
    Deposits deposits;
    for (int i = 0; i < count; ++i) {
        const Vec3 p(width * random.nextFloat(), width * random.nextFloat(), 0.02f * random.nextFloat());
        const float tilt = 0.5f * random.nextFloat();
        const float light = random.nextUint(10) == 0 ? 10 * random.nextFloat() : 0.1f;
        const float reach = kFar * std::pow(random.nextFloat(), 4.f);
        deposits.push_back(deposit(p, normalize(Vec3(tilt, 0, 1)), light, 0.1f + 0.9f * random.nextFloat(), reach));
    }
    return deposits;
}

std::vector<float> manyAnswers(const RadianceCells& cells, float width) {
    Pcg32 random(77);
    std::vector<float> answers;
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 p(width * random.nextFloat(), width * random.nextFloat(), 0.01f);
        const float reach = random.nextUint(2) == 0 ? kFar : 0.3f * kFar * random.nextFloat();
        CacheAnswer answer;
        const bool any = cells.lookUp({p, kUp, reach}, answer);
        answers.push_back(any ? answer.perFactor.x : -1);
        answers.push_back(answer.training);
    }
    return answers;
}

TEST(RadianceCells, TheOrderOfDepositsMakesNoDifference) {
    const float width = 0.5f;
    Deposits deposits = randomDeposits(30'000, width, 1);
    RadianceCells cells(settingsOf());
    commit(cells, deposits);
    const std::vector<float> expected = manyAnswers(cells, width);
    EXPECT_GT(std::ranges::count_if(expected, [](float v) { return v > 0; }), 20'000);
    Pcg32 random;
    for (int i = 0; i < 3; ++i) {
        for (size_t k = deposits.size() - 1; k > 0; --k)
            std::swap(deposits[k], deposits[random.nextUint(uint32_t(k + 1))]);
        RadianceCells other(settingsOf());
        // In several calls, of several lists each.
        for (size_t begin = 0; begin < deposits.size(); begin += 10'000) {
            Deposits lists[2];
            for (size_t k = begin; k < std::min(begin + 10'000, deposits.size()); ++k)
                lists[k % 3 == 0].push_back(deposits[k]);
            std::vector<CacheDeposit>* const pointers[] = {&lists[0], &lists[1]};
            other.commit(pointers);
        }
        EXPECT_EQ(manyAnswers(other, width), expected);
    }
}

// Also where the table grows, and where there are more cells than it holds.
TEST(RadianceCells, TheNumberOfThreadsMakesNoDifference) {
    const float width = 4;
    for (const size_t capacity : {size_t(1) << 20, size_t(1) << 10}) {
        std::vector<std::vector<float>> answers;
        for (const int threads : {1, 2, 8}) {
            setThreadCount(threads);
            RadianceCellSettings settings = settingsOf();
            settings.capacity = capacity;
            RadianceCells cells(settings);
            for (uint64_t i = 0; i < 4; ++i) {
                commit(cells, randomDeposits(50'000, width, i));
                answers.push_back(manyAnswers(cells, width));
            }
        }
        setThreadCount(0);
        EXPECT_GT(std::ranges::count_if(answers[3], [](float v) { return v > 0; }), 5000);
        for (size_t i = 4; i < answers.size(); ++i) EXPECT_EQ(answers[i], answers[i % 4]) << i;
    }
}

TEST(RadianceCells, MemoryIsBounded) {
    EXPECT_LE(RadianceCells::bytesPerCell() * RadianceCellSettings().capacity, size_t(128) << 20);
    RadianceCellSettings settings = settingsOf(1);
    settings.capacity = 1 << 12;
    RadianceCells cells(settings);
    EXPECT_LE(cells.bytes(), settings.capacity * RadianceCells::bytesPerCell());
    const auto place = [](int i) { return Vec3(float(i), -100, 0); };
    Deposits known;
    for (int i = 0; i < 100; ++i) known.insert(known.end(), 20, deposit(place(i), kUp, float(1 + i)));
    commit(cells, known);
    // Two million other places, while the first half of these is looked up now and then.
    Pcg32 random;
    for (int k = 0; k < 200; ++k) {
        for (int i = 0; i < 50; ++i) EXPECT_FLOAT_EQ(answerAt(cells, place(i)), float(1 + i)) << k;
        Deposits others;
        for (int i = 0; i < 10'000; ++i)
            others.push_back(deposit(Vec3(random.nextFloat(), random.nextFloat(), random.nextFloat()) * 1000, kUp, 1));
        commit(cells, others);
        ASSERT_LE(cells.used(), settings.capacity);
        ASSERT_LE(cells.bytes(), settings.capacity * RadianceCells::bytesPerCell());
    }
    EXPECT_GT(cells.used(), settings.capacity * 9 / 10);
    for (int i = 50; i < 100; ++i) EXPECT_EQ(answerAt(cells, place(i)), -1);
    // There is room again for what is found out now.
    Deposits now;
    for (int i = 0; i < 100; ++i) now.insert(now.end(), 20, deposit(Vec3(float(i), 100, 0), kUp, 1));
    commit(cells, {});
    commit(cells, now);
    for (int i = 0; i < 100; ++i) EXPECT_FLOAT_EQ(answerAt(cells, Vec3(float(i), 100, 0)), 1);
}

// Half the size: what the sizes that remain know is what it was, and smaller ones take over later.
TEST(RadianceCells, RefinementKeepsWhatIsKnown) {
    RadianceCells cells(settingsOf());
    const auto light = [](const Vec3& p) { return 1 + std::floor(p.x / 0.15f); };
    const std::vector<Vec3> points = floorPoints();
    const auto answers = [&] {
        std::vector<float> result;
        for (const Vec3& p : points) result.push_back(answerAt(cells, p));
        return result;
    };
    commit(cells, depositsAt(points, light));
    const std::vector<float> before = answers();
    EXPECT_GT(*std::ranges::min_element(before), 0);
    const float least = leastReach(cells);
    cells.refine();
    EXPECT_EQ(answers(), before);
    EXPECT_NEAR(leastReach(cells) / least, 0.5, 1e-3);
    commit(cells, {});
    EXPECT_EQ(answers(), before);
    // A single deposit everywhere else than in the cells that are asked makes no difference either.
    commit(cells, {deposit(Vec3(100.f), kUp, 1)});
    EXPECT_EQ(answers(), before);
    const auto error = [&] {
        std::vector<float> result;
        for (const Vec3& p : points) result.push_back(std::abs(answerAt(cells, p) - light(p)));
        return meanOf(result);
    };
    const double coarse = error();
    for (int i = 0; i < 2; ++i) commit(cells, depositsAt(points, light));
    EXPECT_LT(error(), 0.75 * coarse);
}

// A deposit so bright that it alone decides the answer of all cells around it.
TEST(RadianceCells, DoNotShowASingleFireflyToEveryone) {
    RadianceCells cells(settingsOf());
    Deposits deposits;
    for (const Vec3& p : floorPoints(0, 32)) deposits.push_back(deposit(p, kUp, 1));
    const Vec3 bright = deposits[deposits.size() / 2].at.p;
    commit(cells, deposits);
    commit(cells, {deposit(bright, kUp, 1e7f)});
    EXPECT_GT(answerAt(cells, bright), 1);
    EXPECT_LT(answerAt(cells, bright), 50);
    // The mean over the largest cell of these hardly changes.
    EXPECT_NEAR(answerAt(cells, bright + Vec3(0.9f * largest(settingsOf()), 0, 0)), 1, 0.5f);
}

TEST(RadianceCells, DoNotShowAFireflyOfTheFirstPassEither) {
    RadianceCells cells(settingsOf());
    Deposits deposits;
    for (const Vec3& p : floorPoints(0, 32)) deposits.push_back(deposit(p, kUp, 1));
    const size_t middle = deposits.size() / 2;
    deposits[middle].light = Rgb(1e9f);
    const Vec3 bright = deposits[middle].at.p;
    commit(cells, deposits);
    EXPECT_LT(answerAt(cells, bright), 100);
}

// What is rare, but not so rare that the largest cells do not know it, counts in full.
TEST(RadianceCells, KeepTheLightOfRareSamples) {
    RadianceCells cells(settingsOf(1));
    Pcg32 random(3);
    constexpr int kCount = 40000, kRare = 200;
    double sum = 0;
    for (int pass = 0; pass < 4; ++pass) {
        Deposits deposits;
        for (int i = 0; i < kCount / 4; ++i) {
            const float light = random.nextFloat() * kRare < 1 ? kRare : 0;
            sum += double(light);
            deposits.push_back(
                deposit(Vec3(random.nextFloat() * kSize / 4, random.nextFloat() * kSize / 4, 0), kUp, light));
        }
        commit(cells, deposits);
    }
    EXPECT_NEAR(answerAt(cells, Vec3(kSize / 8, kSize / 8, 0)), sum / kCount, 1e-3 * sum / kCount);
}

}  // namespace
}  // namespace drc
