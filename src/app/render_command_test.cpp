#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "app/command.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "base/folder_testing.h"
#include "image/auto_exposure.h"
#include "image/color.h"
#include "image/image_io.h"
#include "image/image_layers.h"
#include "image/view_transform.h"
#include "integrators/integrator.h"
#include "reconstruct/open_image_denoise.h"

namespace drc {
namespace {

using testing::HasSubstr;

class RenderCommandTest : public FolderTest {
  protected:
    void SetUp() override {
        folder_.write("scene.pbrt", R"(
            Film "image" "integer xresolution" 24 "integer yresolution" 16
            Camera "perspective" "float fov" 70
            WorldBegin
            AttributeBegin
            AreaLightSource "diffuse" "rgb L" [4 4 4]
            Translate 0 2 2 Shape "sphere" "float radius" .5
            AttributeEnd
            Shape "sphere" "float radius" 5
            WorldEnd)");
    }

    // Radiance maps, where there are any, without a network and in one pass, unless the arguments say otherwise.
    void run(std::vector<std::string> arguments) const {
        CLI::App app;
        addRenderCommand(app);
        const auto has = [&](const char* word) {
            return std::find(arguments.begin(), arguments.end(), word) != arguments.end();
        };
        if (has("drc-maps") && !has("--map-denoiser"))
            arguments.insert(arguments.begin(), {"--map-denoiser", "none", "--passes", "1"});
        if (!has("--spp")) arguments.insert(arguments.begin(), {"--spp", "8"});
        arguments.insert(arguments.begin(),
                         {"render", path("scene.pbrt"), "--quiet", "-o", path("out.exr"), "--seed", "3"});
        std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants a vector
        app.parse(std::move(arguments));
    }
    std::vector<float> picture(std::vector<std::string> arguments) const {
        run(std::move(arguments));
        return readImage(path("out.exr")).data();
    }
};

TEST_F(RenderCommandTest, DenoisesUnlessToldNotTo) {
    const std::vector<float> standard = picture({"--integrator", "drc-maps"});
    EXPECT_EQ(picture({"--integrator", "drc-maps", "--denoise", "surface"}), standard);
    EXPECT_NE(picture({"--integrator", "drc-maps", "--denoise", "off"}), standard);
}

// The render stops where its own estimate says so; --spp is the most that is done.
TEST_F(RenderCommandTest, StopsAtANoiseThreshold) {
    const auto ended = [&](const char* threshold, const char* spp) {
        run({"--integrator", "path", "--denoise", "off", "--noise-threshold", threshold, "--spp", spp, "--aovs",
             "--resolution", "120x80"});
        const ExrMetadata metadata = readExrMetadata(path("out.exr"));
        return std::pair(std::stoi(metadata.at("drc:spp")), std::stod(metadata.at("drc:error")));
    };
    const auto [coarse, coarseError] = ended("0.02", "100000");
    const auto [fine, fineError] = ended("0.01", "100000");
    EXPECT_LE(coarseError, 0.02);
    EXPECT_LE(fineError, 0.01);
    // A picture that is not denoised needs four times the samples for half of the error.
    EXPECT_GT(fine, 3 * coarse);
    EXPECT_LT(fine, 6 * coarse);
    const auto [bounded, boundedError] = ended("0.01", "16");
    EXPECT_EQ(bounded, 16);
    EXPECT_GT(boundedError, 0.01);
    // The layer has the same error, averaged in another way.
    const Image error = layerOf(readImage(path("out.exr")), kErrorLayer).value();
    double squares = 0;
    for (const float v : error.data()) squares += double(v) * v;
    EXPECT_NEAR(std::sqrt(squares / double(error.data().size())), boundedError, 0.3 * boundedError);
    EXPECT_EQ(ended("0", "12").first, 12);
}

TEST_F(RenderCommandTest, EstimatesNoErrorsWithoutHalves) {
    for (const char* integrator : {"bdpt", "drc-maps"}) try {
            run({"--integrator", integrator, "--noise-threshold", "0.1"});
            FAIL() << integrator;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr("--noise-threshold: with --integrator " + std::string(integrator)));
        }
}

// However little time there is: a picture, if a coarse one.
TEST_F(RenderCommandTest, AShortTimeGivesAPicture) {
    for (const char* integrator : {"path", "drc", "drc-maps"}) {
        run({"--integrator", integrator, "--time", "0.001", "--resolution", "160x90"});
        const Image picture = readLinearRgb(path("out.exr"));
        EXPECT_EQ(picture.width(), 160);
        int black = 0;
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 160; ++x) black += isBlack(picture.rgb(x, y));
        EXPECT_LT(black, 160 * 90 / 10) << integrator;
    }
}

TEST_F(RenderCommandTest, TheIntegratorOfTheFileHasCheckpoints) {
    const std::vector<float> whole = picture({"--integrator", "scene"});
    run({"--integrator", "scene", "--spp", "4", "--checkpoint", path("state")});
    EXPECT_EQ(picture({"--integrator", "scene", "--resume", path("state")}), whole);
}

TEST_F(RenderCommandTest, CropWindowsAreTheFilms) {
    run({"--crop", "0", ".5", "0", "1"});
    EXPECT_EQ(readImage(path("out.exr")).width(), 12);
    for (const char* bad : {".5", "1"})  // empty, and reversed
        EXPECT_THAT(errorOf([&] {
                        run({"--crop", bad, ".5", "0", "1"});
                    }),
                    testing::AllOf(HasSubstr("--crop "), HasSubstr("x0 < x1"), testing::Not(HasSubstr("\n"))));
}

TEST_F(RenderCommandTest, ACameraByHandTakesThePlaceOfTheFiles) {
    const std::vector<float> file = picture({});
    // The file's own camera, written out.
    EXPECT_EQ(picture({"--lookat", "0", "0", "0", "0", "0", "1", "0", "1", "0", "--fov", "70"}), file);
    EXPECT_NE(picture({"--lookat", "0", "0", "0", "0", "1", "1", "0", "1", "0"}), file);
    EXPECT_NE(picture({"--fov", "40"}), file);
}

// --spp is the most beside --time.
TEST_F(RenderCommandTest, EndsWithTheSamplesOrTheTime) {
    const auto start = std::chrono::steady_clock::now();
    run({"--integrator", "path", "--spp", "4", "--time", "1000"});
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(500));
    EXPECT_EQ(readExrMetadata(path("out.exr")).at("drc:spp"), "4");
}

// Before anything else is built, with what is needed and what there is; where the file says it, at its place.
TEST_F(RenderCommandTest, RefusesFilmsThatDoNotFit) {
    for (const std::string& integrator : integratorNames()) {
        const std::string text = errorOf([&] { run({"--integrator", integrator, "--resolution", "65536x65536"}); });
        EXPECT_THAT(text, testing::AllOf(HasSubstr("65536 x 65536 pixels needs about"), HasSubstr("are available"),
                                         HasSubstr("--resolution")))
            << integrator;
    }
    folder_.write("scene.pbrt",
                  "Film \"image\" \"integer xresolution\" 65536 \"integer yresolution\" 65536\nWorldBegin\n"
                  "Shape \"sphere\"\nWorldEnd\n");
    EXPECT_THAT(errorOf([&] { run({}); }), testing::AllOf(HasSubstr("scene.pbrt:1:6: "), HasSubstr("needs about")));
    run({"--crop", "0", ".0002", "0", ".0002"});
    EXPECT_EQ(readImage(path("out.exr")).width(), 14);
}

TEST_F(RenderCommandTest, ParametersOfTheFileCanBeOverridden) {
    run({"-D", "film.xresolution=12"});
    EXPECT_EQ(readImage(path("out.exr")).width(), 12);
    EXPECT_THAT(errorOf([&] { run({"-D", "film.nonsense=12"}); }), HasSubstr("nonsense"));
}

// Before the scene is read, let alone rendered.
TEST_F(RenderCommandTest, FoldersThatAreMissingAreSaidFirst) {
    folder_.write("scene.pbrt", "Nonsense");
    for (const char* option : {"-o", "--timing"})
        EXPECT_THAT(
            errorOf([&] {
                run({option, path("nowhere/file.exr")});
            }),
            testing::AllOf(HasSubstr(option + (" " + path("nowhere/file.exr"))), HasSubstr("there is no folder")));
}

TEST_F(RenderCommandTest, OnlyLayersOfRadianceMapsAreDenoised) {
    EXPECT_NO_THROW(run({"--integrator", "path", "--denoise", "off"}));
    EXPECT_THAT(errorOf([&] {
                    run({"--integrator", "path", "--denoise", "surface"});
                }),
                HasSubstr("--denoise surface: it filters the layers of --integrator drc-maps"));
    EXPECT_THROW(run({"--denoise", "much"}), CLI::ValidationError);
}

TEST_F(RenderCommandTest, OptionsOfRadianceMapsAreRefusedWhereThereAreNone) {
    std::vector<std::string> all;
    for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{{"--passes", "1"},
                                                                                        {"--indirect-tasks", "4"},
                                                                                        {"--map-denoiser", "none"},
                                                                                        {"--oracle-spp", "8"},
                                                                                        {"--weights", "drc"},
                                                                                        {"--precision", "fp32"},
                                                                                        {"--projection", "latlong"},
                                                                                        {"--spacing", "4"},
                                                                                        {"--interpolation", "distance"},
                                                                                        {"--gather-samples", "2"},
                                                                                        {"--uncorrected", ""}}) {
        std::vector<std::string> given{option};
        if (!value.empty()) given.push_back(value);
        all.insert(all.end(), given.begin(), given.end());
        EXPECT_EQ(errorOf([&] { run(given); }),
                  option + ": integrator drc has no radiance maps; only --integrator drc-maps has");
    }
    EXPECT_FALSE(std::filesystem::exists(path("out.exr")));
    EXPECT_EQ(errorOf([&] {
                  run({"--integrator", "path", "--cells", "off", "--cell-size", "0.1"});
              }),
              "--cells, --cell-size: integrator path has no radiance cells; only --integrator drc has");
    // Under their other names, as others write them, and of the integrator that the file names.
    EXPECT_THAT(errorOf([&] {
                    run({"--integrator", "scene", "--enhancer=none", "--passes=2"});
                }),
                HasSubstr("--passes, --map-denoiser: integrator path has no radiance maps"));
    all.insert(all.end(), {"--integrator", "drc-maps"});
    EXPECT_NO_THROW(run(all));
}

TEST_F(RenderCommandTest, ShowsWhatDenoisersWantAndChangesNothingElse) {
    for (const std::string& integrator : integratorNames()) {
        // Where the layers include half buffers, these take their samples by themselves, as for an estimated error.
        std::vector<std::string> options{"--integrator", integrator};
        if (traitsOf(integrator).halves) options.insert(options.end(), {"--noise-threshold", "0"});
        run(options);
        const Image plain = withoutLayers(readImage(path("out.exr")), {kErrorLayer});
        run({"--integrator", integrator, "--aovs"});
        const Image all = readImage(path("out.exr"));
        const auto channel = [&](const std::string& name, int x, int y) {
            const int index = all.channelIndex(name);
            EXPECT_GE(index, 0) << name;
            return index < 0 ? 0 : all.at(x, y, index);
        };
        for (const std::string& name : plain.channelNames())
            for (int x = 0; x < 24; ++x)
                EXPECT_EQ(channel(name, x, 5), plain.at(x, 5, plain.channelIndex(name))) << name;
        // The inside of the large ball ahead.
        EXPECT_NEAR(channel("Denoising Albedo.G", 12, 8), 0.5, 1e-3);
        EXPECT_NEAR(channel("Denoising Depth.Z", 12, 8), 5, 0.02);
        EXPECT_NEAR(channel("Denoising Normal.Z", 12, 8), -1, 1e-2);
        const Image counts = layerOf(all, kSampleCountLayer).value();
        if (integrator != "drc") {
            EXPECT_EQ(counts.at(12, 8, 0), 8);
        }
        // With drc on average.
        EXPECT_NEAR(std::accumulate(counts.data().begin(), counts.data().end(), 0.f) / (24 * 16), 8, 0.5);
        EXPECT_GT(channel("Denoising Variance.G", 12, 8), 0);
    }
}

TEST_F(RenderCommandTest, FilmsOfTypeGbufferHaveTheLayersOfAovs) {
    const std::string world = "WorldBegin LightSource \"infinite\" Shape \"sphere\" \"float radius\" 5";
    const std::string size = " \"integer xresolution\" 24 \"integer yresolution\" 16 ";
    const auto channels = [&](const std::string& film) {
        folder_.write("scene.pbrt", "Film \"" + film + "\"" + size + world);
        run({"--integrator", "path", "--denoise", "off"});
        return readImage(path("out.exr")).channelNames();
    };
    EXPECT_THAT(channels("gbuffer"),
                testing::IsSupersetOf({"R", "Denoising Albedo.R", "Denoising Normal.X", "Denoising Depth.Z",
                                       "Denoising Variance.R", "Debug Sample Count.X"}));
    EXPECT_THAT(channels("rgb"), testing::UnorderedElementsAre("R", "G", "B"));
}

TEST_F(RenderCommandTest, ExposureAndViewAreThePngsAlone) {
    const auto png = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"--integrator", "path", "--denoise", "off", "-o", path("out.png")});
        run(arguments);
        return readLinearRgb(path("out.png"));
    };
    const auto texts = [&] { return decodePngTexts({readFile(path("out.png")), ""}); };
    const Image plain = png({});
    const Image radiance = readLinearRgb(path("out.exr"));
    EXPECT_EQ(texts().at("drc:display_view"), "srgb");
    EXPECT_EQ(texts().at("drc:display_exposure"), "0");
    EXPECT_EQ(texts().at("drc:seed"), "3");
    EXPECT_EQ(texts().count("drc:command"), 0u);
    const Image darker = png({"--exposure", "-2", "--view", "agx"});
    EXPECT_EQ(readLinearRgb(path("out.exr")).data(), radiance.data());
    EXPECT_EQ(texts().at("drc:display_view"), "agx");
    EXPECT_EQ(readExrMetadata(path("out.exr")).at("drc:display_exposure"), "-2");
    const Image automatic = png({"--auto-exposure", "--exposure", "0.5"});
    const float stops = autoExposure(radiance) + 0.5f;
    EXPECT_NEAR(std::stof(texts().at("drc:display_exposure")), stops, 1e-3 * std::abs(stops) + 1e-6);
    for (int x = 0; x < 24; ++x) {
        const Rgb c = radiance.rgb(x, 9);
        EXPECT_NEAR(srgbEncode(plain.at(x, 9, 1)), srgbEncode(clamp01(c.y)), 0.51 / 255);
        EXPECT_NEAR(srgbEncode(darker.at(x, 9, 1)), srgbEncode(viewed(c * 0.25f, View::Agx).y), 0.51 / 255);
        EXPECT_NEAR(srgbEncode(automatic.at(x, 9, 1)), srgbEncode(clamp01(c.y * std::exp2(stops))), 0.51 / 255);
    }
}

// A grey ball under daylight of 4500 K is grey, in all layers.
TEST_F(RenderCommandTest, ThePictureIsBalancedForTheFilmsWhite) {
    const auto scene = [&](const std::string& film) {
        folder_.write("scene.pbrt", "Film \"rgb\" \"integer xresolution\" 24 \"integer yresolution\" 16 " + film + R"(
            Camera "perspective" "float fov" 70
            WorldBegin
            LightSource "infinite" "rgb L" [1.26784 0.95958 0.61150]
            Material "diffuse" "rgb reflectance" [.5 .5 .5]
            Translate 0 0 3 Shape "sphere" "float radius" 1.5)");
        run({"--integrator", "drc-maps", "--denoise", "off"});
        return readImage(path("out.exr"));
    };
    const Image plain = scene(""), balanced = scene("\"float whitebalance\" 4500");
    const auto pixel = [](const Image& image, const std::string& layer) {
        Rgb c;
        for (int i = 0; i < 3; ++i) c[i] = image.at(12, 8, image.channelIndex(layer + std::string(1, "RGB"[i])));
        return c;
    };
    EXPECT_GT(pixel(plain, "").x, 1.5f * pixel(plain, "").z);
    for (const std::string layer : {"", "direct."}) {
        const Rgb c = pixel(balanced, layer);
        EXPECT_NEAR(c.x / c.y, 1, 0.02) << layer;
        EXPECT_NEAR(c.z / c.y, 1, 0.02) << layer;
        EXPECT_NEAR(luminance(c) / luminance(pixel(plain, layer)), 1, 0.02) << layer;
    }
}

TEST_F(RenderCommandTest, DisplayOptionsWantAPng) {
    EXPECT_EQ(errorOf([&] {
                  run({"--view", "agx", "--auto-exposure"});
              }),
              "--auto-exposure, --view: EXR files stay linear and unexposed; give a .png as output");
    EXPECT_FALSE(std::filesystem::exists(path("out.exr")));
}

TEST_F(RenderCommandTest, SaysWhatItLacksOfOpenImageDenoise) {
    EXPECT_THAT(errorOf([&] {
                    run({"--denoise", "oidn", "--oidn-library", path("none.so")});
                }),
                testing::AllOf(HasSubstr("--oidn-library"), HasSubstr("none.so: there is no such file")));
    EXPECT_THAT(errorOf([&] {
                    run({"--denoise", "oidn", "--oidn-library", "libm.so.6"});
                }),
                HasSubstr("not Open Image Denoise: it has no function oidnNewDevice"));
    EXPECT_THAT(errorOf([&] {
                    run({"--integrator", "drc-maps", "--oidn-library", "libm.so.6"});
                }),
                HasSubstr("needs --denoise oidn"));
    EXPECT_THAT(errorOf([&] {
                    run({"--integrator", "path", "--denoise", "oidn-direct"});
                }),
                HasSubstr("--denoise oidn-direct: it filters the layers of --integrator drc-maps"));
    EXPECT_FALSE(std::filesystem::exists(path("out.exr")));
}

// Sets an environment variable while it lives.
class Variable {
  public:
    Variable(const char* name, const std::string& value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        setenv(name, value.c_str(), 1);
    }
    ~Variable() {
        if (before_)
            setenv(name_, before_->c_str(), 1);
        else
            unsetenv(name_);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
    std::optional<std::string> before_;
};

TEST_F(RenderCommandTest, AWrongVariableIsAnErrorWhereverTheDenoiserIsWanted) {
    const Variable wrong("DRC_OIDN", path("none.so"));
    const std::string text = "DRC_OIDN " + path("none.so") + ": there is no such file or folder";
    EXPECT_EQ(errorOf([&] { run({"--integrator", "path"}); }), text);
    EXPECT_EQ(errorOf([&] { run({"--integrator", "path", "--denoise", "oidn"}); }), text);
    EXPECT_FALSE(std::filesystem::exists(path("out.exr")));
    EXPECT_NO_THROW(run({"--integrator", "path", "--denoise", "off"}));
}

TEST_F(RenderCommandTest, DenoisesByOpenImageDenoise) {
    try {
        const OpenImageDenoise here(findOidn(OidnSearch::ofProcess("")));
    } catch (const Error& error) {
        GTEST_SKIP() << error.what();
    }
    const auto denoised = [&](const char* integrator, const char* how) {
        run({"--integrator", integrator, "--denoise", how});
        return readImage(path("out.exr"));
    };
    // Of the wall, which is smooth: how much neighbours differ.
    const auto roughness = [](const Image& image, const char* channel) {
        const int c = image.channelIndex(channel);
        double sum = 0;
        for (int y = 8; y < 16; ++y)
            for (int x = 1; x < 24; ++x) sum += std::abs(double(image.at(x, y, c)) - double(image.at(x - 1, y, c)));
        return sum;
    };
    for (const char* integrator : {"path", "bdpt", "drc", "drc-maps"})
        EXPECT_LT(roughness(denoised(integrator, "oidn"), "G"), 0.5 * roughness(denoised(integrator, "off"), "G"))
            << integrator;
    for (const char* integrator : {"path", "bdpt", "direct", "drc"})
        EXPECT_EQ(denoised(integrator, "auto").data(), denoised(integrator, "oidn").data()) << integrator;
    const Image direct = denoised("drc-maps", "oidn-direct"), off = denoised("drc-maps", "off");
    EXPECT_NE(roughness(direct, "direct.G"), roughness(off, "direct.G"));
    EXPECT_EQ(roughness(direct, "indirect.G"), roughness(off, "indirect.G"));
}

}  // namespace
}  // namespace drc
