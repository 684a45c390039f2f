// The noise of frames: that of a frame is the same however it is rendered, and another one in each frame.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/command.h"
#include "base/error.h"
#include "base/folder_testing.h"
#include "image/frame_geometry.h"
#include "image/image_io.h"

namespace drc {
namespace {

using testing::HasSubstr;

constexpr const char* kScene = R"(
    Film "image" "integer xresolution" 24 "integer yresolution" 16
    Camera "perspective" "float fov" 70
    WorldBegin
    AttributeBegin
    AreaLightSource "diffuse" "rgb L" [4 4 4]
    Translate 0 2 2 Shape "sphere" "float radius" .5
    AttributeEnd
    Shape "sphere" "float radius" 5
    WorldEnd)";

class FrameSeed : public FolderTest {
  protected:
    void SetUp() override {
        for (const char* name : {"scene.pbrt", "frame0.pbrt", "frame1.pbrt", "frame.0007.pbrt"})
            folder_.write(name, kScene);
    }
    void run(const std::string& scene, const std::string& output, const std::vector<std::string>& options = {}) const {
        std::vector<std::string> arguments{"render", path(scene), "--quiet", "-o",           path(output), "--spp",
                                           "2",      "--denoise", "off",     "--integrator", "path"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        if (std::ranges::find(options, "--seed") == options.end()) arguments.insert(arguments.end(), {"--seed", "3"});
        std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants a vector
        CLI::App app;
        addRenderCommand(app);
        testing::internal::CaptureStdout();  // --frames tells of its pictures
        try {
            app.parse(std::move(arguments));
        } catch (...) {
            testing::internal::GetCapturedStdout();
            throw;
        }
        testing::internal::GetCapturedStdout();
    }
    std::vector<float> pixels(const std::string& name) const { return readLinearRgb(path(name)).data(); }
    std::vector<float> picture(const std::string& scene, const std::vector<std::string>& options = {}) const {
        run(scene, "out.exr", options);
        return pixels("out.exr");
    }
};

TEST_F(FrameSeed, IsThatOfTheNumberInTheName) {
    const std::vector<float> still = picture("scene.pbrt"), seventh = picture("frame.0007.pbrt");
    EXPECT_EQ(picture("frame0.pbrt"), still);
    EXPECT_NE(seventh, still);
    EXPECT_NE(picture("frame1.pbrt"), still);
    EXPECT_NE(picture("frame1.pbrt"), seventh);
    EXPECT_EQ(picture("scene.pbrt", {"--frame", "7"}), seventh);
    EXPECT_EQ(picture("frame1.pbrt", {"--frame", "7"}), seventh);
    EXPECT_NE(picture("frame.0007.pbrt", {"--seed", "4"}), seventh);
}

TEST_F(FrameSeed, IsTheSameAloneAndInAnyOrder) {
    const std::vector<float> still = picture("scene.pbrt"), seventh = picture("frame.0007.pbrt"),
                             first = picture("frame1.pbrt");
    const std::string tab = "\t", end = "\n";
    folder_.write("frames.txt", path("frame.0007.pbrt") + tab + path("7.exr") + end + path("frame1.pbrt") + tab +
                                    path("1.exr") + end);
    run("scene.pbrt", "0.exr", {"--frames", path("frames.txt")});
    EXPECT_EQ(pixels("0.exr"), still);
    EXPECT_EQ(pixels("7.exr"), seventh);
    EXPECT_EQ(pixels("1.exr"), first);
}

TEST_F(FrameSeed, IsInTheMetadata) {
    run("frame.0007.pbrt", "out.exr");
    const ExrMetadata metadata = readExrMetadata(path("out.exr"));
    EXPECT_EQ(frameNumberIn(metadata), 7);
    EXPECT_EQ(metadata.at("drc:seed"), "3");
    run("scene.pbrt", "out.exr");
    EXPECT_EQ(frameNumberIn(readExrMetadata(path("out.exr"))), 0);
}

TEST_F(FrameSeed, OfACheckpointMustBeTheSame) {
    run("scene.pbrt", "out.exr", {"--frame", "7", "--checkpoint", path("state")});
    const auto complaint = [&](const std::vector<std::string>& options) {
        return errorOf([&] { run("scene.pbrt", "out.exr", options); });
    };
    EXPECT_THAT(complaint({"--resume", path("state"), "--frame", "8"}), HasSubstr("another --frame: '7', here '8'"));
    EXPECT_THAT(complaint({"--resume", path("state")}), HasSubstr("--frame '7', here there is none"));
    EXPECT_EQ(complaint({"--resume", path("state"), "--frame", "7"}), "");
}

TEST_F(FrameSeed, NumbersOfAListAreNotGivenByHand) {
    folder_.write("frames.txt", path("frame1.pbrt") + "\t" + path("1.exr") + "\n");
    EXPECT_ANY_THROW(run("scene.pbrt", "0.exr", {"--frames", path("frames.txt"), "--frame", "3"}));
    EXPECT_FALSE(std::filesystem::exists(path("0.exr")));
    EXPECT_ANY_THROW(run("scene.pbrt", "0.exr", {"--frame", "-3"}));
}

}  // namespace
}  // namespace drc
