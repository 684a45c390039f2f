#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/command.h"
#include "base/folder_testing.h"
#include "image/image_io.h"

namespace drc {
namespace {

using testing::HasSubstr;

class RenderCommandTest : public FolderTest {
  protected:
    void SetUp() override {
        folder_.write("scene.pbrt", R"(
            Film "image" "integer xresolution" 24 "integer yresolution" 16
            Camera "perspective" "float fov" 70
            WorldBegin
            AttributeBegin
            AreaLightSource "diffuse" "rgb L" [4 4 4]
            Translate 0 2 2 Shape "sphere" "float radius" .5
            AttributeEnd
            Shape "sphere" "float radius" 5
            WorldEnd)");
    }

    void run(std::vector<std::string> arguments) const {
        CLI::App app;
        addRenderCommand(app);
        arguments.insert(arguments.begin(), {"render", path("scene.pbrt"), "--quiet", "-o", path("out.exr"),
                                             "--enhancer", "none", "--spp", "8", "--passes", "1", "--seed", "3"});
        std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants a vector
        app.parse(std::move(arguments));
    }
    std::vector<float> picture(std::vector<std::string> arguments) const {
        run(std::move(arguments));
        return readImage(path("out.exr")).data();
    }
};

TEST_F(RenderCommandTest, DenoisesUnlessToldNotTo) {
    const std::vector<float> standard = picture({});
    EXPECT_EQ(picture({"--denoise", "surface"}), standard);
    EXPECT_NE(picture({"--denoise", "off"}), standard);
}

TEST_F(RenderCommandTest, OnlyLayersOfDrcAreDenoised) {
    EXPECT_NO_THROW(run({"--integrator", "path", "--denoise", "off"}));
    EXPECT_THAT(errorOf([&] {
                    run({"--integrator", "path", "--denoise", "surface"});
                }),
                HasSubstr("--denoise surface: it filters the layers of --integrator drc"));
    EXPECT_THROW(run({"--denoise", "much"}), CLI::ValidationError);
}

}  // namespace
}  // namespace drc
