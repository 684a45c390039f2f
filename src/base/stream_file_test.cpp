#include "base/stream_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <future>
#include <thread>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "base/interrupt.h"

namespace drc {
namespace {

// More than a pipe holds.
const std::string kPicture(300000, 'p');

class StreamFileTest : public FolderTest {
  protected:
    ~StreamFileTest() override {
        interruptToken().reset();
        for (const int end : ends_) ::close(end);
    }
    std::string fifo() const {
        mkfifo(path("fifo").c_str(), 0600);
        return path("fifo");
    }
    // As the shell gives pipes and files to a program: by number.
    std::string given(int descriptor) { return "/dev/fd/" + std::to_string(descriptor); }
    std::string procGiven(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }
    void makePipe() { ASSERT_EQ(::pipe(ends_), 0); }

    int ends_[2] = {-1, -1};
};

std::string readAll(int descriptor) {
    std::string all, block(1 << 16, '\0');
    for (ssize_t n; (n = ::read(descriptor, block.data(), block.size())) > 0;) all.append(block, 0, size_t(n));
    return all;
}

TEST_F(StreamFileTest, NamedPipesWaitForTheirReader) {
    const std::string name = fifo();
    auto reader = std::async(std::launch::async, [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(150));
        return readFile(name);
    });
    writeFileAtomically(name, kPicture);
    EXPECT_EQ(reader.get(), kPicture);
    EXPECT_TRUE(std::filesystem::is_fifo(name));
}

TEST_F(StreamFileTest, AnInterruptEndsTheWaitForAReader) {
    const std::string name = fifo();
    auto interrupt = std::async(std::launch::async, [] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        interruptToken().cancel();
    });
    EXPECT_EQ(errorOf([&] { writeFileAtomically(name, "x"); }),
              "cannot write " + name + ": nobody reads from this pipe");
}

TEST_F(StreamFileTest, AnInterruptEndsTheWaitForAReaderThatStopped) {
    makePipe();
    interruptToken().cancel();
    const std::string name = given(ends_[1]);
    EXPECT_EQ(errorOf([&] { writeFileAtomically(name, kPicture); }),
              "cannot write " + name + ": nobody goes on reading");
}

TEST_F(StreamFileTest, AnInterruptedPictureReachesAReaderThatReads) {
    makePipe();
    interruptToken().cancel();
    auto reader = std::async(std::launch::async, [&] { return readAll(ends_[0]); });
    writeFileAtomically(procGiven(ends_[1]), kPicture);
    ::close(ends_[1]);
    ends_[1] = -1;
    EXPECT_EQ(reader.get(), kPicture);
}

TEST_F(StreamFileTest, GivenFilesAreGoneOnWith) {
    const int file = ::open(path("log").c_str(), O_WRONLY | O_CREAT, 0600);
    writeStream(file, "before ");
    writeFileAtomically(given(file), "picture");
    writeStream(file, " after");
    ::close(file);
    EXPECT_EQ(readFile(path("log")), "before picture after");
}

TEST_F(StreamFileTest, LinksToGivenDescriptorsAreFollowed) {
    makePipe();
    std::filesystem::create_symlink(given(ends_[1]), path("link"));
    writeFileAtomically(path("link"), "picture");
    char got[7] = {};
    EXPECT_EQ(::read(ends_[0], got, 7), 7);
    EXPECT_EQ(std::string(got, 7), "picture");
    EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
}

TEST_F(StreamFileTest, SocketsAreWritten) {
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends_), 0);
    writeFileAtomically(given(ends_[1]), "picture");
    char got[7] = {};
    EXPECT_EQ(::read(ends_[0], got, 7), 7);
}

TEST_F(StreamFileTest, DescriptorsThatCannotBeWrittenAreRefused) {
    makePipe();
    const std::string name = given(ends_[0]);
    EXPECT_EQ(errorOf([&] { writeFileAtomically(name, "x"); }),
              "cannot write " + name + ": it is open for reading only");
    EXPECT_EQ(errorOf([] { writeFileAtomically("/dev/fd/987654", "x"); }),
              "cannot write /dev/fd/987654: Bad file descriptor");
}

TEST_F(StreamFileTest, OnlyPathsToDescriptorsNameThem) {
    EXPECT_EQ(ownDescriptor("/dev/fd/1"), 1);
    EXPECT_EQ(ownDescriptor("/proc/self/fd/12"), 12);
    EXPECT_EQ(ownDescriptor(path("1")), -1);
    EXPECT_EQ(ownDescriptor("1"), -1);
    EXPECT_EQ(ownDescriptor("/dev/fd/x"), -1);
    EXPECT_EQ(ownDescriptor("/proc/1/fd/1"), -1);
}

}  // namespace
}  // namespace drc
