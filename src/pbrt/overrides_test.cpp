#include "pbrt/overrides.h"

#include <gmock/gmock.h>

#include "base/log.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kScene =
    "Film \"image\" \"integer xresolution\" 100 \"integer yresolution\" 50 \"string filename\" \"a.exr\"\n"
    "Sampler \"halton\" \"integer pixelsamples\" 7\n"
    "Integrator \"path\" \"integer maxdepth\" 9\n"
    "WorldBegin WorldEnd\n";
const std::string kSceneV4 =
    "Film \"rgb\" \"integer xresolution\" 100\nSampler \"zsobol\"\nIntegrator \"sppm\"\nWorldBegin\n";

RenderSettings with(const std::vector<std::string>& overrides, const std::string& scene = kScene) {
    LoadOptions options;
    options.overrides = overrides;
    return loadPbrtString(scene, ".", options, "s.pbrt")->sensor.settings;
}
std::string errorWith(const std::string& text, const std::string& scene = kScene) {
    return errorOf([&] { with({text}, scene); });
}

TEST(Overrides, CountInPlaceOfTheFiles) {
    const RenderSettings s = with({"film.xresolution=640", "sampler.pixelsamples=33", "integrator.maxdepth=2",
                                   "film.filename=b c.exr", "film.scale=.5"});
    EXPECT_EQ(s.film.width, 640);
    EXPECT_EQ(s.film.height, 50);  // the rest stays
    EXPECT_EQ(s.samplesPerPixel, 33);
    EXPECT_EQ(s.maxDepth, 2);
    EXPECT_EQ(s.outputFile, "b c.exr");
    EXPECT_EQ(s.filmScale, 0.5f);
}

TEST(Overrides, NeedNoDirectiveWhereOnlyOneKnowsTheName) {
    const RenderSettings s = with({"xresolution=640", "pixelsamples=33", "maxdepth=2"});
    EXPECT_EQ(s.film.width, 640);
    EXPECT_EQ(s.samplesPerPixel, 33);
    EXPECT_EQ(s.maxDepth, 2);
    EXPECT_EQ(errorWith("seed=1", kSceneV4).substr(0, 71),
              "-D:1:1: sampler and integrator have a parameter 'seed': say which, as s");
    EXPECT_EQ(errorWith("integrator.seed=1", kSceneV4), "");
}

TEST(Overrides, CountForDirectivesThatTheFileLeavesOut) {
    const RenderSettings s = with({"film.xresolution=64", "pixelsamples=3"}, "WorldBegin WorldEnd");
    EXPECT_EQ(s.film.width, 64);
    EXPECT_EQ(s.samplesPerPixel, 3);
}

TEST(Overrides, TakeSeveralValuesAndTheLastOfTwo) {
    const RenderSettings s = with({"film.cropwindow=0,1,0,1", "film.cropwindow=.5, 1 0 .25"});
    EXPECT_THAT(s.cropWindow, testing::ElementsAre(.5f, 1, 0, .25f));
    EXPECT_EQ(with({"integrator.pixelbounds=10 70 20 30"}).region().width(), 60);
    EXPECT_EQ(with({"film.pixelbounds=10,70,20,30"}, kSceneV4).region().width(), 60);
}

TEST(Overrides, ReplaceAValueThatIsWrong) {
    const std::string wrong = "Film \"image\" \"integer xresolution\" 0 \"float diagonal\" -1\nWorldBegin WorldEnd";
    EXPECT_THAT(errorWith("film.scale=1", wrong), HasSubstr("s.pbrt:1:14"));
    EXPECT_EQ(with({"xresolution=8", "diagonal=3"}, wrong).film.width, 8);
}

TEST(Overrides, WarnOfNothing) {
    forgetWarnings();
    with({"film.xresolution=640", "sampler.samplepixelcenter=whatever", "integrator.lightsamplestrategy=power"});
    EXPECT_EQ(warningCount(), 0);
}

TEST(Overrides, HaveTheErrorsOfAFileAtTheirOwnText) {
    EXPECT_THAT(errorWith("film.xresolution=0"),
                AllOf(HasSubstr("-D:1:6: parameter 'xresolution' of film 'image' must be from 1 to "),
                      HasSubstr("film.xresolution=0")));
    EXPECT_THAT(errorWith("xresolution=6.5"), HasSubstr("-D:1:13: parameter 'xresolution' of film 'image' is a whole "
                                                        "number from -2^31 to 2^31 - 1, not '6.5'"));
    EXPECT_THAT(errorWith("xresolution=3000000000"), HasSubstr("is a whole number from -2^31"));
    EXPECT_THAT(errorWith("film.scale=half"), HasSubstr("is a number, not 'half'"));
    EXPECT_THAT(errorWith("film.cropwindow=0 nan 0 1"), HasSubstr("is a number, not 'nan'"));
    EXPECT_THAT(errorWith("film.cropwindow=.5 .5 0 1"), HasSubstr("parameter 'cropwindow' of film 'image' is empty"));
    EXPECT_THAT(errorWith("film.scale="), HasSubstr("must have one value of type 'float', not 0"));
    EXPECT_EQ(errorWith("film.filename="), "") << "an empty name is none";
    EXPECT_THAT(errorWith("integrator.regularize=yes", "Film \"rgb\" Integrator \"path\" WorldBegin"),
                HasSubstr("is true or false, not 'yes'"));
}

TEST(Overrides, UnknownNamesGetALineOfWhatThereIs) {
    EXPECT_THAT(
        errorWith("film.xresolutoin=640"),
        HasSubstr("-D:1:6: film 'image' has no parameter 'xresolutoin'; did you mean 'xresolution'?; it has "
                  "cropwindow, diagonal, filename, maxsampleluminance, scale, transparent, xresolution, yresolution"));
    EXPECT_THAT(errorWith("sampler.xsamples=4"), HasSubstr("sampler 'halton' has no parameter 'xsamples'"));
    EXPECT_THAT(errorWith("fov=40"),
                AllOf(HasSubstr("-D:1:1: no parameter is called 'fov'; film 'image' has cropwindow"),
                      HasSubstr("; sampler 'halton' has "), HasSubstr("pixelsamples"),
                      HasSubstr("; integrator 'path' has "), HasSubstr("maxdepth")));
    EXPECT_THAT(errorWith("camera.fov=40"),
                HasSubstr("-D:1:1: there are parameters of film, sampler, integrator, not of 'camera'"));
    for (const char* text : {"xresolution", "", "=640"})
        EXPECT_THAT(errorWith(text), HasSubstr("-D:1:1: a parameter is given as NAME=VALUE"));
}

// Of such an integrator nothing is known: the file, too, may give it anything.
TEST(Overrides, IntegratorsOfOthersTakeAnything) {
    const std::string scene = "Integrator \"iispt\" \"integer tasks\" 4\nWorldBegin WorldEnd";
    EXPECT_EQ(errorWith("integrator.tasks=8", scene), "");
    EXPECT_THAT(errorWith("tasks=8", scene), HasSubstr("no parameter is called 'tasks'"));
}

}  // namespace
}  // namespace drc::pbrt
