// `drc image merge` and `drc image denoise` with renders.
#include <cmath>

#include "app/image_command_testing.h"
#include "base/atomic_file.h"
#include "image/image_layers.h"
#include "image/render_merger.h"
#include "reconstruct/open_image_denoise.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class ImageMergeTest : public ImageCommandFolder {
  protected:
    // The lamp is behind the camera: pixels on its edge would have nearly all of the error, and be few.
    void SetUp() override {
        folder_.write("scene.pbrt", R"(
            Film "image" "integer xresolution" 48 "integer yresolution" 32
            Camera "perspective" "float fov" 70
            WorldBegin
            AttributeBegin
            AreaLightSource "diffuse" "rgb L" [4 4 4]
            Translate 1 2 -2 Shape "sphere" "float radius" .5
            AttributeEnd
            Shape "sphere" "float radius" 5
            WorldEnd)");
    }
    std::string render(int seed, int spp, const std::string& name, std::vector<std::string> more = {"--aovs"}) const {
        CLI::App app;
        addRenderCommand(app);
        std::vector<std::string> arguments{
            "render", path("scene.pbrt"),   "--quiet",      "-o",   path(name),  "--spp", std::to_string(spp),
            "--seed", std::to_string(seed), "--integrator", "path", "--denoise", "off"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants a vector
        app.parse(std::move(arguments));
        return path(name);
    }
};

struct Errors {
    double squares = 0;   // sum of squared differences from a reference
    double variance = 0;  // sum of the variances that the file gives
    double bias = 0;      // sum of differences
};

// Of green.
Errors errorsOf(const Image& image, const Image& reference) {
    const int variance = image.channelIndex("Denoising Variance.G");
    Errors errors;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const double difference = double(image.at(x, y, 1)) - double(reference.at(x, y, 1));
            errors.squares += difference * difference;
            errors.bias += difference;
            errors.variance += double(image.at(x, y, variance));
        }
    return errors;
}

TEST_F(ImageMergeTest, TwoSeedsHaveHalfTheVarianceOfOneAndNoBias) {
    const std::string a = render(0, 8, "a.exr"), b = render(1, 8, "b.exr");
    const Image reference = readImage(render(9, 512, "reference.exr"));
    run({"merge", a, b, "-o", path("both.exr")});
    const Errors one = errorsOf(readImage(a), reference), other = errorsOf(readImage(b), reference),
                 both = errorsOf(readImage(path("both.exr")), reference);
    // What the file says follows exactly.
    EXPECT_NEAR(both.variance, (one.variance + other.variance) / 4, 1e-4 * one.variance);
    // What is so: the error of 1536 pixels, whose squares sum up to within about 1/20.
    EXPECT_NEAR(both.squares / (one.squares + other.squares), 0.25, 0.03);
    EXPECT_NEAR(both.bias / std::sqrt(both.squares), 0, 4);
    // Between halves of a pixel's samples there is less stratification than within all: their difference overestimates
    // the variance, here by a factor of 2.
    EXPECT_LT(both.squares / both.variance, 1.1);
    EXPECT_GT(both.squares / both.variance, 0.35);
    const PictureFile file = readPictureFile(path("both.exr"));
    EXPECT_EQ(file.image.at(5, 5, file.image.channelIndex("Debug Sample Count.X")), 16);
    EXPECT_EQ(file.metadata.at("drc:spp"), "16");
    EXPECT_EQ(file.metadata.at("drc:seed"), "0,1");
}

TEST_F(ImageMergeTest, MoreSamplesWeighMore) {
    const std::string a = render(0, 12, "a.exr"), b = render(1, 4, "b.exr");
    run({"merge", a, b, "-o", path("both.exr")});
    const Image first = readImage(a), second = readImage(b), both = readImage(path("both.exr"));
    EXPECT_NEAR(both.at(20, 11, 1), 0.75f * first.at(20, 11, 1) + 0.25f * second.at(20, 11, 1), 1e-5);
    // The same by the metadata alone, of the same samples: those of independent halves.
    const std::string c = render(0, 12, "c.exr", {"--noise-threshold", "0"}),
                      d = render(1, 4, "d.exr", {"--noise-threshold", "0"});
    run({"merge", c, d, "-o", path("plain.exr")});
    EXPECT_NEAR(readImage(path("plain.exr")).at(20, 11, 1), both.at(20, 11, 1), 1e-6);
}

TEST_F(ImageMergeTest, RefusesWhatDoesNotFit) {
    const std::string a = render(0, 4, "a.exr"), more = render(0, 8, "more.exr"), plain = render(1, 4, "plain.exr", {}),
                      b = render(1, 4, "b.exr"),
                      part = render(2, 4, "part.exr", {"--aovs", "--crop", "0", "0.5", "0", "1"});
    const auto error = [&](const std::string& other) {
        return complaint({"merge", a, other, "-o", path("out.exr")}, "out.exr");
    };
    EXPECT_THAT(error(a), HasSubstr("the same picture"));
    EXPECT_THAT(error(more), AllOf(HasSubstr("a.exr and"), HasSubstr("more.exr have the same seed 0")));
    EXPECT_THAT(error(plain), HasSubstr("plain.exr has no channel"));
    EXPECT_THAT(error(part), HasSubstr("part.exr is 24x32"));
    const std::string bytes = readFile(b);
    folder_.write("cut.exr", bytes.substr(0, bytes.size() - 100));
    EXPECT_THAT(error(path("cut.exr")), HasSubstr("cannot read " + path("cut.exr")));
    EXPECT_THROW(run({"merge", a, "-o", path("out.exr")}), CLI::ParseError);
}

TEST_F(ImageMergeTest, DenoiseGoesWithoutAlbedoAndNormal) {
    try {
        const OpenImageDenoise here(findOidn(OidnSearch::ofProcess("")));
    } catch (const Error& error) {
        GTEST_SKIP() << error.what();
    }
    const std::string all = render(0, 4, "all.exr");
    const Image image = readImage(all), reference = readImage(render(9, 512, "reference.exr"));
    const auto errorOfBeauty = [&](const Image& of) {
        double sum = 0;
        for (int y = 0; y < of.height(); ++y)
            for (int x = 0; x < of.width(); ++x)
                sum += std::pow(double(of.at(x, y, 1)) - double(reference.at(x, y, 1)), 2);
        return sum;
    };
    struct Case {
        std::vector<std::string> without;
        const char* missing;
    };
    for (const auto& [without, missing] :
         {Case{{"Denoising Albedo", "Denoising Normal"}, "albedo and normal"}, Case{{"Denoising Albedo"}, "albedo"},
          Case{{"Denoising Normal"}, "normal"}}) {
        writeExr(path("part.exr"), withoutLayers(image, without));
        testing::internal::CaptureStderr();
        run({"denoise", path("part.exr"), "-o", path("out.exr")});
        EXPECT_THAT(testing::internal::GetCapturedStderr(),
                    HasSubstr(fmt::format("part.exr: it has no layer of {}, as drc render --aovs", missing)));
        const PictureFile clean = readPictureFile(path("out.exr"));
        EXPECT_EQ(clean.metadata.at("drc:denoiser"), fmt::format("oidn high without {}", missing));
        EXPECT_LT(errorOfBeauty(clean.image), .5 * errorOfBeauty(image)) << missing;
    }
}

TEST_F(ImageMergeTest, DenoiseWantsTheLayersThatAreNamed) {
    const std::string all = render(0, 4, "all.exr");
    EXPECT_THAT(complaint({"denoise", all, "-o", path("out.exr"), "--normal", "Ng"}, "out.exr"),
                HasSubstr("it has no layer or channel \"Ng\""));
    EXPECT_THAT(complaint({"denoise", all, "-o", path("out.exr"), "--oidn-library", path("none.so")}, "out.exr"),
                HasSubstr("none.so: there is no such file"));
}

TEST_F(ImageMergeTest, DenoiseLeavesTheOtherLayers) {
    try {
        const OpenImageDenoise here(findOidn(OidnSearch::ofProcess("")));
    } catch (const Error& error) {
        GTEST_SKIP() << error.what();
    }
    const std::string noisy = render(0, 4, "noisy.exr");
    Image image = readImage(noisy);
    const Image reference = readImage(render(9, 512, "reference.exr"));
    image.at(3, 3, 1) = std::numeric_limits<float>::quiet_NaN();
    writeExr(path("nan.exr"), image);
    testing::internal::CaptureStderr();
    run({"denoise", path("nan.exr"), "-o", path("out.exr")});
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("1 pixel(s) of the picture are NaN or infinite"));
    const PictureFile clean = readPictureFile(path("out.exr"));
    EXPECT_EQ(clean.metadata.at("drc:denoiser"), "oidn high");
    EXPECT_EQ(clean.image.channelNames(), image.channelNames());
    double before = 0, after = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            for (int c = 3; c < image.channels(); ++c) EXPECT_EQ(clean.image.at(x, y, c), image.at(x, y, c));
            if (x == 3 && y == 3) continue;
            before += std::pow(double(image.at(x, y, 1)) - double(reference.at(x, y, 1)), 2);
            after += std::pow(double(clean.image.at(x, y, 1)) - double(reference.at(x, y, 1)), 2);
        }
    EXPECT_TRUE(std::isfinite(clean.image.at(3, 3, 1)));
    EXPECT_LT(after, 0.3 * before);
    run({"denoise", noisy, "-o", path("out.png"), "--quality", "fast", "--prefilter", "off", "--view", "filmic"});
    EXPECT_EQ(readMetadata(path("out.png")).at("drc:denoiser"), "oidn fast without prefilter");
}

}  // namespace
}  // namespace drc
