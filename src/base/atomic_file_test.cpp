#include "base/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "base/folder_testing.h"

namespace drc {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class AtomicFileTest : public FolderTest {
  protected:
    size_t fileCount() const { return size_t(std::distance(fs::directory_iterator(dir_), fs::directory_iterator())); }
};

TEST_F(AtomicFileTest, WritesAndReplaces) {
    writeFileAtomically(path("a"), "first");
    chmod(path("a").c_str(), 0600);
    const std::string bytes("sec\0nd", 6);
    writeFileAtomically(path("a"), bytes);
    EXPECT_EQ(readFile(path("a")), bytes);
    EXPECT_EQ(fs::status(path("a")).permissions(), fs::perms(0600));
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(AtomicFileTest, WithoutCommitNothingChanges) {
    writeFileAtomically(path("a"), "old");
    {
        AtomicFile file(path("a"));
        file.write("new");
        EXPECT_EQ(fileCount(), 2u);
    }
    EXPECT_EQ(readFile(path("a")), "old");
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(AtomicFileTest, ErrorsNameThePathAndTheReason) {
    const std::string lost = path("no/such/a");
    EXPECT_EQ(errorOf([&] { writeFileAtomically(lost, "x"); }), "cannot write " + lost + ": No such file or directory");
    EXPECT_EQ(errorOf([&] { writeFileAtomically(dir_, "x"); }), "cannot write " + dir_.string() + ": Is a directory");
    EXPECT_EQ(errorOf([&] { readFile(lost); }), "cannot read " + lost + ": No such file or directory");
    EXPECT_THAT(errorOf([&] { readFile(dir_); }), HasSubstr("Is a directory"));
    EXPECT_THAT(errorOf([&] { writeFileAtomically("", "x"); }), HasSubstr("No such file"));
}

TEST_F(AtomicFileTest, DevicesAreWrittenAndNotReplaced) {
    writeFileAtomically("/dev/null", "x");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_EQ(errorOf([] { writeFileAtomically("/dev/full", "x"); }),
              "cannot write /dev/full: No space left on device");
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(AtomicFileTest, SymbolicLinksStay) {
    writeFileAtomically(path("real"), "old");
    fs::create_symlink("real", path("link"));
    writeFileAtomically(path("link"), "new");
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(readFile(path("real")), "new");
}

TEST_F(AtomicFileTest, AFullDiskLeavesTheOldFile) {
    writeFileAtomically(path("a"), "old");
    const std::string message = errorOf([&] {
        const FileSizeLimit fullDisk(4096);
        writeFileAtomically(path("a"), std::string(100000, 'x'));
    });
    EXPECT_EQ(message, "cannot write " + path("a") + ": File too large");
    EXPECT_EQ(readFile(path("a")), "old");
    EXPECT_EQ(fileCount(), 1u);
}

}  // namespace
}  // namespace drc
