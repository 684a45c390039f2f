// Film, sampler, filter and integrator in scene files.
#include "pbrt/render_settings.h"

#include <gmock/gmock.h>

#include "base/log.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;

RenderSettings settingsOf(const std::string& options) {
    return loadPbrtString(options + "\nWorldBegin\nWorldEnd\n", ".", {}, "s.pbrt")->sensor.settings;
}
std::string errorOfOptions(const std::string& options) { return errorOfScene(options + "\nWorldBegin\nWorldEnd\n"); }

TEST(RenderSettings, SamplersHavePbrtsCounts) {
    const auto samples = [](const std::string& sampler) {
        forgetWarnings();
        const int n = settingsOf("Sampler " + sampler).samplesPerPixel;
        EXPECT_EQ(warningCount(), 0) << sampler;
        return n;
    };
    EXPECT_EQ(samples("\"random\""), 4);
    EXPECT_EQ(samples("\"halton\" \"bool samplepixelcenter\" \"true\""), 16);
    EXPECT_EQ(samples("\"stratified\" \"bool jitter\" \"false\" \"integer dimensions\" 4"), 16);
    EXPECT_EQ(samples("\"stratified\" \"integer xsamples\" 2"), 8);
    for (const char* type : {"sobol", "02sequence", "lowdiscrepancy", "maxmindist"}) {
        EXPECT_EQ(samples(std::string("\"") + type + "\""), 16);
        EXPECT_EQ(samples(std::string("\"") + type + "\" \"integer pixelsamples\" 33"), 64) << type;
    }
    EXPECT_EQ(samples("\"halton\" \"integer pixelsamples\" 33"), 33);
    EXPECT_THAT(errorOfOptions("Sampler \"sobol\" \"integer pixelsamples\" 0"), HasSubstr("s.pbrt:1:17"));
}

TEST(RenderSettings, FiltersHavePbrtsDefaults) {
    const auto filter = [](const std::string& text) { return settingsOf("PixelFilter " + text).filter; };
    EXPECT_EQ(filter("\"box\"")->radius(), Vec2(0.5f, 0.5f));
    EXPECT_EQ(filter("\"triangle\"")->radius(), Vec2(2, 2));
    EXPECT_EQ(filter("\"sinc\"")->radius(), Vec2(4, 4));
    const float edge = std::exp(-8.f);  // alpha 2 at radius 2
    const auto gaussian = filter("\"gaussian\"");
    EXPECT_NEAR(gaussian->eval(Vec2(1, 0)) / gaussian->eval(Vec2(0, 0)), (std::exp(-2.f) - edge) / (1 - edge), 1e-6);
    // B = C = 1/3: 16/18 at the centre, 1/18 halfway to the edge.
    const auto mitchell = filter("\"mitchell\"");
    EXPECT_NEAR(mitchell->eval(Vec2(1, 0)) / mitchell->eval(Vec2(0, 0)), 1 / 16.f, 1e-5);
    EXPECT_NE(filter("\"mitchell\" \"float B\" 0 \"float C\" .5")->eval(Vec2(1, 0)), mitchell->eval(Vec2(1, 0)));
    EXPECT_NE(filter("\"gaussian\" \"float alpha\" 1")->eval(Vec2(1, 0)), gaussian->eval(Vec2(1, 0)));
    EXPECT_NE(filter("\"sinc\" \"float tau\" 2")->eval(Vec2(1.5f, 0)), filter("\"sinc\"")->eval(Vec2(1.5f, 0)));
}

TEST(RenderSettings, Film) {
    EXPECT_EQ(settingsOf("Film \"image\"").film.diagonal, 35);
    EXPECT_EQ(settingsOf("Film \"image\" \"float diagonal\" 10").film.diagonal, 10);
    EXPECT_THAT(errorOfOptions("Film \"image\" \"float diagonal\" 0"), HasSubstr("must be positive"));
    EXPECT_THAT(errorOfOptions("Film \"image\" \"float scale\" -1"), HasSubstr("must not be negative"));
    EXPECT_THAT(errorOfOptions("Film \"image\" \"float maxsampleluminance\" 0"), HasSubstr("must be positive"));
    // Only the resolution is overridden.
    const auto scene =
        loadPbrtString("Film \"image\" \"float diagonal\" 10 WorldBegin WorldEnd", ".", {FilmGeometry{40, 30}});
    EXPECT_EQ(scene->sensor.settings.film.diagonal, 10);
    EXPECT_EQ(scene->sensor.settings.film.width, 40);
}

TEST(RenderSettings, CropWindowsArePbrts) {
    const auto window = [](const std::string& values) {
        return settingsOf("Film \"image\" \"float cropwindow\" [" + values + "]");
    };
    EXPECT_THAT(window("1 0 0 1").cropWindow, testing::ElementsAre(0, 1, 0, 1));
    EXPECT_THAT(window("-3 .5 .5 2").cropWindow, testing::ElementsAre(0, .5f, .5f, 1));
    const auto error = [](const std::string& values) {
        return errorOfOptions("Film \"image\" \"float cropwindow\" [" + values + "]");
    };
    EXPECT_THAT(error(".5 .5 0 1"),
                HasSubstr("s.pbrt:1:14: parameter 'cropwindow' of film 'image' is empty from x0 = 0.5 "
                          "to x1 = 0.5"));
    EXPECT_THAT(error("2 3 0 1"), HasSubstr("is empty from x0 = 2"));
    EXPECT_THAT(error("0 1 0"), HasSubstr("must be four numbers, x0 x1 y0 y1, not 3"));
}

TEST(RenderSettings, TheFilmsFileNameKeepsItsPlace) {
    const RenderSettings s = settingsOf("Film \"image\"\n  \"string filename\" [\"dir/\"]");
    EXPECT_EQ(s.outputFile, "dir/");
    EXPECT_EQ(s.outputFileAt.str(), "s.pbrt:2:3");
    EXPECT_TRUE(settingsOf("Film \"image\"").outputFileAt.empty());
}

TEST(RenderSettings, PixelBoundsNarrowTheCropWindow) {
    const std::string film =
        "Film \"image\" \"integer xresolution\" 100 \"integer yresolution\" 50 "
        "\"float cropwindow\" [.5 1 0 1]\n";
    const PixelRegion r = settingsOf(film + "Integrator \"path\" \"integer pixelbounds\" [10 70 20 30]").region();
    EXPECT_EQ(r.x0, 50);
    EXPECT_EQ(r.x1, 70);
    EXPECT_EQ(r.y0, 20);
    EXPECT_EQ(r.y1, 30);
    EXPECT_EQ(settingsOf(film).region().width(), 50);
    EXPECT_THAT(errorOfOptions("Integrator \"path\" \"integer pixelbounds\" [10 5 20 30]"), HasSubstr("is empty"));
    const PixelRegion all = settingsOf(film +
                                       "Integrator \"path\" \"integer pixelbounds\" "
                                       "[-2147483647 2147483647 -2147483647 2147483647]")
                                .region();
    EXPECT_EQ(all.width(), 50);
    EXPECT_EQ(all.height(), 50);
}

TEST(RenderSettings, IntegratorParametersAreKnownOrNamed) {
    const auto warnings = [](const std::string& text) {
        forgetWarnings();
        settingsOf("Integrator " + text);
        return warningCount();
    };
    EXPECT_EQ(
        warnings("\"path\" \"integer maxdepth\" 7 \"float rrthreshold\" .5 \"string lightsamplestrategy\" \"power\""),
        0);
    EXPECT_EQ(warnings("\"mlt\" \"integer chains\" 10 \"float sigma\" .01"), 0);
    EXPECT_EQ(warnings("\"path\" \"integer maxdeph\" 7"), 1);
    EXPECT_EQ(warnings("\"iispt\" \"integer whatever\" 7"), 0);
    EXPECT_THAT(errorOfOptions("Integrator \"path\" \"string lightsamplestrategy\" \"best\""),
                HasSubstr("s.pbrt:1:48: unknown lightsamplestrategy 'best'"));
}

}  // namespace
}  // namespace drc::pbrt
