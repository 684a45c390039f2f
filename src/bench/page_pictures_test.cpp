#include "bench/page_pictures.h"

#include <gtest/gtest.h>

#include <set>

#include "bench/page_testing.h"
#include "image/difference_image.h"
#include "report/html_page.h"
#include "report/html_testing.h"

namespace drc {
namespace {

using testing::Test;

class PagePicturesTest : public Test {
  protected:
    PagePictures pictures() const { return pagePictures(b.report, b.folder.path()); }
    std::string uri(const std::string& file) const { return pngDataUri(readLinearRgb(b.folder.path(file))); }

    ReportBuilder b;
};

TEST_F(PagePicturesTest, FiguresAreOfTheLargestCommonBudget) {
    for (const double amount : {2., 8.})
        for (const char* method : {"drc", "path"}) b.add("box", method, seconds(amount), 0.1);
    b.add("box", "drc", seconds(30), 0.1);
    for (const char* method : {"drc", "path"}) b.add("box", method, spp(64), 0.1);
    const PagePictures made = pictures();
    EXPECT_NE(made.figures.find("<h3>box, 8 s</h3>"), std::string::npos);
    EXPECT_EQ(occurrences(made.figures, "<figure "), 3);
    EXPECT_EQ(occurrences(made.gallery, "<figure "), 5);
    EXPECT_EQ(brokenNesting(made.figures), "");
    EXPECT_EQ(brokenNesting(made.gallery), "");
    EXPECT_NE(made.figures.find("data-scene=\"0\" data-method=\"1\" data-budget=\"1\""), std::string::npos);
    EXPECT_NE(made.gallery.find("data-scene=\"0\" data-method=\"0\" data-budget=\"2\""), std::string::npos);
}

TEST_F(PagePicturesTest, EachPictureIsThereOnce) {
    for (const char* scene : {"box", "hall"})
        for (const double amount : {2., 8.})
            for (const char* method : {"drc", "path"}) b.add(scene, method, seconds(amount), 0.1);
    const PagePictures made = pictures();
    const std::string all = made.figures + made.gallery;
    for (const BenchRun& run : b.report.runs) EXPECT_EQ(occurrences(all, uri(run.picture)), 1) << run.picture;
    for (const BenchScene& scene : b.report.scenes) EXPECT_EQ(occurrences(all, uri(scene.reference)), 1);
}

TEST_F(PagePicturesTest, DifferencesAreThoseOfDifferenceImage) {
    const std::string path = b.add("box", "drc", seconds(2), 0.1).picture;
    b.add("box", "path", seconds(2), 0.1);
    const Image reference = readLinearRgb(b.folder.path(b.report.scenes[0].reference));
    const Image parts = differenceImage(reference, readLinearRgb(b.folder.path(path)));
    EXPECT_NE(pictures().figures.find(pngDataUri(parts.crop(32, 0, 48, 12))), std::string::npos);
}

TEST_F(PagePicturesTest, TheFirstRepeatIsShown) {
    b.addFailure("box", "drc", seconds(2), "no");
    const std::string first = b.add("box", "drc", seconds(2), 0.125).picture;
    const std::string second = b.add("box", "drc", seconds(2), 0.375).picture;
    const PagePictures made = pictures();
    EXPECT_EQ(made.figures, "");
    EXPECT_NE(made.gallery.find(uri(first)), std::string::npos);
    EXPECT_EQ(made.gallery.find(uri(second)), std::string::npos);
    EXPECT_NE(made.gallery.find("<dt>error</dt><dd>0.125</dd>"), std::string::npos);
    EXPECT_NE(made.gallery.find("<dt>FLIP</dt><dd>0.0625</dd>"), std::string::npos);
}

TEST_F(PagePicturesTest, ScenesWithoutPicturesNeedNoReference) {
    b.addFailure("box", "drc", seconds(2), "no");
    b.report.scenes[0].reference = "is-not-there.exr";
    EXPECT_TRUE(pictures().empty());
}

TEST_F(PagePicturesTest, ReferencesMayLieElsewhere) {
    const TemporaryFolder elsewhere;
    writeExr(elsewhere.path("far.exr"), testPicture(63));
    b.add("box", "drc", seconds(2), 0.1);
    b.report.scenes[0].reference = elsewhere.path("far.exr");
    EXPECT_NE(pictures().gallery.find(pngDataUri(testPicture(63))), std::string::npos);
}

TEST_F(PagePicturesTest, ErrorsNameTheFile) {
    b.add("box", "drc", seconds(2), 0.1);
    b.add("box", "path", seconds(2), 0.1);
    writeExr(b.folder.path("small.exr"), testPicture(1, 5, 5));
    b.report.runs[1].picture = "small.exr";
    EXPECT_NE(errorOf([&] { pictures(); }).find("small.exr: "), std::string::npos);
    b.report.runs[1].picture = "gone.exr";
    EXPECT_NE(errorOf([&] { pictures(); }).find("gone.exr"), std::string::npos);
    b.report.scenes[0].reference = "lost.exr";
    EXPECT_NE(errorOf([&] { pictures(); }).find("lost.exr"), std::string::npos);
}

}  // namespace
}  // namespace drc
