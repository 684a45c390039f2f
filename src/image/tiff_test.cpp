// Kinds that image_files_test.cpp compares with another reader are not repeated here.
#include "image/tiff.h"

#include <gmock/gmock.h>
#include <tiffio.h>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "image/image_io.h"

namespace drc {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class TiffTest : public FolderTest {
  protected:
    // One strip; `values` are the bytes of one pixel after another.
    template <typename T>
    Image write(int width, int height, int samples, const std::vector<T>& values, int format = SAMPLEFORMAT_UINT,
                int orientation = ORIENTATION_TOPLEFT, int extra = -1, int photometric = -1) {
        TIFF* tiff = TIFFOpen(path("a.tif").c_str(), "w");
        TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, uint32_t(width));
        TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, uint32_t(height));
        TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, int(8 * sizeof(T)));
        TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, samples);
        TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, format);
        TIFFSetField(tiff, TIFFTAG_ORIENTATION, orientation);
        TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, uint32_t(height));
        const int colours = samples < 3 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB;
        TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, photometric < 0 ? colours : photometric);
        if (const auto kind = uint16_t(extra); extra >= 0) TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &kind);
        TIFFWriteEncodedStrip(tiff, 0, const_cast<T*>(values.data()), tmsize_t(values.size() * sizeof(T)));
        TIFFClose(tiff);
        return readImage(path("a.tif"));
    }
    std::string fault() {
        return errorOf([&] { readImage(path("a.tif")); });
    }
};

TEST_F(TiffTest, IsTurnedAsItSays) {
    const std::vector<uint8_t> values{51, 102, 153, 204, 255, 0};  // rows of three
    using testing::Pointwise;
    const auto expect = [&](int orientation, int width, std::vector<float> fifths) {
        const Image image = write(3, 2, 1, values, SAMPLEFORMAT_UINT, orientation);
        EXPECT_EQ(image.width(), width) << orientation;
        for (float& v : fifths) v /= 5;
        EXPECT_THAT(image.data(), Pointwise(testing::FloatNear(1e-6f), fifths)) << orientation;
    };
    expect(ORIENTATION_TOPLEFT, 3, {1, 2, 3, 4, 5, 0});
    expect(ORIENTATION_TOPRIGHT, 3, {3, 2, 1, 0, 5, 4});
    expect(ORIENTATION_BOTRIGHT, 3, {0, 5, 4, 3, 2, 1});
    expect(ORIENTATION_BOTLEFT, 3, {4, 5, 0, 1, 2, 3});
    expect(ORIENTATION_LEFTTOP, 2, {1, 4, 2, 5, 3, 0});
    expect(ORIENTATION_RIGHTTOP, 2, {4, 1, 5, 2, 0, 3});
    expect(ORIENTATION_RIGHTBOT, 2, {0, 3, 5, 2, 4, 1});
    expect(ORIENTATION_LEFTBOT, 2, {3, 0, 2, 5, 1, 4});
}

// Integers have colours that are not multiplied by alpha, floats have colours that are, as in PNG and EXR files.
TEST_F(TiffTest, AlphaIsMultipliedInAsInOtherFormats) {
    using Values = testing::Matcher<const std::vector<float>&>;
    const Values half = testing::Pointwise(testing::FloatNear(.005f), std::vector<float>{.5f, .5f});
    const Values whole = testing::Pointwise(testing::FloatNear(.005f), std::vector<float>{1, .5f});
    EXPECT_THAT(write<uint8_t>(1, 1, 2, {128, 128}, SAMPLEFORMAT_UINT, 1, EXTRASAMPLE_UNASSALPHA).data(), half);
    EXPECT_THAT(write<uint8_t>(1, 1, 2, {128, 128}, SAMPLEFORMAT_UINT, 1, EXTRASAMPLE_ASSOCALPHA).data(), whole);
    EXPECT_THAT(write<float>(1, 1, 2, {1, .5f}, SAMPLEFORMAT_IEEEFP, 1, EXTRASAMPLE_UNASSALPHA).data(), half);
    EXPECT_THAT(write<float>(1, 1, 2, {1, .5f}, SAMPLEFORMAT_IEEEFP, 1, EXTRASAMPLE_ASSOCALPHA).data(), whole);
    // What it has no name for is no alpha.
    EXPECT_THAT(write<uint8_t>(1, 1, 2, {51, 99}, SAMPLEFORMAT_UINT, 1, EXTRASAMPLE_UNSPECIFIED).channelNames(),
                testing::ElementsAre("Y"));
}

TEST_F(TiffTest, WhiteMayBeZero) {
    EXPECT_NEAR(write<uint8_t>(1, 1, 1, {51}, SAMPLEFORMAT_UINT, 1, -1, PHOTOMETRIC_MINISWHITE).data()[0], .8, 1e-6);
}

TEST_F(TiffTest, OneLineSaysWhatIsWrong) {
    EXPECT_EQ(errorOf([&] { write<uint32_t>(1, 1, 1, {7}); }),
              "cannot read " + path("a.tif") + ": its integers have 32 bits; 16 at most are read");
    EXPECT_EQ(
        errorOf([&] { write<int16_t>(1, 1, 1, {7}, SAMPLEFORMAT_INT); }),
        "cannot read " + path("a.tif") + ": its values are signed or complex; unsigned integers and floats are read");
    write<float>(30, 20, 3, std::vector<float>(1800, 1.5f), SAMPLEFORMAT_IEEEFP);
    const std::string whole = readFile(path("a.tif"));
    for (size_t n = 4; n < whole.size(); n += 7) {
        writeFileAtomically(path("a.tif"), whole.substr(0, n));
        EXPECT_THAT(fault(), StartsWith("cannot read " + path("a.tif") + ": ")) << n;
        EXPECT_EQ(fault().find('\n'), std::string::npos) << n;
    }
    // 0x100 is the tag of the width.
    const size_t width = whole.find(std::string("\0\1\3\0\1\0\0\0", 8));
    ASSERT_NE(width, std::string::npos);
    std::string wide = whole;
    wide[width + 2] = 4;
    for (const size_t at : {8u, 9u, 10u}) wide[width + at] = 0x7f;
    writeFileAtomically(path("a.tif"), wide);
    EXPECT_THAT(fault(), HasSubstr("its size is 8355711x20"));
}

}  // namespace
}  // namespace drc
