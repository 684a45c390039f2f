#include "scene/film_output.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

std::vector<std::string> outputs(const std::string& file) {
    RenderSettings settings;
    settings.outputFile = file;
    settings.outputFileAt = {"s.pbrt", 3, 14};
    return filmOutputs(settings);
}

TEST(FilmOutput, IsNamedAsTheFilmsFile) {
    using Names = std::vector<std::string>;
    EXPECT_EQ(filmOutputs(RenderSettings()), (Names{"pbrt.exr", "pbrt.png"}));
    EXPECT_EQ(outputs("room.tga"), (Names{"room.exr", "room.png"}));
    EXPECT_EQ(outputs("pictures/room.v2.exr"), (Names{"room.v2.exr", "room.v2.png"}));
    EXPECT_EQ(outputs("room"), (Names{"room.exr", "room.png"}));
    EXPECT_EQ(outputs(".room.exr"), (Names{".room.exr", ".room.png"}));
}

TEST(FilmOutput, ANameOfNoFileIsAnErrorAtTheFilm) {
    EXPECT_EQ(errorOf([] { outputs("dir/"); }),
              "s.pbrt:3:14: the film's file name 'dir/' names no picture: it must end in a file's name, such as "
              "'dir/picture.exr'");
    for (const char* name : {"", ".", "..", "a/..", "a/b/", "/", ".exr", "a/.png"})
        EXPECT_THAT(errorOf([&] { outputs(name); }), testing::StartsWith("s.pbrt:3:14: the film's file name '"));
}

}  // namespace
}  // namespace drc
