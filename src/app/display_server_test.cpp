#include "app/display_server.h"

#include <gtest/gtest.h>

#include "app/command.h"
#include "app/command_testing.h"
#include "base/folder_testing.h"
#include "image/exr_reader.h"
#include "image/image_io.h"
#include "image/image_layers.h"
#include "view/tev_testing.h"

namespace drc {
namespace {

// Where the viewer's names are not those of EXR files.
const std::map<std::string, std::string> kLayers{{"albedo", "Denoising Albedo"},
                                                 {"normal", "Denoising Normal"},
                                                 {"depth", "Denoising Depth"},
                                                 {"variance", "Denoising Variance"},
                                                 {"samples", "Debug Sample Count"}};

std::string channelOfExr(const std::string& channel) {
    const auto layer = kLayers.find(channel.substr(0, channel.find('.')));
    return layer == kLayers.end() ? channel : layer->second + channel.substr(channel.find('.'));
}

class DisplayServerTest : public FolderTest {
  protected:
    void SetUp() override {
        // A sensor that balances colours, so that what is written is not what was sampled.
        folder_.write("scene.pbrt", R"(
            Film "rgb" "integer xresolution" 200 "integer yresolution" 150 "float whitebalance" 4000
            Camera "perspective" "float fov" 70
            WorldBegin
            AttributeBegin
            AreaLightSource "diffuse" "rgb L" [4 3 2]
            Translate 0 2 2 Shape "sphere" "float radius" .5
            AttributeEnd
            Material "diffuse" "rgb reflectance" [.2 .5 .7]
            Shape "sphere" "float radius" 5
            WorldEnd)");
    }

    // Renders, and returns what the viewer shows at the end, having checked that it is what the file has.
    test::FakeTev::Shown rendered(std::vector<std::string> arguments) {
        test::FakeTev viewer;
        arguments.insert(arguments.begin(), {"render", path("scene.pbrt"), "--quiet", "-o", path("out.exr"), "--spp",
                                             "4", "--display-server", fmt::format("127.0.0.1:{}", viewer.port())});
        test::outputOf(addRenderCommand, arguments);
        viewer.awaitEnd();
        const std::string folder = std::filesystem::path(path("")).parent_path().filename();
        const auto shown = viewer.image(fmt::format("{0}/scene.pbrt ({0}/out.exr)", folder));
        EXPECT_EQ(shown.width, 200);
        EXPECT_EQ(shown.height, 150);
        const Image file = readImage(path("out.exr"));
        for (const auto& [name, values] : shown.channels) {
            const int channel = file.channelIndex(channelOfExr(name));
            if (channel < 0) continue;
            ++compared_;
            for (int y = 0; y < file.height(); ++y)
                for (int x = 0; x < file.width(); ++x)
                    EXPECT_EQ(values[size_t((y + y0_) * 200 + x + x0_)], file.at(x, y, channel))
                        << name << x << " " << y;
        }
        // What is for compositing alone is not shown.
        EXPECT_EQ(
            compared_,
            withoutLayers(file, {kPositionLayer, kDepthLayer, kObjectIndexLayer, kMaterialIndexLayer}).channels());
        return shown;
    }

    int x0_ = 0, y0_ = 0;  // of the region
    int compared_ = 0;
};

TEST_F(DisplayServerTest, ShowsWhatIsWritten) {
    const auto shown = rendered({"--integrator", "path", "--denoise", "off"});
    EXPECT_EQ(shown.channels.size(), 3u);
}

TEST_F(DisplayServerTest, ShowsAllLayersOfAPartOfTheFilm) {
    x0_ = 50;
    y0_ = 30;
    const auto shown = rendered({"--integrator", "drc-maps", "--map-denoiser", "none", "--passes", "1", "--aovs",
                                 "--crop", ".25", ".75", ".2", "1"});
    for (const char* channel : {"direct.R", "indirect.B", "albedo.G", "normal.Z", "depth.Z", "variance.R", "samples.X"})
        EXPECT_TRUE(shown.channels.contains(channel)) << channel;
    EXPECT_EQ(compared_, 20);
    for (int y = 0; y < 150; ++y)
        for (int x = 0; x < 200; ++x)
            if (x < 50 || x >= 150 || y < 30) {
                EXPECT_EQ(shown.channels.at("R")[size_t(y * 200 + x)], 0);
            }
}

}  // namespace
}  // namespace drc
