#include "maps/example_record.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "base/folder_testing.h"
#include "maps/example_testing.h"

namespace drc {
namespace {

const MapLayout kLayout(Projection::EqualArea, 8);

TrainingExample restored(const TrainingExample& example, int first = 0, int count = -1) {
    const int inputs = int(example.inputs.size());
    TrainingExample result;
    decodeExample(encodeExample(example, kLayout), kLayout, inputs, first, count < 0 ? inputs : count, result);
    return result;
}

void expectClose(const std::vector<float>& a, const std::vector<float>& b, float relative, float absolute = 0) {
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], relative * std::abs(b[i]) + absolute) << i;
}

constexpr float kHalf = 1.f / 2048;  // largest relative rounding error of a half

TEST(ExampleRecord, KeepsAnExample) {
    for (unsigned seed : {1u, 2u}) {
        TrainingExample example = randomExample(kLayout, 3, seed);
        example.viewpoint = 1234567;
        const TrainingExample back = restored(example);
        EXPECT_EQ(back.viewpoint, example.viewpoint);
        EXPECT_EQ(back.bounces, example.bounces);
        EXPECT_EQ(back.time, example.time);
        EXPECT_EQ(back.film, example.film);
        ASSERT_EQ(back.inputs.size(), 3u);
        for (size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(back.inputs[i].origin, example.inputs[i].origin);
            EXPECT_EQ(back.inputs[i].frame.n, example.inputs[i].frame.n);
            EXPECT_LT(length(back.inputs[i].frame.t - example.inputs[i].frame.t), 1e-6f);
            expectClose(back.inputs[i].radiance, example.inputs[i].radiance, kHalf);
            expectClose(back.inputs[i].distance, example.inputs[i].distance, kHalf);
            expectClose(back.inputs[i].normal, example.inputs[i].normal, 0, 0.5f / 32767 + 1e-7f);
            expectClose(back.inputs[i].albedo, example.inputs[i].albedo, 0, 0.5f / 255 + 1e-7f);
            expectClose(back.inputs[i].direct, example.inputs[i].direct, kHalf);
        }
        expectClose(back.target, example.target, kHalf);
        expectClose(back.targetDeviation, example.targetDeviation, kHalf);
    }
}

TEST(ExampleRecord, AnInputAloneIsTheSameAsAmongAll) {
    const TrainingExample example = randomExample(kLayout, 4, 5), all = restored(example);
    for (int i = 0; i < 4; ++i) {
        const TrainingExample one = restored(example, i, 1);
        ASSERT_EQ(one.inputs.size(), 1u);
        EXPECT_EQ(one.inputs[0].radiance, all.inputs[size_t(i)].radiance);
        EXPECT_EQ(one.inputs[0].normal, all.inputs[size_t(i)].normal);
        EXPECT_EQ(one.inputs[0].distance, all.inputs[size_t(i)].distance);
        EXPECT_EQ(one.inputs[0].albedo, all.inputs[size_t(i)].albedo);
        EXPECT_EQ(one.inputs[0].direct, all.inputs[size_t(i)].direct);
        EXPECT_EQ(one.target, all.target);
        EXPECT_EQ(one.targetDeviation, all.targetDeviation);
    }
}

// Unscaled halves would overflow at 65504 and lose all precision below 1e-7.
TEST(ExampleRecord, UnitsDoNotMatter) {
    const TrainingExample plain = randomExample(kLayout, 1, 3);
    for (const float unit : {1e-36f, 1e-20f, 1e-6f, 1e6f, 1e20f, 3e37f}) {
        SCOPED_TRACE(unit);
        TrainingExample example = plain;
        for (auto* values :
             {&example.inputs[0].radiance, &example.inputs[0].distance, &example.target, &example.targetDeviation})
            for (float& v : *values) v *= unit;
        const TrainingExample back = restored(example);
        expectClose(back.inputs[0].radiance, example.inputs[0].radiance, 2 * kHalf);
        expectClose(back.inputs[0].distance, example.inputs[0].distance, 2 * kHalf);
        expectClose(back.target, example.target, 2 * kHalf);
        expectClose(back.targetDeviation, example.targetDeviation, 2 * kHalf);
    }
}

TEST(ExampleRecord, WhatIsFaintBesideAnOutlierStays) {
    TrainingExample example = randomExample(kLayout, 1, 3);
    for (float& v : example.target) v = 1;
    example.target[7] = 0x1p29f;
    expectClose(restored(example).target, example.target, kHalf);
    example.target[7] = 0x1p37f;  // small against the largest value: stored with few bits, but not lost
    for (const float v : restored(example).target) EXPECT_GT(v, 0.5f);
}

TEST(ExampleRecord, MissesStayMisses) {
    TrainingExample example = randomExample(kLayout, 1, 3);
    for (const float unit : {1e-9f, 1.f, 1e9f}) {
        for (float& d : example.inputs[0].distance) d *= unit;
        example.inputs[0].distance[5] = -1;
        for (size_t c = 0; c < 3; ++c) example.inputs[0].normal[c * 64 + 5] = 0;
        const TrainingExample back = restored(example);
        EXPECT_EQ(back.inputs[0].distance[5], -1);
        for (size_t c = 0; c < 3; ++c) EXPECT_EQ(back.inputs[0].normal[c * 64 + 5], 0);
    }
    example.inputs[0].distance.assign(64, -1);
    EXPECT_EQ(restored(example).inputs[0].distance, example.inputs[0].distance);
}

TEST(ExampleRecord, WhatNoCaptureYieldsIsRefused) {
    const TrainingExample good = randomExample(kLayout, 2, 3);
    const auto refused = [](const TrainingExample& example) {
        return !errorOf([&] { encodeExample(example, kLayout); }).empty();
    };
    EXPECT_FALSE(refused(good));
    for (const float wrong : {NAN, INFINITY, -1.f}) {
        TrainingExample example = good;
        example.inputs[1].radiance[9] = wrong;
        EXPECT_TRUE(refused(example));
        example = good;
        example.target[9] = wrong;
        EXPECT_TRUE(refused(example));
        example = good;
        example.targetDeviation[9] = wrong;
        EXPECT_TRUE(refused(example));
    }
    TrainingExample example = good;
    example.inputs[0].distance[3] = INFINITY;
    EXPECT_TRUE(refused(example));
    example = good;
    example.inputs[0].normal[3] = NAN;
    EXPECT_TRUE(refused(example));
    example = good;
    example.target.assign(example.target.size(), 0);
    EXPECT_TRUE(refused(example));
    example = good;
    example.target.resize(12);
    EXPECT_TRUE(refused(example));
}

TEST(ExampleRecord, DamageIsNoticed) {
    const std::string record = encodeExample(randomExample(kLayout, 2, 3), kLayout);
    EXPECT_EQ(record, encodeExample(randomExample(kLayout, 2, 3), kLayout));
    TrainingExample example;
    const auto decodes = [&](const std::string& bytes) {
        return errorOf([&] { decodeExample(bytes, kLayout, 2, 0, 2, example); }).empty();
    };
    ASSERT_TRUE(decodes(record));
    const TrainingExample good = example;
    int unnoticed = 0;
    for (size_t i = 0; i < record.size(); ++i)
        for (int bit = 0; bit < 8; ++bit) {
            std::string damaged = record;
            damaged[i] = char(damaged[i] ^ 1 << bit);
            if (!decodes(damaged)) continue;
            // A flipped bit that zstd ignores must not change the content.
            EXPECT_EQ(example.target, good.target) << i;
            EXPECT_EQ(example.inputs[0].radiance, good.inputs[0].radiance) << i;
            EXPECT_EQ(example.inputs[1].distance, good.inputs[1].distance) << i;
            ++unnoticed;
        }
    EXPECT_LT(unnoticed, 20);
    for (size_t size = 0; size < record.size(); size += 7) EXPECT_FALSE(decodes(record.substr(0, size))) << size;
    EXPECT_FALSE(decodes(record + "x"));
}

}  // namespace
}  // namespace drc
