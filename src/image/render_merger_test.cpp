#include "image/render_merger.h"

#include <gmock/gmock.h>

#include <random>

#include "base/folder_testing.h"
#include "base/log.h"
#include "image/image_layers.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

const std::vector<std::string> kChannels{"R",
                                         "G",
                                         "B",
                                         "Denoising Albedo.R",
                                         "Denoising Variance.R",
                                         "Denoising Variance.G",
                                         "Denoising Variance.B",
                                         "Debug Sample Count.X"};

// A render of one pixel.
PictureFile render(const std::string& seed, float radiance, float variance, float samples, float albedo = 0.5f) {
    PictureFile file{"seed" + seed + ".exr", Image(1, 1, kChannels), Encoding::Float, {{"drc:seed", seed}}, {}};
    file.metadata["drc:spp"] = "8";
    file.image.data() = {radiance, 2 * radiance, 0, albedo, variance, 4 * variance, 0, samples};
    return file;
}

Image merged(const std::vector<PictureFile>& renders) {
    RenderMerger merger;
    for (const PictureFile& file : renders) merger.add(file);
    return merger.merged().image;
}

std::string complaint(const std::vector<PictureFile>& renders) {
    return errorOf([&] { merged(renders); });
}

TEST(RenderMerger, WeighsBySamplesAndCombinesVariances) {
    const Image m = merged({render("0", 1, 0.3f, 2), render("1", 2, 0.05f, 6)});
    EXPECT_FLOAT_EQ(m.at(0, 0, 0), (2 * 1 + 6 * 2) / 8.f);
    EXPECT_FLOAT_EQ(m.at(0, 0, 1), 2 * (2 * 1 + 6 * 2) / 8.f);
    EXPECT_FLOAT_EQ(m.at(0, 0, 4), (4 * 0.3f + 36 * 0.05f) / 64);
    EXPECT_FLOAT_EQ(m.at(0, 0, 5), 4 * (4 * 0.3f + 36 * 0.05f) / 64);
    EXPECT_FLOAT_EQ(m.at(0, 0, 3), 0.5f);
    EXPECT_EQ(m.at(0, 0, 7), 8);
}

TEST(RenderMerger, OrderAndGroupingChangeNothingButRounding) {
    const PictureFile a = render("0", 1, 0.3f, 2), b = render("1", 2, 0.05f, 6), c = render("2", 1.5f, 0.1f, 5);
    RenderMerger pair;
    pair.add(a);
    pair.add(b);
    EXPECT_EQ(pair.merged().metadata.at("drc:seed"), "0,1");
    EXPECT_EQ(pair.merged().metadata.at("drc:spp"), "16");
    const Image all = merged({a, b, c}), nested = merged({c, pair.merged()});
    for (int i = 0; i < all.channels(); ++i) EXPECT_NEAR(all.at(0, 0, i), nested.at(0, 0, i), 1e-6) << i;
    EXPECT_THAT(complaint({pair.merged(), b}), HasSubstr("have the same seed 1"));
}

// One sample does not know its variance; it has as much of it, though.
TEST(RenderMerger, ASingleSampleIsTakenToVaryAsTheOthers) {
    const Image m = merged({render("0", 1, 0, 1), render("1", 2, 0.1f, 4)});
    EXPECT_FLOAT_EQ(m.at(0, 0, 4), 4 * 0.1f / 5);
}

// Where no render knows, the spread of the renders tells: unbiased over many pixels, with samples of variance 1.
TEST(RenderMerger, TheSpreadOfRendersTellsTheVarianceOfSingleSamples) {
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    double sum = 0, squares = 0;
    constexpr int kTrials = 4000, kRenders = 3;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<PictureFile> renders;
        for (int i = 0; i < kRenders; ++i) renders.push_back(render(std::to_string(i), 5 + normal(random), 0, 1));
        const double variance = double(merged(renders).at(0, 0, 4));
        sum += variance;
        squares += variance * variance;
    }
    const double mean = sum / kTrials, error = std::sqrt((squares / kTrials - mean * mean) / kTrials);
    EXPECT_NEAR(mean, 1.0 / kRenders, 4 * error);
}

TEST(RenderMerger, ErrorsOfRendersAreNotThatOfTheirMean) {
    PictureFile a = render("0", 1, 0.3f, 2), b = render("1", 2, 0.05f, 6);
    for (PictureFile* picture : {&a, &b}) {
        std::vector<std::string> names = picture->image.channelNames();
        names.push_back(std::string(kErrorLayer) + ".X");
        std::vector<float> values = picture->image.data();
        values.push_back(0.02f);
        picture->image = Image(1, 1, names);
        picture->image.data() = values;
        picture->metadata["drc:error"] = "0.02";
    }
    RenderMerger merger;
    merger.add(a);
    merger.add(b);
    const PictureFile both = merger.merged();
    EXPECT_FALSE(both.metadata.contains("drc:error"));
    EXPECT_FALSE(layerOf(both.image, kErrorLayer));
    EXPECT_EQ(both.image.channels(), a.image.channels() - 1);
}

TEST(RenderMerger, WithoutCountsTheMetadataWeighs) {
    PictureFile a{"a.exr", Image(1, 1), Encoding::Float, {{"drc:seed", "0"}, {"drc:spp", "3"}}, {}}, b = a;
    b.path = "b.exr";
    b.metadata = {{"drc:seed", "1"}, {"drc:spp", "1"}};
    a.image.setRgb(0, 0, Rgb(4, 0, 0));
    EXPECT_EQ(merged({a, b}).rgb(0, 0), Rgb(3, 0, 0));
    for (const char* bad : {"", "-1", "0", "many", "1e9", "99999999999999999999"}) {
        b.metadata["drc:spp"] = bad;
        EXPECT_THAT(complaint({a, b}), AllOf(HasSubstr("b.exr does not tell its number of samples"),
                                             HasSubstr("drc image average"), testing::Not(HasSubstr("\n"))))
            << bad;
    }
}

TEST(RenderMerger, PixelsThatAreNoNumbersOrHaveNoSamplesAreLeftOut) {
    testing::internal::CaptureStderr();
    const Image m = merged({render("0", kNan, 1, 2), render("1", 2, 0.05f, 6)});
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("seed0.exr: 1 pixel(s) are NaN or infinite"));
    EXPECT_FLOAT_EQ(m.at(0, 0, 0), 2);
    EXPECT_FLOAT_EQ(m.at(0, 0, 4), 0.05f);
    EXPECT_EQ(m.at(0, 0, 7), 6);
    EXPECT_EQ(merged({render("0", 9, 1, 0), render("1", 2, 0.05f, 6)}).at(0, 0, 0), 2);
    // Filled in from neighbours, where no render has a sample.
    const Image filled = merged({render("0", 1, 0, 0), render("1", 3, 0, 0)});
    EXPECT_EQ(filled.at(0, 0, 0), 2);
    EXPECT_EQ(filled.at(0, 0, 7), 0);
    const Image unknown = merged({render("0", 1, kNan, 4), render("1", 3, 0.2f, 4, kNan)});
    EXPECT_FLOAT_EQ(unknown.at(0, 0, 4), 0.1f);
    EXPECT_EQ(unknown.at(0, 0, 0), 2);
}

TEST(RenderMerger, SaysWhatDoesNotFit) {
    const PictureFile a = render("0", 1, 0.1f, 8), b = render("1", 2, 0.1f, 8);
    PictureFile other = b;
    other.image = Image(2, 1, kChannels);
    EXPECT_EQ(complaint({a, other}), "seed1.exr is 2x1, but seed0.exr is 1x1: only pictures of one size can be merged");
    other = b;
    other.image = b.image.toRgb();
    EXPECT_EQ(complaint({a, other}),
              "seed1.exr has no channel Denoising Albedo.R, which seed0.exr has: give all renders the same --aovs");
    EXPECT_THAT(complaint({other, a}), HasSubstr("seed1.exr has no channel Denoising Albedo.R, which seed0.exr has"));
    other = b;
    other.window = {1, 0, 4, 4};
    EXPECT_EQ(complaint({a, other}), "seed1.exr and seed0.exr show different parts of the film");
    other = b;
    other.metadata["drc:seed"] = "0";
    EXPECT_EQ(complaint({a, other}),
              "seed0.exr and seed1.exr have the same seed 0, so that samples would count twice: render one with "
              "another --seed");
    other = a;
    other.path = "copy.exr";
    other.metadata.erase("drc:seed");
    EXPECT_THAT(complaint({a, other}), HasSubstr("copy.exr is the same picture as one before it"));
    for (const float bad : {kNan, -1.f, kInfinity})
        EXPECT_THAT(complaint({a, render("1", 2, 0.1f, bad)}),
                    AllOf(HasSubstr("seed1.exr: the layer \"Debug Sample Count\" has"), HasSubstr("at (0, 0)")));
    other.image = Image(1, 1, {"Z"});
    EXPECT_THAT(complaint({other}), HasSubstr("copy.exr has no channels R, G and B"));
}

TEST(RenderMerger, WarnsOfWhatIsLikelyAMistake) {
    PictureFile a = render("0", 1, 0.1f, 8), b = render("1", 2, 0.1f, 8);
    b.metadata["drc:integrator"] = "bdpt";
    b.metadata["drc:denoiser"] = "oidn high";
    forgetWarnings();
    testing::internal::CaptureStderr();
    merged({a, b});
    EXPECT_THAT(testing::internal::GetCapturedStderr(),
                AllOf(HasSubstr("different integrators"), HasSubstr("seed1.exr is denoised")));
}

// With a point that the camera sees, and its number; a depth of 1e10: nothing.
PictureFile renderOfSurface(const std::string& seed, float samples, float x, float depth, float object) {
    PictureFile file{"seed" + seed + ".exr",
                     Image(1, 1, {"R", "G", "B", "Debug Sample Count.X", "Position.X", "Depth.Z", "IndexOB.X"}),
                     Encoding::Float,
                     {{"drc:seed", seed}},
                     {}};
    file.image.data() = {1, 1, 1, samples, x, depth, object};
    return file;
}

TEST(RenderMerger, PointsAreMeansOverTheRendersThatHaveThem) {
    const PictureFile two = renderOfSurface("0", 2, 3, 5, 7), six = renderOfSurface("1", 6, 4, 6, 7),
                      none = renderOfSurface("2", 8, 0, kNoDepth, 7);
    const auto values = [](const Image& m) { return std::vector<float>(m.data().begin() + 4, m.data().end()); };
    EXPECT_EQ(values(merged({two, six})), (std::vector<float>{3.75f, 5.75f, 7}));
    EXPECT_EQ(values(merged({none, two, six})), (std::vector<float>{3.75f, 5.75f, 7}));
    EXPECT_EQ(values(merged({none, renderOfSurface("3", 4, 0, kNoDepth, 7)})), (std::vector<float>{0, kNoDepth, 7}));
}

TEST(RenderMerger, RefusesOtherFrames) {
    PictureFile still = render("0", 1, 0.3f, 2), zeroth = render("1", 2, 0.3f, 2), third = render("2", 3, 0.3f, 2),
                again = render("3", 4, 0.3f, 2);
    zeroth.metadata["drc:frame"] = "0";
    third.metadata["drc:frame"] = again.metadata["drc:frame"] = "3";
    EXPECT_EQ(complaint({still, zeroth}), "");
    EXPECT_EQ(complaint({third, again}), "");
    EXPECT_THAT(complaint({still, third}), HasSubstr("seed2.exr is of frame 3, but seed0.exr is of frame 0"));
}

}  // namespace
}  // namespace drc
