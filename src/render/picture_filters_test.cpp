#include "render/picture_filters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/folder_testing.h"
#include "base/log.h"
#include "integrators/integrator.h"
#include "reconstruct/oidn_picture_filter.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// The name of an integrator that has map passes, or has none.
std::string integrator(bool maps) {
    for (const std::string& name : integratorNames())
        if (traitsOf(name).maps == maps) return name;
    return "";
}

RenderParams paramsOf(bool maps, Denoise resolvedTo) {
    RenderParams params;
    params.integrator = integrator(maps);
    params.denoise = resolvedTo;
    return params;
}

// A machine without the library: everything that is searched is an empty folder.
class PictureFiltersTest : public FolderTest {
  protected:
    OidnLibraries none() const {
        OidnSearch search;
        search.program = search.root = search.home = path("");
        OidnLibraries libraries = findOidn(search);
        for (std::string& name : libraries.candidates) name = "libNone" + name;
        return libraries;
    }
    // What choosing says on standard error.
    std::string said(Denoise wanted, const RenderParams& params, const OidnLibraries& libraries) {
        forgetWarnings();
        testing::internal::CaptureStderr();
        try {
            chosen_ = chooseDenoiser(wanted, params, [&] { return libraries; });
        } catch (...) {
            testing::internal::GetCapturedStderr();
            throw;
        }
        return testing::internal::GetCapturedStderr();
    }
    std::vector<std::string> names(const RenderParams& params) const {
        std::vector<std::string> found;
        for (const PictureFilters& candidate : filtersFor(params, chosen_)) found.push_back(candidate.name());
        return found;
    }
    static long lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

    ChosenDenoiser chosen_;
};

TEST_F(PictureFiltersTest, WhereNoneIsFoundAutoSaysHowToGetIt) {
    const RenderParams params = paramsOf(false, Denoise::Off);
    const std::string text = said(Denoise::Automatic, params, none());
    EXPECT_EQ(text, std::string("drc: warning: the picture will not be denoised: Open Image Denoise was not found; ") +
                        kHowToGetOidn + "\n");
    for (const char* way : {"scripts/quickstart", "pip install pyoidn", "$DRC_OIDN", "--oidn-library"})
        EXPECT_THAT(text, HasSubstr(way));
    EXPECT_EQ(chosen_.denoise, Denoise::Off);
    EXPECT_THAT(names(params), ElementsAre("nothing"));
}

TEST_F(PictureFiltersTest, WantedByNameItIsAnErrorThatThereIsNone) {
    EXPECT_THAT(errorOf([&] { said(Denoise::Oidn, paramsOf(false, Denoise::Oidn), none()); }),
                AllOf(StartsWith("Open Image Denoise was not found"), HasSubstr(kHowToGetOidn)));
}

TEST_F(PictureFiltersTest, ALibraryThatSomebodyNamesMustBeUsable) {
    EXPECT_THAT(errorOf([&] {
                    said(Denoise::Automatic, paramsOf(false, Denoise::Off), {"DRC_OIDN libm.so.6", {"libm.so.6"}});
                }),
                AllOf(StartsWith("DRC_OIDN libm.so.6: not Open Image Denoise"), Not(HasSubstr("\n"))));
}

TEST_F(PictureFiltersTest, OffSaysAndLoadsNothing) {
    const OidnLibraries wrong{"DRC_OIDN libm.so.6", {"libm.so.6"}};
    EXPECT_EQ(said(Denoise::Off, paramsOf(false, Denoise::Off), wrong), "");
    EXPECT_THAT(names(paramsOf(false, Denoise::Off)), ElementsAre("nothing"));
}

TEST_F(PictureFiltersTest, MapsHaveTheSurfaceFilter) {
    const RenderParams params = paramsOf(true, Denoise::Surface);
    EXPECT_EQ(said(Denoise::Automatic, params, {"DRC_OIDN libm.so.6", {"libm.so.6"}}),
              "drc: denoiser: surface filter\n");
    EXPECT_THAT(names(params), ElementsAre("surface", "correction of the maps", "nothing"));
}

// With the real library, where it is found.
TEST_F(PictureFiltersTest, AutoTakesTheLibraryThatIsFound) {
    const OidnLibraries here = findOidn(OidnSearch::ofProcess(""));
    try {
        const OpenImageDenoise oidn(here);
    } catch (const Error& error) {
        GTEST_SKIP() << error.what();
    }
    RenderParams params = paramsOf(false, Denoise::Off);
    const std::string text = said(Denoise::Automatic, params, here);
    EXPECT_THAT(text, AllOf(StartsWith("drc: denoiser: Open Image Denoise "), HasSubstr(chosen_.oidn->file())));
    EXPECT_EQ(lines(text), 1);
    EXPECT_EQ(chosen_.denoise, Denoise::Oidn);
    EXPECT_THAT(names(params),
                ElementsAre("oidn high", "oidn balanced without prefilter", "oidn fast without prefilter", "nothing"));
    const std::vector<PictureFilters> open = filtersFor(params, chosen_);
    EXPECT_LE(open[0].mostOfBudget, 0.1);
    EXPECT_LE(open[1].mostOfBudget, 0.4);
    EXPECT_FALSE(open[0].wanted || open[1].wanted);
    EXPECT_TRUE(open[2].wanted);
    EXPECT_GT(open[0].secondsPerPixel, open[1].secondsPerPixel);
    EXPECT_GT(open[1].secondsPerPixel, open[2].secondsPerPixel);

    params.oidnQuality = OidnQuality::Balanced;
    params.oidnPrefilter = false;
    EXPECT_THAT(names(params),
                ElementsAre("oidn balanced without prefilter", "oidn fast without prefilter", "nothing"));
    EXPECT_TRUE(filtersFor(params, chosen_)[0].wanted);
    params.oidnPrefilter = true;
    EXPECT_THAT(names(params), ElementsAre("oidn balanced", "oidn balanced without prefilter",
                                           "oidn fast without prefilter", "nothing"));
}

// Noise of albedo and normal decides whether they are filtered first, unless somebody has.
TEST_F(PictureFiltersTest, OnlyNoisyAuxiliariesAreNotTakenAsClean) {
    const OidnLibraries here = findOidn(OidnSearch::ofProcess(""));
    std::optional<OpenImageDenoise> oidn;
    try {
        oidn.emplace(here);
    } catch (const Error& error) {
        GTEST_SKIP() << error.what();
    }
    GBuffer clean, noisy;
    clean.noise = 0.002f, noisy.noise = 0.2f;
    for (const OidnAuxiliaries asked : {OidnAuxiliaries::Raw, OidnAuxiliaries::Prefiltered}) {
        const OidnSettings settings{OidnQuality::Balanced, asked};
        const OidnPictureFilter open(*oidn, settings, true, false), fixed(*oidn, settings, false, false);
        EXPECT_EQ(open.settingsFor(clean).auxiliaries, OidnAuxiliaries::Clean);
        EXPECT_EQ(open.settingsFor(noisy), settings);
        EXPECT_EQ(fixed.settingsFor(clean), settings);
    }
}

}  // namespace
}  // namespace drc
