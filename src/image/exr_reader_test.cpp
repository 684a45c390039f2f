#include "image/exr_reader.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "image/image_io.h"

namespace drc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

// Of a data window of 3x2 pixels.
const Imath::Box2i kWindow({-1, 4}, {1, 5});
constexpr int kPixels = 6;

class ExrReaderTest : public FolderTest {
  protected:
    // Channel k of pixel i is 10 k + i.
    void write(const std::vector<std::string>& names, Imf::PixelType type = Imf::FLOAT, bool isTiled = false) {
        Imf::Header header(Imath::Box2i({0, 0}, {99, 49}), kWindow);
        std::vector<std::array<float, kPixels>> floats(names.size());
        std::vector<std::array<half, kPixels>> halves(names.size());
        std::vector<std::array<uint32_t, kPixels>> integers(names.size());
        Imf::FrameBuffer frame;
        for (size_t k = 0; k < names.size(); ++k) {
            for (size_t i = 0; i < kPixels; ++i) floats[k][i] = float(10 * k + i);
            std::copy(floats[k].begin(), floats[k].end(), halves[k].begin());
            std::copy(floats[k].begin(), floats[k].end(), integers[k].begin());
            const void* data = type == Imf::FLOAT  ? static_cast<void*>(floats[k].data())
                               : type == Imf::HALF ? static_cast<void*>(halves[k].data())
                                                   : static_cast<void*>(integers[k].data());
            const size_t size = type == Imf::HALF ? sizeof(half) : sizeof(float);
            header.channels().insert(names[k], Imf::Channel(type));
            frame.insert(names[k], Imf::Slice::Make(type, data, kWindow, size, size * 3));
        }
        if (isTiled) {
            header.setTileDescription(Imf::TileDescription(2, 4));
            Imf::TiledOutputFile file(path("a.exr").c_str(), header);
            file.setFrameBuffer(frame);
            file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
        } else {
            Imf::OutputFile file(path("a.exr").c_str(), header);
            file.setFrameBuffer(frame);
            file.writePixels(2);
        }
    }
    std::vector<std::string> namesOf(const std::vector<std::string>& names) {
        write(names);
        return readImage(path("a.exr")).channelNames();
    }
    std::string fault() {
        return errorOf([&] { readImage(path("a.exr")); });
    }
};

TEST_F(ExrReaderTest, ReadsTheDataWindowOfAnyTypeAndLayout) {
    for (const auto type : {Imf::HALF, Imf::FLOAT, Imf::UINT})
        for (const bool isTiled : {false, true}) {
            write({"B", "G", "R"}, type, isTiled);
            const ImageFile file = readImageFile(path("a.exr"));
            EXPECT_EQ(file.encoding, Encoding::Float);
            ASSERT_EQ(sizeString(file.image), "3x2");
            EXPECT_EQ(file.image.rgb(0, 0), Rgb(20, 10, 0)) << type << isTiled;
            EXPECT_EQ(file.image.rgb(2, 1), Rgb(25, 15, 5)) << type << isTiled;
        }
}

TEST_F(ExrReaderTest, ChannelsStandLayerByLayerWithColoursFirst) {
    EXPECT_THAT(namesOf({"A", "B", "G", "R", "Z"}), ElementsAre("R", "G", "B", "A", "Z"));
    EXPECT_THAT(namesOf({"A", "Y"}), ElementsAre("Y", "A"));
    EXPECT_THAT(namesOf({"B", "G", "N.X", "N.Y", "N.Z", "R", "albedo.B", "albedo.G", "albedo.R", "id"}),
                ElementsAre("R", "G", "B", "id", "N.X", "N.Y", "N.Z", "albedo.R", "albedo.G", "albedo.B"));
    EXPECT_THAT(namesOf({"A", "X", "Y", "Z"}), ElementsAre("X", "Y", "Z", "A"));
    EXPECT_THAT(namesOf({"A", "X", "foo"}), ElementsAre("A", "X", "foo"));
    EXPECT_THAT(namesOf({"Blue", "Green", "Red", "alpha"}), ElementsAre("Red", "Green", "Blue", "alpha"));
}

TEST_F(ExrReaderTest, TheFirstPartIsRead) {
    std::vector<Imf::Header> headers(2, Imf::Header(2, 1));
    for (size_t i = 0; i < 2; ++i) {
        headers[i].setName(i == 0 ? "first" : "second");
        headers[i].setType(Imf::SCANLINEIMAGE);
        headers[i].channels().insert(i == 0 ? "Y" : "Z", Imf::Channel(Imf::FLOAT));
        headers[i].insert("says", Imf::StringAttribute(i == 0 ? "one" : "two"));
    }
    {
        Imf::MultiPartOutputFile file(path("a.exr").c_str(), headers.data(), 2);
        std::array<float, 2> values = {3, 4};
        for (int i = 0; i < 2; ++i) {
            Imf::FrameBuffer frame;
            frame.insert(i == 0 ? "Y" : "Z", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 8));
            Imf::OutputPart part(file, i);
            part.setFrameBuffer(frame);
            part.writePixels(1);
            values = {5, 6};
        }
    }
    const Image image = readImage(path("a.exr"));
    EXPECT_THAT(image.channelNames(), ElementsAre("Y"));
    EXPECT_THAT(image.data(), ElementsAre(3, 4));
    EXPECT_EQ(readExrMetadata(path("a.exr")).at("says"), "one");
}

TEST_F(ExrReaderTest, RefusesDeepAndSubsampledPictures) {
    {
        Imf::Header header(1, 1);
        header.setType(Imf::DEEPSCANLINE);
        header.compression() = Imf::ZIPS_COMPRESSION;
        header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
        uint32_t count = 1;
        float value = 2;
        float* pointer = &value;
        Imf::DeepFrameBuffer frame;
        frame.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(&count), 4, 4));
        frame.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(&pointer), 8, 8, 4));
        Imf::DeepScanLineOutputFile file(path("a.exr").c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(1);
    }
    EXPECT_EQ(fault(), "cannot read " + path("a.exr") + ": it is a deep picture (deepscanline)");
    {
        const std::vector<Imf::Rgba> pixels(16, Imf::Rgba(1, 2, 3));
        Imf::RgbaOutputFile file(path("a.exr").c_str(), 4, 4, Imf::WRITE_YC);
        file.setFrameBuffer(pixels.data(), 1, 4);
        file.writePixels(4);
    }
    EXPECT_EQ(fault(),
              "cannot read " + path("a.exr") + ": its channel BY has one value for 2x2 pixels; one for each is read");
}

TEST_F(ExrReaderTest, OneLineSaysWhatIsWrong) {
    for (const bool isTiled : {false, true}) {
        write({"R", "G", "B"}, Imf::HALF, isTiled);
        const std::string whole = readFile(path("a.exr"));
        for (size_t n = 4; n < whole.size(); ++n) {
            writeFileAtomically(path("a.exr"), whole.substr(0, n));
            EXPECT_THAT(fault(), StartsWith("cannot read " + path("a.exr") + ": ")) << n;
            EXPECT_EQ(fault().find('\n'), std::string::npos) << n;
        }
    }
    writePng(path("b.exr"), Image(1, 1));
    EXPECT_EQ(errorOf([&] { readExrMetadata(path("b.exr")); }), "cannot read " + path("b.exr") + ": it is no EXR file");
}

// A picture of 3x2 pixels may not ask for gigabytes of tiles.
TEST_F(ExrReaderTest, LargeTilesAreRefused) {
    write({"R", "G", "B"}, Imf::HALF, true);
    std::string bytes = readFile(path("a.exr"));
    const size_t tiles = bytes.find("tiledesc") + 9 + 4;
    for (const size_t at : {tiles + 2, tiles + 6}) bytes[at] = 1;  // 65536 more along each side
    writeFileAtomically(path("a.exr"), bytes);
    EXPECT_THAT(fault(), HasSubstr("its tiles are 65538x65540; at most 1073741824 pixels are read"));
}

}  // namespace
}  // namespace drc
