#include "app/scene_overrides.h"

#include <gmock/gmock.h>

#include "app/usage_error.h"
#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

SceneOverrides parsed(std::vector<std::string> arguments) {
    CLI::App app;
    SceneOverrides overrides;
    addSceneOverrides(app, overrides);
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants a vector
    app.parse(std::move(arguments));
    return overrides;
}

std::string fault(std::vector<std::string> arguments) {
    const SceneOverrides overrides = parsed(std::move(arguments));
    try {
        overrides.check();
        return "";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
        return error.what();
    }
}

TEST(SceneOverrides, CropWindowsAreFractionsInOrder) {
    EXPECT_THAT(fault({"--crop", ".9", ".1", "0", "1"}), AllOf(HasSubstr("--crop 0.9 0.1 0 1"), HasSubstr("x0 < x1")));
    EXPECT_THAT(fault({"--crop", "0", "1", ".5", ".5"}), HasSubstr("y0 must be less than y1"));
    for (const char* far : {"640", "1.01", "-.1"})
        EXPECT_THAT(fault({"--crop", "0", far, "0", "1"}), HasSubstr("fractions"));
    EXPECT_EQ(parsed({"--crop", "0,.5,.25,1"}).crop, (std::vector<double>{0, .5, .25, 1}));  // as pbrt-v4 has it
    RenderSettings settings;
    parsed({"--crop", "0", ".5", ".25", "1"}).cropFilm(settings);
    EXPECT_THAT(settings.cropWindow, testing::ElementsAre(0, .5f, .25f, 1));
}

TEST(SceneOverrides, ResolutionsHaveTwoSides) {
    for (const char* wrong : {"0x0", "0x720", "-1280x720", "1280", "1280x", "x720", "1280*720", "1280x720x3",
                              "1280x720 ", "1280.5x720", "65537x1", "4294967297x1", "nanxnan", "1280 x 720"})
        EXPECT_THAT(fault({"--resolution", wrong}), AllOf(HasSubstr(wrong), HasSubstr("as 1280x720"))) << wrong;
    EXPECT_EQ(parsed({"--resolution", "1280x720"}).loadOptions().resolution->width, 1280);
}

TEST(SceneOverrides, CamerasLookSomewhere) {
    const auto lookAt = [](const std::vector<std::string>& numbers) {
        std::vector<std::string> arguments{"--lookat"};
        arguments.insert(arguments.end(), numbers.begin(), numbers.end());
        return fault(arguments);
    };
    EXPECT_EQ(lookAt({"0", "1", "-.5", "0", "1", "0", "0", "1", "0"}), "");
    EXPECT_THAT(lookAt({"0", "1", "5", "0", "1", "5", "0", "1", "0"}),
                AllOf(HasSubstr("--lookat"), HasSubstr("same point")));
    EXPECT_THAT(lookAt({"0", "1", "5", "0", "1", "0", "0", "0", "3"}), HasSubstr("along its up vector"));
    EXPECT_THAT(lookAt({"0", "1", "5", "0", "1", "0", "0", "0", "0"}), HasSubstr("is zero"));
    EXPECT_THAT(lookAt({"0", "1", "1e30", "0", "1", "0", "0", "1", "0"}), HasSubstr("beyond 1e18"));
    EXPECT_THROW(parsed({"--lookat", "0", "1", "nan", "0", "1", "0", "0", "1", "0"}), CLI::ParseError);
    EXPECT_THROW(parsed({"--lookat", "0", "1", "5"}), CLI::ParseError);
}

class SceneOverridesTest : public FolderTest {};

TEST_F(SceneOverridesTest, WrongParametersAreOfTheCommandLine) {
    folder_.write("a.pbrt", "Camera \"orthographic\" WorldBegin WorldEnd");
    EXPECT_THROW(parsed({"-D", "film.nonsense=1"}).load(path("a.pbrt")), UsageError);
    EXPECT_THAT(errorOf([&] {
                    parsed({"--fov", "40"}).load(path("a.pbrt"));
                }),
                AllOf(HasSubstr("a.pbrt:1:8"), HasSubstr("'orthographic' has no field of view")));
}

}  // namespace
}  // namespace drc
