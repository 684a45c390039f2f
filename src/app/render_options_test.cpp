#include "app/render_options.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

RenderOptions parsed(std::vector<std::string> arguments) {
    CLI::App app;
    RenderOptions options;
    addRenderOptions(app, options);
    arguments.insert(arguments.begin(), "scene.pbrt");
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants a vector
    app.parse(std::move(arguments));
    return options;
}

std::string complaint(std::vector<std::string> arguments) {
    try {
        parsed(std::move(arguments));
    } catch (const CLI::ParseError& error) {
        return error.what();
    }
    return "";
}

TEST(RenderOptions, BindToTheParameters) {
    const RenderOptions o =
        parsed({"--integrator", "path", "--spp", "7", "--time", "2.5", "--denoise", "oidn", "--oidn-quality", "fast",
                "--oidn-prefilter", "off", "--quality", "high", "--clamp", "3", "--uncorrected", "--seed", "9"});
    EXPECT_EQ(o.params.integrator, "path");
    EXPECT_EQ(o.params.spp, 7);
    EXPECT_EQ(o.params.seconds, 2.5);
    EXPECT_EQ(o.params.denoise, Denoise::Oidn);
    EXPECT_EQ(o.params.oidnQuality, OidnQuality::Fast);
    EXPECT_EQ(o.params.oidnPrefilter, false);
    EXPECT_EQ(o.params.quality, Quality::High);
    EXPECT_EQ(o.params.clamp, 3);
    EXPECT_FALSE(o.params.correct);
    EXPECT_EQ(o.params.seed, 9u);
}

TEST(RenderOptions, LeaveTheDenoiserOpen) {
    for (const auto& arguments :
         {std::vector<std::string>{}, {"--denoise", "auto", "--oidn-quality", "auto", "--oidn-prefilter", "auto"}}) {
        const RenderOptions o = parsed(arguments);
        EXPECT_EQ(o.params.denoise, Denoise::Automatic);
        EXPECT_FALSE(o.params.oidnQuality);
        EXPECT_FALSE(o.params.oidnPrefilter);
    }
}

TEST(RenderOptions, DisplayIsSrgbWithoutExposureUnlessTheySayOtherwise) {
    EXPECT_EQ(parsed({}).display, DisplaySettings{});
    EXPECT_EQ(parsed({"--exposure", "-1.5", "--auto-exposure", "--view", "agx"}).display,
              (DisplaySettings{-1.5f, true, View::Agx}));
    EXPECT_EQ(parsed({"--view", "filmic"}).display.view, View::Filmic);
    EXPECT_THAT(complaint({"--view", "raw"}), AllOf(HasSubstr("raw"), HasSubstr("srgb,filmic,agx")));
    for (const char* bad : {"nan", "101", "x"}) EXPECT_THAT(complaint({"--exposure", bad}), HasSubstr("--exposure"));
}

TEST(RenderOptions, RefuseAddressesThatAreNone) {
    EXPECT_EQ(parsed({"--display-server", "[::1]:14158"}).displayServer, "[::1]:14158");
    for (const char* wrong : {"localhost", "localhost:", ":14158", "localhost:0", "localhost:65536", "host:1x"}) {
        const std::string text = complaint({"--display-server", wrong});
        EXPECT_THAT(text, AllOf(HasSubstr("--display-server"), HasSubstr(wrong), HasSubstr("localhost:14158")));
        EXPECT_THAT(text, Not(HasSubstr("\n")));
    }
    EXPECT_THAT(complaint({"--display-server"}), HasSubstr("--display-server"));
}

// As pbrt spells them.
TEST(RenderOptions, TakePbrtsSpellings) {
    const RenderOptions o = parsed({"--outfile", "a.exr", "--cropwindow", "0", ".5", ".25", "1", "--quick", "-D",
                                    "film.xresolution=64", "-D", "pixelsamples=8"});
    EXPECT_EQ(o.outputs, std::vector<std::string>{"a.exr"});
    EXPECT_EQ(o.overrides.crop, (std::vector<double>{0, 0.5, 0.25, 1}));
    EXPECT_EQ(o.params.quality, Quality::Draft);
    EXPECT_EQ(o.overrides.parameters, (std::vector<std::string>{"film.xresolution=64", "pixelsamples=8"}));
}

// One short line that says what would be right, without the largest number that a machine knows.
TEST(RenderOptions, RefuseNumbersThatMeanNothing) {
    for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{{"--nthreads", "-1"},
                                                                                        {"--spp", "0"},
                                                                                        {"--spp", "1.5"},
                                                                                        {"--time", "0"},
                                                                                        {"--time", "-3"},
                                                                                        {"--time", "nan"},
                                                                                        {"--time", "inf"},
                                                                                        {"--clamp", "nan"},
                                                                                        {"--clamp", "-1"},
                                                                                        {"--max-depth", "0"},
                                                                                        {"--passes", "-1"},
                                                                                        {"--oracle-spp", "x"},
                                                                                        {"--spp", "99999999999"},
                                                                                        {"--gather-samples", "0"}}) {
        const std::string text = complaint({option + "=" + value});
        EXPECT_THAT(text, AllOf(HasSubstr(option), HasSubstr(value))) << option << " " << value;
        EXPECT_LT(text.size(), 100u) << text;
        EXPECT_THAT(text, Not(HasSubstr("\n")));
    }
    EXPECT_EQ(complaint({"--nthreads", "0", "--clamp", "0", "--passes", "0", "--time", "0.5"}), "");
}

}  // namespace
}  // namespace drc
