#include "base/write_probe.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>

#include "base/atomic_file.h"
#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;

class WriteProbeTest : public FolderTest {
  protected:
    std::string probe(const std::string& name) const {
        return errorOf([&] { probeWriting(path(name)); });
    }
    size_t fileCount() const {
        return size_t(std::distance(std::filesystem::directory_iterator(dir_), std::filesystem::directory_iterator()));
    }
};

TEST_F(WriteProbeTest, LeavesNothingAndTouchesNothing) {
    EXPECT_EQ(probe("new.exr"), "");
    EXPECT_EQ(fileCount(), 0u);
    folder_.write("old.exr", "old");
    const auto before = std::filesystem::last_write_time(path("old.exr"));
    EXPECT_EQ(probe("old.exr"), "");
    EXPECT_EQ(readFile(path("old.exr")), "old");
    EXPECT_EQ(std::filesystem::last_write_time(path("old.exr")), before);
    std::filesystem::create_symlink("nothing-yet.exr", path("link.exr"));
    EXPECT_EQ(probe("link.exr"), "");
    EXPECT_EQ(fileCount(), 2u);
}

TEST_F(WriteProbeTest, SaysWhatIsWrong) {
    std::filesystem::create_directory(path("folder.exr"));
    EXPECT_EQ(probe("folder.exr"), "cannot write " + path("folder.exr") + ": Is a directory");
    EXPECT_THAT(probe("none/a.exr"), HasSubstr("No such file or directory"));
    EXPECT_THAT(probe(std::string(296, 'n') + ".exr"), HasSubstr("File name too long"));
    EXPECT_EQ(probe(std::string(251, 'n') + ".exr"), "");
    EXPECT_THAT(errorOf([] { probeWriting("/proc/a.exr"); }), HasSubstr("cannot write /proc/a.exr: "));
    const FileSizeLimit fullDisk(1024);
    EXPECT_THAT(probe("new.exr"), HasSubstr("File too large"));
    EXPECT_EQ(fileCount(), 1u);
}

// Opened and closed, a pipe would tell its reader that all has been written.
TEST_F(WriteProbeTest, PipesAndDevicesAreNotOpened) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    EXPECT_EQ(probe("pipe"), "");
    EXPECT_EQ(errorOf([] { probeWriting("/dev/null"); }), "");
    // Also where it is a file, which would get the block that is written for a try.
    testing::internal::CaptureStdout();
    EXPECT_EQ(errorOf([] { probeWriting("/dev/stdout"); }), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

}  // namespace
}  // namespace drc
