#include "base/rescued_file.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "base/numbered_path.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

class RescuedFileTest : public FolderTest {};

TEST_F(RescuedFileTest, GoesToTheFirstFolderThatTakesIt) {
    fs::create_directory(path("room"));
    const std::vector<std::string> folders{path("none"), path("room"), path("")};
    EXPECT_EQ(writeRescued("/full/a.exr", "1", folders), path("room/a.rescued.exr"));
    EXPECT_EQ(readFile(path("room/a.rescued.exr")), "1");
    // What is there stays.
    EXPECT_EQ(writeRescued("/full/a.exr", "2", folders), path("room/a.rescued-2.exr"));
    fs::create_symlink("nowhere", path("room/a.rescued-3.exr"));
    EXPECT_EQ(writeRescued("/full/a.exr", "3", folders), path("room/a.rescued-4.exr"));
    EXPECT_EQ(readFile(path("room/a.rescued.exr")), "1");
    EXPECT_EQ(writeRescued("/full/a.exr", "4", {path("none")}), "");
}

TEST_F(RescuedFileTest, LooksBesideTheSceneAndInTheTemporaryFolder) {
    EXPECT_THAT(rescueFolders("/full/a.exr", "scenes/room.pbrt"),
                testing::ElementsAre("/full", "scenes", fs::temp_directory_path().string()));
}

TEST_F(RescuedFileTest, LongNamesAreCutBetweenCharacters) {
    const std::string letters(251, 'n');
    EXPECT_EQ(numberedPath("f", "x/" + letters + ".exr", "rescued", 2),
              "f/" + letters.substr(0, 255 - 14) + ".rescued-2.exr");
    std::string umlauts;
    while (umlauts.size() < 250) umlauts += "\xc3\xa4";
    const std::string name = numberedPath("", umlauts + ".exr", "rescued", 1);
    EXPECT_EQ(name.size(), 254u);
    EXPECT_THAT(name, testing::EndsWith("\xc3\xa4.rescued.exr"));
    EXPECT_EQ(writeRescued("/full/" + letters + ".exr", "1", {path("")}),
              numberedPath(path(""), letters + ".exr", "rescued", 1));
}

}  // namespace
}  // namespace drc
