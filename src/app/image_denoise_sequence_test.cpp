// `drc image denoise --frames` and `drc compare --sequence`.
#include <fmt/core.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/compare_command.h"
#include "app/image_command_testing.h"
#include "image/image_layers.h"
#include "image/metrics.h"
#include "reconstruct/open_image_denoise.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class DenoiseSequence : public ImageCommandFolder {
  protected:
    // Renders frames 1 to `count` of a camera that moves along a room, as name_#.exr.
    void render(const std::string& name, int count, int seed, const std::string& spp,
                const std::vector<std::string>& more = {"--aovs"}) const {
        for (int i = 1; i <= count; ++i) {
            folder_.write(fmt::format("f_{}.pbrt", i), fmt::format(R"(
Translate {} 0 0
LookAt 0 1 -3  0 1 0  0 1 0
Camera "perspective" "float fov" 60
Film "image" "integer xresolution" 120 "integer yresolution" 80
WorldBegin
AttributeBegin
AreaLightSource "diffuse" "rgb L" [6 6 6]
Translate 0 2.4 0
Shape "sphere" "float radius" .4
AttributeEnd
Material "matte" "rgb Kd" [.7 .5 .4]
Shape "trianglemesh" "point P" [-3 0 -4  3 0 -4  3 0 3  -3 0 3  -3 3 -4  3 3 -4  3 3 3  -3 3 3]
  "integer indices" [0 1 2 0 2 3  4 6 5 4 7 6  0 3 7 0 7 4  1 5 6 1 6 2  3 2 6 3 6 7  0 5 1 0 4 5]
Translate .5 .5 .5
Shape "sphere" "float radius" .5
WorldEnd
)",
                                                                   -.05 * i));
            std::vector<std::string> arguments = {"render",       path(fmt::format("f_{}.pbrt", i)),
                                                  "-o",           path(fmt::format("{}_{}.exr", name, i)),
                                                  "--seed",       std::to_string(seed),
                                                  "--spp",        spp,
                                                  "--integrator", "path",
                                                  "--denoise",    "off",
                                                  "--quiet"};
            arguments.insert(arguments.end(), more.begin(), more.end());
            test::outputOf(addRenderCommand, arguments);
        }
        setLogLevel(LogLevel::Quiet);
    }
    std::vector<std::string> denoising(const std::string& frames, std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments = {"denoise", path("t_#.exr"), "--frames", frames, "-o", path("d_#.exr")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
    static bool canDenoise(std::string& why) {
        try {
            const OpenImageDenoise here(findOidn(OidnSearch::ofProcess("")));
            return true;
        } catch (const Error& error) {
            why = error.what();
            return false;
        }
    }
    nlohmann::json compared(const std::string& test) const {
        return nlohmann::json::parse(test::outputOf(addCompareCommand, {"compare", "--sequence", "1-4", path("a_#.exr"),
                                                                        path("b_#.exr"), path(test), "--json"}));
    }
};

TEST_F(DenoiseSequence, AWindowFlickersLessThanFramesByThemselves) {
    if (std::string why; !canDenoise(why)) GTEST_SKIP() << why;
    render("a", 4, 91, "96");
    render("b", 4, 92, "96");
    render("t", 4, 1, "8");
    run(denoising("1-4"));
    run({"denoise", path("t_#.exr"), "--frames", "1-4", "--window", "0", "-o", path("s_#.exr")});
    const nlohmann::json noisy = compared("t_#.exr"), single = compared("s_#.exr"), window = compared("d_#.exr");
    EXPECT_LT(window["flicker"], .6 * single["flicker"].get<double>()) << window << single;
    EXPECT_LT(window["error"], .9 * single["error"].get<double>()) << window << single;
    EXPECT_LT(single["flicker"], .3 * noisy["flicker"].get<double>());
    EXPECT_GT(window["compared"], .8);
    // A window of nothing is the denoiser alone.
    run({"denoise", path("t_2.exr"), "-o", path("alone.exr")});
    EXPECT_LT(drc::compare(readImage(path("alone.exr")).toRgb(), readImage(path("s_2.exr")).toRgb()).mse, 1e-6);
    const PictureFile file = readPictureFile(path("d_2.exr"));
    EXPECT_THAT(file.metadata.at("drc:denoiser"), HasSubstr("2 frames before and after"));
    EXPECT_TRUE(layerOf(file.image, kPositionLayer));
}

TEST_F(DenoiseSequence, MissingAndUnfitFramesAreOneLine) {
    render("t", 2, 1, "1");
    EXPECT_THAT(complaint(denoising("1-3"), "d_1.exr"), AllOf(HasSubstr("--frames 1-3"), HasSubstr("t_3.exr")));
    EXPECT_THAT(complaint({"denoise", path("t_1.exr"), "--frames", "1-2", "-o", path("d_#.exr")}),
                HasSubstr("run of #"));
    EXPECT_THAT(complaint({"denoise", path("t_#.exr"), "--frames", "1-2", "-o", path("d.exr")}, "d.exr"),
                HasSubstr("run of #"));
    EXPECT_THAT(complaint(denoising("2-1")), HasSubstr("--frames 2-1"));
    EXPECT_THAT(complaint({"denoise", path("t_#.exr"), "--frames", "1-2", "-o", path("t_#.exr")}),
                HasSubstr("t_1.exr"));
    EXPECT_THAT(complaint({"denoise", path("t_1.exr"), "--window", "1", "-o", path("d.exr")}), HasSubstr("--frames"));
    if (std::string why; !canDenoise(why)) GTEST_SKIP() << why;
    render("t", 2, 1, "1", {});
    EXPECT_THAT(complaint(denoising("1-2"), "d_1.exr"), AllOf(HasSubstr("t_1.exr"), HasSubstr("--aovs")));
    render("t", 1, 1, "1");
    std::filesystem::rename(path("t_1.exr"), path("t_2.exr"));
    render("t", 1, 1, "1", {"--aovs", "--resolution", "60x40"});
    EXPECT_THAT(complaint(denoising("1-2"), "d_1.exr"), AllOf(HasSubstr("t_1.exr"), HasSubstr("t_2.exr")));
}

TEST_F(DenoiseSequence, ComparisonsNeedWholeAnimations) {
    render("a", 2, 1, "1");
    const auto complaintOf = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "compare");
        return errorOf([&] { test::outputOf(addCompareCommand, arguments); });
    };
    const std::string a = path("a_#.exr");
    EXPECT_THAT(complaintOf({"--sequence", "1-3", a, a, a}), HasSubstr("a_3.exr"));
    EXPECT_THAT(complaintOf({"--sequence", "1", a, a, a}), HasSubstr("two frames"));
    EXPECT_THAT(complaintOf({"--sequence", "1-2", a, a}), HasSubstr("REF1 REF2 TEST"));
    EXPECT_THAT(complaintOf({"--sequence", "1-2", a, a, path("b_#.exr")}), HasSubstr("b_1.exr"));
}

}  // namespace
}  // namespace drc
