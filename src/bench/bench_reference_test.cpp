#include "bench/bench_reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/folder_testing.h"
#include "base/log.h"
#include "image/image_io.h"

namespace drc {
namespace {

using testing::HasSubstr;

// The renderer is a script: of an even seed it makes even.exr, of an odd one odd.exr.
class BenchReference : public FolderTest {
  protected:
    BenchReference() {
        settings_.program =
            folder_.write("drc",
                          "#!/bin/sh\n"
                          "here=$(dirname \"$0\")\n"
                          "while [ $# -gt 0 ]; do case $1 in\n"
                          "  --seed) seed=$2;; --spp) spp=$2;; -o) out=$2;; esac; shift; done\n"
                          "echo $spp $seed >>$here/log\n"
                          "if [ $((seed % 2)) = 0 ]; then cp $here/even.exr $out; else cp $here/odd.exr $out; fi\n");
        std::filesystem::permissions(settings_.program, std::filesystem::perms::owner_all);
        settings_.threads = 1;
        pictures(1, 1);
    }
    void pictures(float even, float odd) {
        for (const auto& [name, value] : {std::pair("even.exr", even), std::pair("odd.exr", odd)}) {
            Image image(12, 12);
            std::fill(image.data().begin(), image.data().end(), value);
            writeExr(path(name), image);
        }
    }
    Reference render(const std::string& key = "key", const CancelToken* cancel = nullptr) {
        return renderReference("room.pbrt", "room", 12, 12, path("references"), key, settings_, cancel);
    }
    int calls() {
        std::ifstream in(path("log"));
        int count = 0;
        for (std::string line; std::getline(in, line);) ++count;
        std::filesystem::remove(path("log"));
        return count;
    }
    ReferenceSettings settings_;
};

TEST_F(BenchReference, EndsWhenBothHalvesAgree) {
    const Reference reference = render();
    EXPECT_EQ(calls(), 2);
    EXPECT_EQ(readLinearRgb(reference.path).at(3, 3, 0), 1);
    EXPECT_THAT(reference.origin, HasSubstr("path, 128 spp"));
}

TEST_F(BenchReference, IsTheMeanOfAllSamplesAndAQuarterOfTheHalvesError) {
    pictures(1, 1.2f);  // never agree
    settings_.maxSpp = 1000;
    settings_.error = 1e-5;
    const Reference reference = render();
    EXPECT_EQ(calls(), 6);  // pairs of 64, 128 and 256 spp
    EXPECT_THAT(reference.origin, HasSubstr("896 spp"));
    EXPECT_NEAR(readLinearRgb(reference.path).at(3, 3, 0), 1.1, 1e-6);
    EXPECT_THAT(reference.origin, HasSubstr(fmt::format("{:.1e}", 0.04 / 1.01 / 4)));
    // Good enough for a caller who wants less.
    settings_.error = 1e-2;
    EXPECT_EQ(render().origin, reference.origin);
    EXPECT_EQ(calls(), 0);
}

TEST_F(BenchReference, IsKeptForItsKey) {
    render();
    calls();
    render();
    EXPECT_EQ(calls(), 0);
    render("another state of the scene");
    EXPECT_EQ(calls(), 2);
    settings_.integrator = "bdpt";
    render("another state of the scene");
    EXPECT_EQ(calls(), 2);
}

TEST_F(BenchReference, GoesOnAfterAnInterruption) {
    pictures(1, 1.2f);
    settings_.maxSpp = 1000;
    settings_.error = 1e-5;
    std::filesystem::create_directories(path("references"));
    // Its second part fails, and ends the first attempt.
    std::filesystem::rename(path("odd.exr"), path("hidden.exr"));
    EXPECT_THAT(errorOf([&] { render(); }), HasSubstr("room"));
    EXPECT_EQ(calls(), 2);
    std::filesystem::rename(path("hidden.exr"), path("odd.exr"));
    EXPECT_THAT(render().origin, HasSubstr("896 spp"));
    EXPECT_EQ(calls(), 5);  // the first part was there
}

TEST_F(BenchReference, CancelledThereIsNone) {
    CancelToken cancel;
    cancel.cancel();
    EXPECT_EQ(render("key", &cancel).path, "");
}

TEST_F(BenchReference, TooFewSamplesAreAnError) {
    settings_.maxSpp = 100;
    EXPECT_THAT(errorOf([&] { render(); }), HasSubstr("128 spp"));
}

}  // namespace
}  // namespace drc
