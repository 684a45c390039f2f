#include "view/tcp_sender.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"
#include "view/tev_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;
using Clock = TcpSender::Clock;

bool forever(Clock::duration) { return true; }

TEST(TcpAddress, IsHostAndPort) {
    const auto parts = [](const std::string& text) {
        const TcpAddress address = parseTcpAddress(text);
        return std::pair(address.host, int(address.port));
    };
    EXPECT_EQ(parts("localhost:14158"), std::pair(std::string("localhost"), 14158));
    EXPECT_EQ(parts("10.0.0.7:1"), std::pair(std::string("10.0.0.7"), 1));
    EXPECT_EQ(parts("[fe80::1]:65535"), std::pair(std::string("fe80::1"), 65535));
    for (const char* wrong : {"", ":", "localhost", "localhost:", ":14158", "localhost:0", "localhost:65536", "a:-1",
                              "a:+1", "a: 1", "a:1 ", "a:0x10", "::1:14158", "[]:1", "[::1]", "http://a:1"})
        EXPECT_THAT(errorOf([&] { parseTcpAddress(wrong); }), HasSubstr("HOST:PORT")) << wrong;
}

TEST(TcpSender, SaysWhyThereIsNoConnection) {
    uint16_t port = 0;
    { port = test::FakeTev().port(); }
    EXPECT_EQ(errorOf([&] { TcpSender({"127.0.0.1", port}, forever); }), "Connection refused");
    EXPECT_NE(errorOf([&] { TcpSender({"no such host", 1}, forever); }), "");
}

TEST(TcpSender, NoticesThatTheOtherSideIsGone) {
    auto viewer = std::make_unique<test::FakeTev>();
    TcpSender sender({"127.0.0.1", viewer->port()}, forever);
    EXPECT_TRUE(sender.isOpen());
    while (viewer->connections() == 0) std::this_thread::yield();
    viewer.reset();
    EXPECT_FALSE(sender.isOpen());
    // More than the system takes before the other side has said that nobody is there. Not a signal, which would end the
    // program.
    EXPECT_THROW(for (int i = 0; i < 100; ++i) sender.send(std::string(1 << 20, 'x'), forever), Error);
}

TEST(TcpSender, WaitsNoLongerThanItMay) {
    test::FakeTev viewer;
    viewer.read(false);
    TcpSender sender({"127.0.0.1", viewer.port()}, forever);
    Clock::duration waited{};
    const auto start = Clock::now();
    EXPECT_THROW(sender.send(std::string(64 << 20, 'x'),
                             [&](Clock::duration idle) {
                                 waited = idle;
                                 return idle < std::chrono::milliseconds(200);
                             }),
                 TcpSender::GaveUp);
    EXPECT_GE(waited, std::chrono::milliseconds(200));
    EXPECT_LT(Clock::now() - start, std::chrono::seconds(10));
}

}  // namespace
}  // namespace drc
