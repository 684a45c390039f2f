#include "integrators/sample_density.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.h"
#include "math/rng.h"

namespace drc {
namespace {

constexpr int kBlock = SampleDensity::kBlock;
// 8 x 3 blocks, the last of which are cut off by the end of the picture.
constexpr PixelRegion kRegion{30, 20, 30 + 7 * kBlock + 5, 20 + 2 * kBlock + 3};

// What a pixel shows, and the standard deviation of a sample of it.
struct Pixel {
    float value = 1, deviation = 0;
    Rgb albedo{0.5f};
    Vec3 normal{0, 0, 1};
};

// A picture is given by a function of column and row, from 0.
template <class Picture>
void takeSamples(SampleDensity& density, int count, const Picture& picture, uint64_t seed = 3) {
    Pcg32 random(seed);
    for (int i = 0; i < count; ++i)
        for (int y = kRegion.y0; y < kRegion.y1; ++y)
            for (int x = kRegion.x0; x < kRegion.x1; ++x) {
                const Pixel pixel = picture(x - kRegion.x0, y - kRegion.y0);
                const float value = pixel.value + (random.nextFloat() - 0.5f) * std::sqrt(12.f) * pixel.deviation;
                density.add(x, y, (x + y + i) & 1, value, {pixel.albedo, pixel.normal, 1});
            }
}

template <class Picture>
SampleDensity densityOf(const Picture& picture, int samples = 4, float scale = 1) {
    SampleDensity density(kRegion, scale);
    takeSamples(density, samples, picture);
    density.update(samples);
    return density;
}

// Of the block with a column and a row of pixels.
double at(const SampleDensity& density, int column, int row) {
    return density.density(density.blockOf(kRegion.x0 + column, kRegion.y0 + row));
}

double meanOf(const SampleDensity& density) {
    double sum = 0;
    for (int y = kRegion.y0; y < kRegion.y1; ++y)
        for (int x = kRegion.x0; x < kRegion.x1; ++x) sum += density.density(density.blockOf(x, y));
    return sum / double(kRegion.count());
}

TEST(SampleDensity, IsOneBeforeAnythingIsKnown) {
    SampleDensity density(kRegion, 1);
    EXPECT_EQ(at(density, 0, 0), 1);
    density.update(1);
    EXPECT_EQ(at(density, 0, 0), 1);
}

TEST(SampleDensity, IsEvenWhereAllIsAlike) {
    const SampleDensity density = densityOf([](int, int) { return Pixel{.deviation = 0.3f}; }, 64);
    EXPECT_NEAR(meanOf(density), 1, 1e-6);
    for (int column = 0; column < kRegion.width(); column += kBlock) EXPECT_NEAR(at(density, column, 0), 1, 0.25);
}

TEST(SampleDensity, IsGreaterWhereThereIsNoise) {
    const auto picture = [](int x, int) {
        return Pixel{.deviation = x < kBlock ? 0.8f : x < 2 * kBlock ? 0.4f : 0.1f};
    };
    const SampleDensity density = densityOf(picture);
    EXPECT_NEAR(meanOf(density), 1, 1e-3);
    EXPECT_GT(at(density, 0, 0), 1.2 * at(density, kBlock, 0));
    EXPECT_GT(at(density, kBlock, 0), 1.5 * at(density, 4 * kBlock, 0));
}

// Noise of the same size is greater where it is relative to less light, and where the picture is displayed darker it is
// hidden.
TEST(SampleDensity, IsRelativeToTheDisplayedRadiance) {
    const auto picture = [](int x, int) { return Pixel{.value = x < kBlock ? 0.25f : 1.f, .deviation = 0.2f}; };
    EXPECT_GT(at(densityOf(picture), 0, 0), 1.5 * at(densityOf(picture), 4 * kBlock, 0));
    const auto scaled = [&](int x, int y) {
        Pixel pixel = picture(x, y);
        pixel.value *= 1024;
        pixel.deviation *= 1024;
        return pixel;
    };
    const SampleDensity once = densityOf(picture), times1024 = densityOf(scaled, 4, 1.f / 1024);
    for (size_t block = 0; block < once.blocks(); ++block)
        EXPECT_FLOAT_EQ(once.density(block), times1024.density(block));
}

// Where surfaces change from pixel to pixel, a denoiser has nothing to average over.
TEST(SampleDensity, IsGreaterAtDetailOfTheSurfacesThanWithinThem) {
    const auto normals = [](int x, int y) {
        const bool detail = x < kBlock && ((x / 4 + y / 4) & 1);
        return Pixel{.deviation = 0.3f, .normal = detail ? Vec3(1, 0, 0) : Vec3(0, 0, 1)};
    };
    const auto albedos = [](int x, int y) {
        const bool detail = x < kBlock && ((x / 4 + y / 4) & 1);
        return Pixel{.deviation = 0.3f, .albedo = Rgb(detail ? 0.8f : 0.5f)};
    };
    const SampleDensity byNormal = densityOf(normals), byAlbedo = densityOf(albedos);
    EXPECT_GT(at(byNormal, 0, 0), 1.2 * at(byNormal, 4 * kBlock, 0));
    EXPECT_GT(at(byAlbedo, 0, 0), 1.2 * at(byAlbedo, 4 * kBlock, 0));
}

TEST(SampleDensity, IsGreaterWhereNoiseMeetsContrast) {
    const auto picture = [](int x, int) {
        const bool bright = x < kBlock && (x / 8 & 1);
        return Pixel{.value = bright ? 3.f : 1.f, .deviation = bright ? 0.9f : 0.3f};
    };
    const SampleDensity density = densityOf(picture);
    EXPECT_GT(at(density, 0, 0), 1.5 * at(density, 4 * kBlock, 0));
}

// Texture and shading without noise need no samples, whichever half of them shows it.
TEST(SampleDensity, DoesNotTakeDetailForNoise) {
    const auto picture = [](int x, int y) {
        return Pixel{.value = x < kBlock ? 1 + 0.5f * std::sin(0.9f * float(x) + 1.3f * float(y)) : 1.f,
                     .deviation = x < kBlock ? 0.f : 0.3f};
    };
    const SampleDensity density = densityOf(picture);
    EXPECT_EQ(at(density, 0, 0), SampleDensity::kLeast);
}

TEST(SampleDensity, HasBounds) {
    const auto picture = [](int x, int y) { return Pixel{.deviation = x + y == 0 ? 1e6f : 1e-3f}; };
    const SampleDensity density = densityOf(picture);
    EXPECT_LE(at(density, 0, 0), SampleDensity::kMost);
    EXPECT_GE(at(density, 4 * kBlock, 0), SampleDensity::kLeast);
    EXPECT_NEAR(meanOf(density), 1, 1e-6);
}

// What is estimated is the noise of one sample, however many a block has had.
TEST(SampleDensity, DoesNotDependOnHowManySamplesABlockHasHad) {
    SampleDensity density(kRegion, 1);
    const auto noisy = [](int, int) { return Pixel{.deviation = 0.3f}; };
    takeSamples(density, 16, noisy);
    Pcg32 random(11);
    for (int i = 0; i < 16 * 7; ++i)
        for (int y = kRegion.y0; y < kRegion.y0 + kBlock; ++y)
            for (int x = kRegion.x0; x < kRegion.x0 + kBlock; ++x)
                density.add(x, y, i & 1, 1 + (random.nextFloat() - 0.5f) * std::sqrt(12.f) * 0.3f,
                            {Rgb(0.5f), Vec3(0, 0, 1), 1});
    density.update(16);
    EXPECT_NEAR(at(density, 0, 0), 1, 0.25);
}

// Cells that no sample has been taken of, which a crop or a lens that lets nothing through may leave.
TEST(SampleDensity, BearsCellsWithoutSamples) {
    SampleDensity density(kRegion, 1);
    for (int half : {0, 1})
        for (int i = 0; i < 40; ++i) density.add(kRegion.x0 + i, kRegion.y0, half, float(i + half), {});
    density.update(1);
    EXPECT_NEAR(meanOf(density), 1, 1e-3);
    EXPECT_EQ(at(density, kRegion.width() - 1, kRegion.height() - 1), SampleDensity::kLeast);
}

class SavedSampleDensity : public testing::Test {
  protected:
    void TearDown() override { std::filesystem::remove(path_); }
    const std::string path_ = (std::filesystem::temp_directory_path() /
                               ("drc-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name())))
                                  .string();
};

TEST_F(SavedSampleDensity, GoesOnAsIfItHadNotBeenSaved) {
    const auto picture = [](int x, int) { return Pixel{.deviation = x < kBlock ? 0.8f : 0.1f}; };
    SampleDensity whole = densityOf(picture), loaded(kRegion, 1);
    // Samples that no update has seen yet.
    takeSamples(
        whole, 1, [](int x, int) { return Pixel{.deviation = x < kBlock ? 0.1f : 0.8f}; }, 5);
    StateWriter to(path_, "density 1");
    whole.save(to);
    to.commit();
    StateReader from(path_, "density", "density 1");
    loaded.load(from);
    from.finish();
    for (size_t block = 0; block < whole.blocks(); ++block) EXPECT_EQ(whole.density(block), loaded.density(block));
    const double before = at(loaded, 0, 0);
    for (SampleDensity* density : {&whole, &loaded}) density->update(20);
    EXPECT_NE(at(loaded, 0, 0), before);
    for (size_t block = 0; block < whole.blocks(); ++block) EXPECT_EQ(whole.density(block), loaded.density(block));
}

TEST_F(SavedSampleDensity, RefusesDensitiesThatCannotBe) {
    StateWriter to(path_, "density 1");
    for (int i = 0; i < 100000; ++i) to.value(int32_t(0));
    to.commit();
    StateReader from(path_, "density", "density 1");
    SampleDensity density(kRegion, 1);
    EXPECT_THROW(density.load(from), Error);
}

}  // namespace
}  // namespace drc
