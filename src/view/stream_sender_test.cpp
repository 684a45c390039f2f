#include "view/stream_sender.h"

#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "base/folder_testing.h"
#include "view/tev_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;
using Clock = StreamSender::Clock;

bool forever(Clock::duration) { return true; }

TEST(StreamAddress, IsHostAndPort) {
    const auto parts = [](const std::string& text) {
        const StreamAddress address = parseStreamAddress(text);
        EXPECT_EQ(address.text(), text);
        return std::pair(address.host, int(address.port));
    };
    EXPECT_EQ(parts("localhost:14158"), std::pair(std::string("localhost"), 14158));
    EXPECT_EQ(parts("10.0.0.7:1"), std::pair(std::string("10.0.0.7"), 1));
    EXPECT_EQ(parts("[fe80::1]:65535"), std::pair(std::string("fe80::1"), 65535));
    for (const char* wrong : {"", ":", "localhost", "localhost:", ":14158", "localhost:0", "localhost:65536", "a:-1",
                              "a:+1", "a: 1", "a:1 ", "a:0x10", "::1:14158", "[]:1", "[::1]", "http://a:1"})
        EXPECT_THAT(errorOf([&] { parseStreamAddress(wrong); }), HasSubstr("HOST:PORT")) << wrong;
}

TEST(StreamAddress, OrIsAUnixSocket) {
    const StreamAddress address = parseStreamAddress("unix:/tmp/a b:1");
    EXPECT_EQ(address.path, "/tmp/a b:1");
    EXPECT_EQ(address.text(), "unix:/tmp/a b:1");
    for (const std::string& wrong : {std::string("unix:"), "unix:/" + std::string(107, 'x')})
        EXPECT_THAT(errorOf([&] { parseStreamAddress(wrong); }), HasSubstr("a path of 1 to 107 bytes")) << wrong;
}

TEST(StreamSender, SendsToAUnixSocket) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/viewer";
    EXPECT_EQ(errorOf([&] { StreamSender({"", 0, path}, forever); }), "No such file or directory");
    const int listener = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un place{};
    place.sun_family = AF_UNIX;
    path.copy(place.sun_path, sizeof place.sun_path - 1);
    ASSERT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&place), sizeof place), 0);
    ASSERT_EQ(listen(listener, 1), 0);
    {
        StreamSender sender({"", 0, path}, forever);
        sender.send("picture", forever);
        EXPECT_TRUE(sender.isOpen());
    }
    const int connection = accept(listener, nullptr, nullptr);
    char received[16] = {};
    EXPECT_EQ(read(connection, received, sizeof received), 7);
    EXPECT_STREQ(received, "picture");
    close(connection);
    close(listener);
}

TEST(StreamSender, SaysWhyThereIsNoConnection) {
    uint16_t port = 0;
    { port = test::FakeTev().port(); }
    EXPECT_EQ(errorOf([&] { StreamSender({"127.0.0.1", port}, forever); }), "Connection refused");
    EXPECT_NE(errorOf([&] { StreamSender({"no such host", 1}, forever); }), "");
}

TEST(StreamSender, NoticesThatTheOtherSideIsGone) {
    auto viewer = std::make_unique<test::FakeTev>();
    StreamSender sender({"127.0.0.1", viewer->port()}, forever);
    EXPECT_TRUE(sender.isOpen());
    while (viewer->connections() == 0) std::this_thread::yield();
    viewer.reset();
    EXPECT_FALSE(sender.isOpen());
    // More than the system takes before the other side has said that nobody is there. Not a signal, which would end the
    // program.
    EXPECT_THROW(for (int i = 0; i < 100; ++i) sender.send(std::string(1 << 20, 'x'), forever), Error);
}

TEST(StreamSender, WaitsNoLongerThanItMay) {
    test::FakeTev viewer;
    viewer.read(false);
    StreamSender sender({"127.0.0.1", viewer.port()}, forever);
    Clock::duration waited{};
    const auto start = Clock::now();
    EXPECT_THROW(sender.send(std::string(64 << 20, 'x'),
                             [&](Clock::duration idle) {
                                 waited = idle;
                                 return idle < std::chrono::milliseconds(200);
                             }),
                 StreamSender::GaveUp);
    EXPECT_GE(waited, std::chrono::milliseconds(200));
    EXPECT_LT(Clock::now() - start, std::chrono::seconds(10));
}

}  // namespace
}  // namespace drc
