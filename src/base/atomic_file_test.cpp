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
    fs::create_directories(path("sub"));
    fs::create_symlink("real", path("relative"));
    fs::create_symlink(path("real"), path("absolute"));
    fs::create_symlink("sub/second", path("chain"));
    fs::create_symlink("../real", path("sub/second"));
    for (const char* old : {"old", ""})
        for (const char* link : {"relative", "absolute", "chain"}) {
            SCOPED_TRACE(std::string(link) + (*old ? "" : ", leading to nothing yet"));
            if (*old)
                writeFileAtomically(path("real"), old);
            else
                fs::remove(path("real"));
            writeFileAtomically(path(link), "new");
            EXPECT_TRUE(fs::is_symlink(path(link)) && fs::is_symlink(path("sub/second")));
            EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path("real"))));
            EXPECT_EQ(readFile(path("real")), "new");
        }
    EXPECT_EQ(fileCount(), 5u);
}

TEST_F(AtomicFileTest, LinksToWhereNothingCanBeWrittenStayAndAreNamed) {
    fs::create_symlink("no/such", path("lost"));
    EXPECT_EQ(errorOf([&] { writeFileAtomically(path("lost"), "x"); }),
              "cannot write " + path("lost") + " (a link to " + path("no/such") + "): No such file or directory");
    fs::create_symlink("b", path("a"));
    fs::create_symlink("a", path("b"));
    EXPECT_THAT(errorOf([&] { writeFileAtomically(path("a"), "x"); }), HasSubstr("Too many levels of symbolic links"));
    fs::create_symlink(".", path("folder"));
    EXPECT_THAT(errorOf([&] { writeFileAtomically(path("folder"), "x"); }), HasSubstr("Is a directory"));
    EXPECT_EQ(fileCount(), 4u);
    for (const auto& entry : fs::directory_iterator(dir_)) EXPECT_TRUE(entry.is_symlink());
}

// While it lives, files are written with the rights of nobody. Root may write anywhere.
class WithoutRights {
  public:
    WithoutRights() {
        if (geteuid() == 0) lowered_ = setegid(65534) == 0 && seteuid(65534) == 0;
    }
    ~WithoutRights() {
        if (lowered_ && (seteuid(0) != 0 || setegid(0) != 0)) std::abort();
    }

  private:
    bool lowered_ = false;
};

TEST_F(AtomicFileTest, AFolderThatMayNotBeWrittenKeepsTheFileBehindALink) {
    fs::create_directories(path("closed"));
    writeFileAtomically(path("closed/real"), "old");
    chmod(path("closed/real").c_str(), 0666);
    fs::create_symlink("closed/real", path("link"));
    chmod(dir_.c_str(), 0777);
    chmod(path("closed").c_str(), 0555);
    const std::string message = errorOf([&] {
        const WithoutRights nobody;
        writeFileAtomically(path("link"), "new");
    });
    chmod(path("closed").c_str(), 0755);
    EXPECT_EQ(message, "cannot write " + path("link") + " (a link to " + path("closed/real") + "): Permission denied");
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(readFile(path("link")), "old");
}

TEST_F(AtomicFileTest, OwnerAndGroupStay) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can give files away";
    writeFileAtomically(path("a"), "old");
    ASSERT_EQ(chown(path("a").c_str(), 12345, 23456), 0);
    chmod(path("a").c_str(), 0660);
    writeFileAtomically(path("a"), "new");
    struct stat status = {};
    ASSERT_EQ(stat(path("a").c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, 12345u);
    EXPECT_EQ(status.st_gid, 23456u);
    EXPECT_EQ(status.st_mode & 07777, 0660u);
}

TEST_F(AtomicFileTest, AnotherGroupGetsNoRightsOfTheOldOne) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can make a file of a group that it is not in";
    writeFileAtomically(path("a"), "old");
    ASSERT_EQ(chown(path("a").c_str(), 65534, 23456), 0);
    chmod(path("a").c_str(), 0664);
    chmod(dir_.c_str(), 0777);
    {
        const WithoutRights nobody;
        writeFileAtomically(path("a"), "new");
    }
    struct stat status = {};
    ASSERT_EQ(stat(path("a").c_str(), &status), 0);
    EXPECT_EQ(status.st_gid, 65534u);
    EXPECT_EQ(status.st_mode & 07777, 0644u);
}

TEST_F(AtomicFileTest, LeftoversOfOthersAreNotTouched) {
    // The name that the next file would have: the numbers go up by one.
    writeFileAtomically(path("a"), "old");
    writeFileAtomically(path("precious"), "theirs");
    std::string next;
    for (AtomicFile file(path("a")); next.empty();)
        for (const auto& entry : fs::directory_iterator(dir_))
            if (entry.path().extension() == ".tmp") next = entry.path().string();
    const size_t dot = next.rfind('.', next.size() - 5);
    const int serial = std::stoi(next.substr(dot + 1));
    const std::string other = next.substr(0, dot + 1) + std::to_string(serial + 1) + ".tmp";
    fs::create_symlink("precious", other);
    writeFileAtomically(path("a"), "new");
    EXPECT_EQ(readFile(path("precious")), "theirs");
    EXPECT_EQ(readFile(path("a")), "new");
}

TEST_F(AtomicFileTest, LongNamesAreWritten) {
    const std::string name = path(std::string(251, 'n') + ".exr");
    writeFileAtomically(name, "x");
    EXPECT_EQ(readFile(name), "x");
    // Known before the work, although the temporary file has a shorter name.
    EXPECT_THAT(errorOf([&] { AtomicFile(path(std::string(296, 'n') + ".exr")); }), HasSubstr("File name too long"));
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
