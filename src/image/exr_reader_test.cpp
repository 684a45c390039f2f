#include "image/exr_reader.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <OpenEXR/ImfTiledOutputPart.h>
#include <OpenEXR/ImfVecAttribute.h>
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

// A part "rgba" with halves "R", "G", "B" that are 1, 2, 3, in the right half of 4x1 pixels, and a part "depth" with a
// float "Z" that is 9, in the left half.
void writeParts(const std::string& path, bool isDepthFirst, bool isTiled = false) {
    std::vector<Imf::Header> headers;
    for (int i = 0; i < 2; ++i) {
        const bool isDepth = (i == 0) == isDepthFirst;
        const int x = isDepth ? 0 : 2;
        Imf::Header& header = headers.emplace_back(Imath::Box2i({0, 0}, {3, 0}), Imath::Box2i({x, 0}, {x + 1, 0}));
        header.setName(isDepth ? "depth" : "rgba");
        header.setType(isTiled ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
        if (isTiled) header.setTileDescription(Imf::TileDescription(2, 2));
        header.insert("says", Imf::StringAttribute(isDepth ? "one" : "two"));
        if (isDepth)
            header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
        else
            for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(Imf::HALF));
    }
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), 2);
    for (int i = 0; i < 2; ++i) {
        const Imath::Box2i window = headers[size_t(i)].dataWindow();
        std::array<float, 2> depth = {9, 9};
        std::array<half, 6> colours = {1, 2, 3, 1, 2, 3};
        Imf::FrameBuffer frame;
        if ((i == 0) == isDepthFirst) {
            frame.insert("Z", Imf::Slice::Make(Imf::FLOAT, depth.data(), window));
        } else {
            const char* names[] = {"R", "G", "B"};
            for (size_t c = 0; c < 3; ++c)
                frame.insert(names[c], Imf::Slice::Make(Imf::HALF, colours.data() + c, window, 6, 12));
        }
        if (isTiled) {
            Imf::TiledOutputPart part(file, i);
            part.setFrameBuffer(frame);
            part.writeTiles(0, 0, 0, 0);
        } else {
            Imf::OutputPart part(file, i);
            part.setFrameBuffer(frame);
            part.writePixels(1);
        }
    }
}

TEST_F(ExrReaderTest, AllPartsAreRead) {
    for (const bool isTiled : {false, true})
        for (const bool isDepthFirst : {false, true}) {
            writeParts(path("a.exr"), isDepthFirst, isTiled);
            const ImageFile file = readImageFile(path("a.exr"));
            EXPECT_THAT(file.image.channelNames(), ElementsAre("R", "G", "B", "depth.Z"));
            EXPECT_THAT(file.image.data(), ElementsAre(0, 0, 0, 9, 0, 0, 0, 9, 1, 2, 3, 0, 1, 2, 3, 0));
            EXPECT_EQ(file.beautyPart, "rgba");
            EXPECT_THAT(file.storage.halfChannels, ElementsAre("B", "G", "R"));
            const ExrMetadata metadata = readExrMetadata(path("a.exr"));
            EXPECT_EQ(metadata.at("says"), "two");
            EXPECT_EQ(metadata.at("depth.says"), "one");
            EXPECT_EQ(metadata.count("name"), 0u);
        }
}

TEST_F(ExrReaderTest, OtherPrimariesBecomeRec709) {
    Imf::Header header(2, 1);
    // Red and green are exchanged.
    Imf::addChromaticities(header, Imf::Chromaticities({.3f, .6f}, {.64f, .33f}, {.15f, .06f}, {.3127f, .329f}));
    const std::array<float, 6> pixels = {1, 2, 3, 1, 2, 3};
    Imf::FrameBuffer frame;
    for (const std::string layer : {"", "direct.", "N."})
        for (size_t c = 0; c < 3; ++c) {
            const std::string name = layer + "RGB"[c];
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
            frame.insert(name, Imf::Slice::Make(Imf::FLOAT, pixels.data() + c, header.dataWindow(), 12, 24));
        }
    {
        Imf::OutputFile file(path("a.exr").c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(1);
    }
    const ImageFile file = readImageFile(path("a.exr"));
    const std::vector<float> expected{2, 1, 3, 1, 2, 3, 2, 1, 3};  // the beauty, normals, direct light
    for (size_t c = 0; c < 9; ++c) EXPECT_NEAR(file.image.data()[c], expected[c], 1e-4) << c;
    EXPECT_EQ(file.storage.attributes.count("chromaticities"), 0u);
}

TEST_F(ExrReaderTest, KeepsWindowsTypesAndAttributes) {
    Imf::Header header(Imath::Box2i({-5, 3}, {94, 52}), kWindow, 2.f);
    header.compression() = Imf::PIZ_COMPRESSION;
    header.insert("frame", Imf::IntAttribute(7));
    header.insert("of another program", Imf::V2dAttribute({1, 2}));
    header.insert("note", Imf::StringAttribute("text"));
    const std::array<float, kPixels> floats = {.1f, kInfinity, 2, 3, 4, 5};
    std::array<half, kPixels> halves;
    std::copy(floats.begin(), floats.end(), halves.begin());
    const std::array<uint32_t, kPixels> integers = {0, 1, 16777216, 16777217, 4294967040u, 5};
    Imf::FrameBuffer frame;
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    frame.insert("Z", Imf::Slice::Make(Imf::FLOAT, floats.data(), kWindow));
    header.channels().insert("Y", Imf::Channel(Imf::HALF));
    frame.insert("Y", Imf::Slice::Make(Imf::HALF, halves.data(), kWindow));
    header.channels().insert("id", Imf::Channel(Imf::UINT));
    frame.insert("id", Imf::Slice::Make(Imf::UINT, integers.data(), kWindow));
    {
        Imf::OutputFile file(path("a.exr").c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(2);
    }
    testing::internal::CaptureStderr();
    const ImageFile read = readImageFile(path("a.exr"));
    EXPECT_THAT(testing::internal::GetCapturedStderr(),
                HasSubstr("the integers of its channel id beyond 16777216 are rounded to floats"));
    EXPECT_EQ(read.window, (ExrWindow{4, 1, 100, 50, -5, 3}));
    writeExr(path("b.exr"), {{"", &read.image}}, readExrMetadata(path("a.exr")), read.window, read.storage);

    const Imf::InputFile written(path("b.exr").c_str());
    EXPECT_EQ(written.header().displayWindow(), header.displayWindow());
    EXPECT_EQ(written.header().dataWindow(), kWindow);
    EXPECT_EQ(written.header().pixelAspectRatio(), 2);
    EXPECT_EQ(written.header().compression(), Imf::PIZ_COMPRESSION);
    EXPECT_EQ(written.header().typedAttribute<Imf::IntAttribute>("frame").value(), 7);
    EXPECT_EQ(written.header().typedAttribute<Imf::V2dAttribute>("of another program").value(), Imath::V2d(1, 2));
    EXPECT_EQ(written.header().typedAttribute<Imf::StringAttribute>("note").value(), "text");
    EXPECT_EQ(written.header().channels()["Z"].type, Imf::FLOAT);
    EXPECT_EQ(written.header().channels()["Y"].type, Imf::HALF);
    EXPECT_EQ(written.header().channels()["id"].type, Imf::UINT);
    testing::internal::CaptureStderr();
    EXPECT_EQ(readImage(path("b.exr")).data(), read.image.data());
    testing::internal::GetCapturedStderr();
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
