#include "neural/unet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <thread>

#include "base/error.h"

namespace drc {
namespace {

// A straightforward reference implementation: planes of doubles, one map at a time.
struct Planes {
    int channels = 0, size = 0;
    std::vector<double> v;
    Planes(int c, int s) : channels(c), size(s), v(size_t(c) * s * s) {}
    double& at(int c, int y, int x) { return v[(size_t(c) * size + y) * size + x]; }
    double at(int c, int y, int x) const { return v[(size_t(c) * size + y) * size + x]; }
    double padded(int c, int y, int x) const { return y < 0 || x < 0 || y >= size || x >= size ? 0 : at(c, y, x); }
};

// `added`: added to the sum before the activation.
Planes conv(const Planes& in, const UNetWeights::Conv& c, double slope, const Planes* added = nullptr) {
    EXPECT_EQ(in.channels, c.shape.in);
    const int filterInputs = c.shape.depthwise ? 1 : in.channels;
    const int k = c.shape.kernel;
    Planes out(c.shape.out, in.size);
    for (int o = 0; o < out.channels; ++o)
        for (int y = 0; y < in.size; ++y)
            for (int x = 0; x < in.size; ++x) {
                double sum = c.bias[size_t(o)];
                for (int i = 0; i < filterInputs; ++i)
                    for (int dy = 0; dy < k; ++dy)
                        for (int dx = 0; dx < k; ++dx)
                            sum += c.weight[((size_t(o) * filterInputs + i) * k + dy) * k + dx] *
                                   in.padded(c.shape.depthwise ? o : i, y + dy - k / 2, x + dx - k / 2);
                if (added) sum += added->at(o, y, x);
                double y0 = sum > 0 ? sum : slope * sum;
                if (c.shape.affine) y0 = c.scale[size_t(o)] * y0 + c.shift[size_t(o)];
                out.at(o, y, x) = y0;
            }
    return out;
}

Planes pool(const Planes& in) {
    Planes out(in.channels, in.size / 2);
    for (int c = 0; c < in.channels; ++c)
        for (int y = 0; y < out.size; ++y)
            for (int x = 0; x < out.size; ++x)
                out.at(c, y, x) = std::max(std::max(in.at(c, 2 * y, 2 * x), in.at(c, 2 * y, 2 * x + 1)),
                                           std::max(in.at(c, 2 * y + 1, 2 * x), in.at(c, 2 * y + 1, 2 * x + 1)));
    return out;
}

Planes upsample(const Planes& in) {
    Planes out(in.channels, in.size * 2);
    for (int c = 0; c < in.channels; ++c)
        for (int y = 0; y < out.size; ++y)
            for (int x = 0; x < out.size; ++x) {
                const double sy = std::clamp((y + 0.5) / 2 - 0.5, 0.0, in.size - 1.0);
                const double sx = std::clamp((x + 0.5) / 2 - 0.5, 0.0, in.size - 1.0);
                const int y0 = int(sy), x0 = int(sx), y1 = std::min(y0 + 1, in.size - 1),
                          x1 = std::min(x0 + 1, in.size - 1);
                const double fy = sy - y0, fx = sx - x0;
                out.at(c, y, x) = (1 - fy) * ((1 - fx) * in.at(c, y0, x0) + fx * in.at(c, y0, x1)) +
                                  fy * ((1 - fx) * in.at(c, y1, x0) + fx * in.at(c, y1, x1));
            }
    return out;
}

Planes stack(const Planes& a, const Planes& b) {
    Planes out(a.channels + b.channels, a.size);
    std::copy(a.v.begin(), a.v.end(), out.v.begin());
    std::copy(b.v.begin(), b.v.end(), out.v.begin() + std::ptrdiff_t(a.v.size()));
    return out;
}

std::vector<double> reference(const UNetWeights& weights, const float* input) {
    const UNetShape& shape = weights.shape();
    const auto named = [&](const std::string& name) -> const UNetWeights::Conv& {
        for (const auto& c : weights.convs())
            if (c.shape.name == name) return c;
        throw Error("no " + name);
    };
    const auto block = [&](const std::string& level, const Planes& in) {
        switch (shape.kind) {
            case UNetKind::Residual: {
                const Planes straight = conv(in, named(level + ".straight"), 1);
                return conv(conv(in, named(level + ".0"), 0.2), named(level + ".1"), 0.2, &straight);
            }
            case UNetKind::Separable: {
                Planes y = conv(in, named(level + ".in"), 0.2);
                for (const char* i : {".0", ".1"})
                    y = conv(conv(y, named(level + i + ".space"), 1), named(level + i + ".channels"), 0.2);
                return y;
            }
            default:
                return conv(conv(in, named(level + ".0"), 0.2), named(level + ".1"), 0.2);
        }
    };
    Planes x(shape.inputs, shape.size);
    std::copy_n(input, x.v.size(), x.v.begin());
    std::vector<Planes> skips;
    for (int l = 0; l < shape.levels; ++l) {
        const std::string level = "enc" + std::to_string(l);
        if (l) x = pool(x);
        x = block(level, x);
        skips.push_back(x);
    }
    for (int l = shape.levels - 2; l >= 0; --l) {
        const std::string level = "dec" + std::to_string(l);
        x = block(level, stack(skips[size_t(l)], upsample(x)));
    }
    return conv(x, named("out"), 0).v;
}

std::vector<float> randomInput(const UNetShape& shape, int count, unsigned seed = 5) {
    std::mt19937 generator(seed);
    std::normal_distribution<float> normal(0, 0.5f);
    std::vector<float> values(size_t(count) * shape.inputs * shape.size * shape.size);
    for (float& v : values) v = normal(generator);
    return values;
}

// RMS of the difference, relative to the RMS of the reference.
double relativeError(const float* values, const std::vector<double>& expected) {
    double difference = 0, total = 0;
    for (size_t i = 0; i < expected.size(); ++i) {
        difference += (values[i] - expected[i]) * (values[i] - expected[i]);
        total += expected[i] * expected[i];
    }
    EXPECT_GT(total, 0);
    return std::sqrt(difference / total);
}

Precision fastest() { return cpuHasBf16() ? Precision::Bf16 : Precision::Fp32; }

struct Case {
    int width, levels, size;
    UNetKind kind = UNetKind::Plain;
};

class UNetMatches : public testing::TestWithParam<Case> {};

TEST_P(UNetMatches, ANaiveReference) {
    UNetShape shape;
    shape.width = GetParam().width, shape.levels = GetParam().levels, shape.size = GetParam().size;
    shape.kind = GetParam().kind;
    const auto weights = UNetWeights::random(shape, 3);
    const int count = 3;  // more than one map, but less than a batch
    const auto input = randomInput(shape, count);
    const size_t texels = size_t(shape.size) * shape.size;
    std::vector<float> output(count * 3 * texels, -1);
    for (Precision precision : {Precision::Fp32, Precision::Bf16}) {
        if (precision == Precision::Bf16 && !cpuHasBf16()) continue;
        UNet net(weights, 8, precision);
        net.run(input.data(), output.data(), count);
        for (int i = 0; i < count; ++i) {
            const auto expected = reference(*weights, input.data() + i * shape.inputs * texels);
            EXPECT_LT(relativeError(output.data() + i * 3 * texels, expected),
                      precision == Precision::Fp32 ? 1e-5 : 2e-2);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, UNetMatches,
                         testing::Values(Case{4, 4, 32}, Case{8, 4, 32}, Case{16, 3, 16}, Case{8, 1, 32},
                                         Case{8, 4, 32, UNetKind::Residual}, Case{8, 2, 16, UNetKind::Residual},
                                         Case{8, 4, 32, UNetKind::Separable}, Case{12, 3, 32, UNetKind::Separable},
                                         Case{8, 4, 32, UNetKind::Paper}, Case{4, 3, 16, UNetKind::Paper}));

TEST(UNet, AnyCountGivesTheSameBitsAsOneAtATime) {
    UNetShape shape;
    shape.width = 16;
    const auto weights = UNetWeights::random(shape, 1);
    const int count = 19;  // two full batches of 8, and a partial one
    const auto input = randomInput(shape, count);
    const size_t in = 7 * 32 * 32, out = 3 * 32 * 32;
    std::vector<float> together(count * out), single(count * out);
    UNet net(weights, 8, fastest());
    net.run(input.data(), together.data(), count);
    for (int i = 0; i < count; ++i) net.run(input.data() + i * in, single.data() + i * out, 1);
    EXPECT_EQ(together, single);
    net.run(input.data(), single.data(), 0);
    EXPECT_EQ(together, single);
}

TEST(UNet, ThreadsGiveTheSameBits) {
    UNetShape shape;
    shape.width = 16;
    const auto weights = UNetWeights::random(shape, 2);
    const int count = 16;
    const auto input = randomInput(shape, count);
    const size_t in = 7 * 32 * 32, out = 3 * 32 * 32;
    std::vector<float> alone(count * out), shared(count * out);
    UNet(weights, 8, fastest()).run(input.data(), alone.data(), count);
    std::thread threads[2];
    for (int t = 0; t < 2; ++t)
        threads[t] = std::thread([&, t] {
            UNet net(weights, 8, fastest());
            for (int pass = 0; pass < 5; ++pass) net.run(input.data() + t * 8 * in, shared.data() + t * 8 * out, 8);
        });
    for (auto& t : threads) t.join();
    EXPECT_EQ(alone, shared);

    // Constructed on this thread, run on another.
    UNet net(weights, 8, fastest());
    std::fill(shared.begin(), shared.end(), 0.f);
    std::thread([&] { net.run(input.data(), shared.data(), count); }).join();
    EXPECT_EQ(alone, shared);
}

// Doubling the last layer's weights doubles the error exactly, since a power of two changes no rounding.
TEST(UNet, Bf16IsForWeightsThatBearIt) {
    if (!cpuHasBf16()) GTEST_SKIP() << "no bf16 on this processor";
    UNetShape shape;
    shape.width = 8;
    const auto scaledBy = [&](float factor) {
        std::vector<UNetWeights::Conv> convs = UNetWeights::random(shape, 4)->convs();
        for (float& w : convs.back().weight) w *= factor;
        for (float& b : convs.back().bias) b *= factor;
        return std::make_shared<const UNetWeights>(shape, std::move(convs));
    };
    const float error = bf16Error(*scaledBy(1));
    ASSERT_GT(error, 0);
    float factor = 1;
    while (factor * error > 0.008f) factor /= 2;
    while (2 * factor * error <= 0.008f) factor *= 2;
    EXPECT_FLOAT_EQ(bf16Error(*scaledBy(factor)), factor * error);
    EXPECT_EQ(bestPrecision(*scaledBy(factor)), Precision::Bf16);
    EXPECT_EQ(bestPrecision(*scaledBy(2 * factor)), Precision::Fp32);
}

TEST(UNet, OutputIsNeverNegative) {
    UNetShape shape;
    shape.width = 8;
    const auto input = randomInput(shape, 1);
    std::vector<float> output(3 * 32 * 32);
    UNet(UNetWeights::random(shape, 9), 1, fastest()).run(input.data(), output.data(), 1);
    for (float v : output) EXPECT_GE(v, 0);
}

TEST(UNet, RefusesAnEmptyBatch) {
    UNetShape shape;
    shape.width = 4;
    EXPECT_THROW(UNet(UNetWeights::random(shape, 1), 0, Precision::Fp32), Error);
}

// The size of the authors' own network: 5,465,027 parameters and 495.06 million multiply-adds.
TEST(UNetShape, PaperIsAsLargeAsTheAuthors) {
    UNetShape shape;
    shape.kind = UNetKind::Paper;
    shape.width = 64;
    EXPECT_EQ(shape.parameterCount(), 5465027u);
    EXPECT_NEAR(shape.macs(), 495.06e6, 0.01e6);
}

TEST(UNetShape, PlainIsTheSymmetricUNet) {
    UNetShape shape;
    shape.width = 64;
    // 7790723 is the count with batch normalisation of all 2688 channels; the encoder's first level has none here.
    EXPECT_EQ(shape.parameterCount(), 7790723u - 2u * 2688u);
    EXPECT_NEAR(shape.macs(), 664.93e6, 0.01e6);
}

TEST(UNetShape, KindsHaveNames) {
    for (const UNetKind kind : kUNetKinds) EXPECT_EQ(parseUNetKind(unetKindName(kind)), kind);
    EXPECT_THROW(parseUNetKind("resnet"), Error);
}

}  // namespace
}  // namespace drc
