#include "reconstruct/open_image_denoise.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <thread>

#include "base/folder_testing.h"
#include "base/log.h"
#include "math/rng.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr OidnAuxiliaries kRaw = OidnAuxiliaries::Raw, kClean = OidnAuxiliaries::Clean,
                          kPrefiltered = OidnAuxiliaries::Prefiltered;

// A fake library with the C interface of version 1 or 2 and a given version number: its filter writes the parameters
// that it was given. On a picture that begins with -1 it works until it is cancelled.
class FakeLibrary : public FolderTest {
  protected:
    std::string library(int version, bool oldNames) const {
        const std::string source =
            folder_.write("fake.c", fmt::format(R"(
#include <stddef.h>
#include <string.h>
#include <unistd.h>
static _Bool (*monitor)(void*, double); static void* user; static int error;
static float told[3];   /* of the colour filter: quality, cleanAux, filters before it */
static int quality, clean, filters;
static const float* color; static float* output; static size_t count;
void* oidnNewDevice(int type) {{ return &quality; }}
void oidnCommitDevice(void* d) {{}}
int oidnGetDeviceError(void* d, const char** m) {{ int e = error; error = 0; return e; }}
void oidnReleaseDevice(void* d) {{}}
void {0}(void* d, const char* n, int v) {{}}
int {1}(void* d, const char* n) {{ return {4}; }}
void* oidnNewFilter(void* d, const char* t) {{ quality = clean = 0; color = 0; monitor = 0; return &filters; }}
void oidnSetSharedFilterImage(void* f, const char* n, void* p, int t, size_t w, size_t h, size_t o, size_t a, size_t b)
{{ if (!strcmp(n, "color")) color = p; if (!strcmp(n, "output")) output = p; count = 3 * w * h; }}
void {2}(void* f, const char* n, _Bool v) {{ if (!strcmp(n, "cleanAux")) clean = v; }}
void {3}(void* f, const char* n, int v) {{ if (!strcmp(n, "quality")) quality = v; }}
void oidnCommitFilter(void* f) {{}}
void oidnSetFilterProgressMonitorFunction(void* f, _Bool (*m)(void*, double), void* u) {{ monitor = m; user = u; }}
void oidnExecuteFilter(void* f) {{
    if (color && color[0] == -1) {{
        while (monitor(user, 0.5)) usleep(100);
        error = 6;  /* OIDN_ERROR_CANCELLED */
        return;
    }}
    output[0] = quality; output[1] = clean; output[2] = filters++;
    for (size_t i = 3; i < count; ++i) output[i] = 0;
}}
void oidnReleaseFilter(void* f) {{}}
)",
                                                oldNames ? "oidnSetDevice1i" : "oidnSetDeviceInt",
                                                oldNames ? "oidnGetDevice1i" : "oidnGetDeviceInt",
                                                oldNames ? "oidnSetFilter1b" : "oidnSetFilterBool",
                                                oldNames ? "oidnSetFilter1i" : "oidnSetFilterInt", version));
        const std::string file = path(fmt::format("lib{}.so", version));
        const std::string command = fmt::format("cc -shared -fPIC -o {} {}", file, source);
        return std::system(command.c_str()) == 0 ? file : "";
    }
    struct Told {
        float quality, clean, filtersBefore;
    };
    Told told(int version, const OidnSettings& settings, bool oldNames = false) const {
        const std::string file = library(version, oldNames);
        const OpenImageDenoise oidn(OidnLibraries{"", {path("none.so"), file}});
        EXPECT_EQ(oidn.version(), version);
        EXPECT_EQ(oidn.file(), file);
        Image color(4, 4);
        const Image guide(4, 4);
        oidn.denoise(color, guide, guide, settings);
        const Rgb first = color.rgb(0, 0);
        return {first.x, first.y, first.z};
    }
};

TEST_F(FakeLibrary, IsToldQualityAndWhetherAuxiliariesAreClean) {
    if (library(20500, false).empty()) GTEST_SKIP() << "no C compiler is called cc";
    Told t = told(20500, {});
    EXPECT_EQ(t.quality, 0);  // its default is the best
    EXPECT_EQ(t.clean, 1);
    EXPECT_EQ(t.filtersBefore, 2);
    t = told(20501, {OidnQuality::Balanced, kRaw});
    EXPECT_EQ(t.quality, 5);
    EXPECT_EQ(t.clean, 0);
    EXPECT_EQ(t.filtersBefore, 0);
    EXPECT_EQ(told(20502, {OidnQuality::Fast, kRaw}).quality, 4);
    t = told(20503, {OidnQuality::High, kClean});
    EXPECT_EQ(t.clean, 1);
    EXPECT_EQ(t.filtersBefore, 0);
}

TEST_F(FakeLibrary, EndsWhenItIsCancelled) {
    const std::string file = library(20500, false);
    if (file.empty()) GTEST_SKIP() << "no C compiler is called cc";
    const OpenImageDenoise oidn(OidnLibraries{"", {file}});
    Image color(4, 4);
    color.data()[0] = -1;
    const Image guide(4, 4);
    CancelToken token;
    std::thread later([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        token.cancel();
    });
    EXPECT_NO_THROW(oidn.denoise(color, guide, guide, {OidnQuality::Fast, kRaw}, &token));
    later.join();
    // The next picture is another matter.
    token.reset();
    color.data()[0] = 0;
    oidn.denoise(color, guide, guide, {OidnQuality::Fast, kRaw}, &token);
    EXPECT_EQ(color.data()[0], 4);
}

TEST_F(FakeLibrary, OlderOnesDoWhatTheyCanAndAWarningSaysSo) {
    if (library(20500, false).empty()) GTEST_SKIP() << "no C compiler is called cc";
    const auto warning = [&](int version, const OidnSettings& settings, bool oldNames, float quality) {
        forgetWarnings();
        testing::internal::CaptureStderr();
        EXPECT_EQ(told(version, settings, oldNames).quality, quality) << version;
        return testing::internal::GetCapturedStderr();
    };
    EXPECT_THAT(warning(20200, {OidnQuality::Fast, kRaw}, false, 5),
                AllOf(HasSubstr("Open Image Denoise 2.2 has no quality 'fast'"), HasSubstr("'balanced' instead")));
    EXPECT_THAT(warning(10403, {OidnQuality::Fast, kRaw}, true, 0), HasSubstr("'high' instead"));
    EXPECT_THAT(warning(10404, {OidnQuality::Balanced, kPrefiltered}, true, 0),
                HasSubstr("1.4 has no quality 'balanced'"));
    EXPECT_EQ(warning(10405, {}, true, 0), "");
    EXPECT_EQ(warning(20000, {OidnQuality::Balanced, kPrefiltered}, false, 5), "");
}

TEST(OpenImageDenoise, SaysWhyThereIsNone) {
    const auto error = [](const OidnLibraries& libraries) {
        return errorOf([&] { const OpenImageDenoise oidn(libraries); });
    };
    EXPECT_EQ(error({"", {"libNone.so.2", "libNone.so"}}),
              std::string("Open Image Denoise was not found; ") + kHowToGetOidn);
    EXPECT_THAT(error({"", {"libNone.so.2", "/nowhere/libNone.so"}}),
                AllOf(HasSubstr("is of no use here (/nowhere/libNone.so: cannot be loaded"), HasSubstr(kHowToGetOidn)));
    EXPECT_THAT(error({"DRC_OIDN libm.so.6", {"libm.so.6"}}),
                AllOf(HasSubstr("DRC_OIDN libm.so.6: not Open Image Denoise"), Not(HasSubstr(kHowToGetOidn))));
}

// The real library, where it is found.
class OpenImageDenoiseTest : public testing::Test {
  protected:
    void SetUp() override {
        try {
            oidn_.emplace(findOidn(OidnSearch::ofProcess("")));
        } catch (const Error& error) {
            GTEST_SKIP() << error.what();
        }
        // Two noisy grey walls, with an edge that albedo and normal show.
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const float noise = uniformFloat(hash32(x, y)) - 0.5f;
                color_.setRgb(x, y, Rgb(truth(x) * (1 + noise)));
                albedo_.setRgb(x, y, Rgb(truth(x)));
                normal_.setRgb(x, y, x < kSide / 2 ? Rgb(0, 0, 1) : Rgb(1, 0, 0));
            }
    }
    static float truth(int x) { return x < kSide / 2 ? 0.3f : 0.6f; }
    static double deviation(const Image& image) {
        double sum = 0;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const double d = image.at(x, y, 1) - truth(x);
                sum += d * d;
            }
        return std::sqrt(sum) / kSide;
    }

    static constexpr int kSide = 64;
    std::optional<OpenImageDenoise> oidn_;
    Image color_{kSide, kSide}, albedo_{kSide, kSide}, normal_{kSide, kSide};
};

// The one that scripts/fetch-oidn has put beside the tests can be loaded where it lies.
TEST_F(OpenImageDenoiseTest, TheFetchedOneIsTaken) {
    const std::string folder = (OidnSearch::ofProcess("").program / "oidn").string();
    if (std::getenv("DRC_OIDN") || !std::filesystem::exists(folder)) GTEST_SKIP() << "there is none in " << folder;
    EXPECT_THAT(oidn_->file(), testing::StartsWith(folder));
}

TEST_F(OpenImageDenoiseTest, EveryModeRemovesNoiseInItsOwnWay) {
    std::vector<Image> pictures;
    for (const OidnAuxiliaries auxiliaries : {kRaw, kClean, kPrefiltered})
        for (const OidnQuality quality : {OidnQuality::High, OidnQuality::Balanced, OidnQuality::Fast}) {
            pictures.push_back(color_);
            oidn_->denoise(pictures.back(), albedo_, normal_, {quality, auxiliaries});
        }
    for (size_t i = 0; i < pictures.size(); ++i) {
        EXPECT_LT(deviation(pictures[i]), 0.35 * deviation(color_)) << i << " of " << deviation(color_);
        if (oidn_->version() < 20300) continue;
        for (size_t j = 0; j < i; ++j) {
            if (i == 1 && j == 0) continue;  // by raw auxiliaries, high and balanced are the same filter on a CPU
            EXPECT_NE(pictures[i].data(), pictures[j].data()) << i << " " << j;
        }
    }
    Image standard = color_;
    oidn_->denoise(standard, albedo_, normal_);
    EXPECT_EQ(standard.data(), pictures[6].data());
}

}  // namespace
}  // namespace drc
