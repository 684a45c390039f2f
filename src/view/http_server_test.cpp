#include "view/http_server.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/streambuf.hpp>
#include <boost/asio/write.hpp>
#include <future>
#include <istream>
#include <thread>

#include "base/error.h"

namespace drc {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

TEST(PercentDecode, DecodesOrRefuses) {
    std::string text;
    EXPECT_TRUE(percentDecode("a%20b%2Fc%2f+", false, text));
    EXPECT_EQ(text, "a b/c/+");
    EXPECT_TRUE(percentDecode("a+b", true, text));
    EXPECT_EQ(text, "a b");
    EXPECT_TRUE(percentDecode("", true, text));
    EXPECT_EQ(text, "");
    for (const char* wrong : {"%", "%2", "%zz", "a%0", "%00", "%-1"})
        EXPECT_FALSE(percentDecode(wrong, false, text)) << wrong;
    EXPECT_FALSE(percentDecode(std::string_view("a\0b", 3), false, text));
}

TEST(ParseTarget, SplitsPathAndQuery) {
    HttpRequest request;
    ASSERT_TRUE(parseTarget("/a%20b/frame?layer=x%26y&&n=1&flag&e=", request));
    EXPECT_EQ(request.path, "/a b/frame");
    EXPECT_EQ(request.parameter("layer"), "x&y");
    EXPECT_EQ(request.parameter("n"), "1");
    EXPECT_EQ(request.parameter("flag"), "");
    EXPECT_EQ(request.parameter("nothing"), "");
    EXPECT_EQ(request.query.size(), 4u);
    for (const std::string& wrong : {std::string(""), std::string("a"), std::string("*"), std::string("/%"),
                                     std::string("/?a=%1"), "/" + std::string(5000, 'a')}) {
        HttpRequest other;
        EXPECT_FALSE(parseTarget(wrong, other)) << wrong;
    }
}

// A client that writes bytes and reads what comes.
class Client {
  public:
    // receives: bytes that its system takes for it before it reads them; 0: as many as usual.
    explicit Client(uint16_t port, int receives = 0, const std::string& address = "127.0.0.1") : socket_(context_) {
        const tcp::endpoint end(asio::ip::make_address(address), port);
        socket_.open(end.protocol());
        if (receives > 0) socket_.set_option(asio::socket_base::receive_buffer_size(receives));
        socket_.connect(end);
    }
    void send(const std::string& text) { asio::write(socket_, asio::buffer(text)); }
    // Up to and with `end`.
    std::string readUntil(const std::string& end) {
        const size_t size = asio::read_until(socket_, asio::dynamic_buffer(received_), end);
        std::string text = received_.substr(0, size);
        received_.erase(0, size);
        return text;
    }
    std::string read(size_t size) {
        if (received_.size() < size)
            asio::read(socket_, asio::dynamic_buffer(received_), asio::transfer_at_least(size - received_.size()));
        std::string text = received_.substr(0, size);
        received_.erase(0, size);
        return text;
    }
    // Until the server closes the connection.
    std::string readAll() {
        boost::system::error_code end;
        asio::read(socket_, asio::dynamic_buffer(received_), end);
        return received_;
    }

  private:
    asio::io_context context_;
    tcp::socket socket_;
    std::string received_;
};

std::string hostOf(const HttpServer& server) { return "Host: 127.0.0.1:" + std::to_string(server.port()) + "\r\n"; }

TEST(HttpServer, AnswersSeveralRequestsOfAConnection) {
    HttpServer server({}, [](const HttpRequest& request) {
        if (request.path == "/throw") throw Error("it went wrong");
        return HttpResponse{
            200, "text/plain", request.method + " " + request.path + " " + request.body, {{"X-A", "b"}}};
    });
    Client client(server.port());
    client.send("GET /one HTTP/1.1\r\n" + hostOf(server) + "\r\n");
    std::string head = client.readUntil("\r\n\r\n");
    EXPECT_THAT(head, testing::StartsWith("HTTP/1.1 200 OK\r\n"));
    EXPECT_THAT(head, testing::HasSubstr("X-A: b\r\n"));
    EXPECT_THAT(head, testing::HasSubstr("Content-Length: 9\r\n"));
    EXPECT_EQ(client.read(9), "GET /one ");
    // In pieces, and the next request at once.
    client.send("POST /two HTTP/1.1\r\n" + hostOf(server) + "Content-Le");
    client.send("ngth: 3\r\n\r\nab");
    client.send("cGET /throw HTTP/1.1\r\n" + hostOf(server) + "Connection: close\r\n\r\n");
    client.readUntil("\r\n\r\n");
    EXPECT_EQ(client.read(13), "POST /two abc");
    EXPECT_THAT(client.readAll(),
                testing::AllOf(testing::StartsWith("HTTP/1.1 500 "), testing::HasSubstr("it went wrong")));
}

TEST(HttpServer, RefusesOtherHostsAndOrigins) {
    HttpServer server({}, [](const HttpRequest&) { return HttpResponse{}; });
    const auto status = [&](const std::string& headers) {
        Client client(server.port());
        client.send("GET / HTTP/1.1\r\n" + headers + "Connection: close\r\n\r\n");
        return client.readAll().substr(9, 3);
    };
    const std::string port = std::to_string(server.port());
    EXPECT_EQ(status(hostOf(server)), "200");
    EXPECT_EQ(status("Host: localhost:" + port + "\r\n"), "200");
    EXPECT_EQ(status(""), "403");
    EXPECT_EQ(status("Host: 127.0.0.1\r\n"), "403");
    EXPECT_EQ(status("Host: example.org:" + port + "\r\n"), "403");
    EXPECT_EQ(status(hostOf(server) + "Origin: null\r\n"), "403");
    EXPECT_EQ(status(hostOf(server) + "Origin: http://example.org\r\n"), "403");
    EXPECT_EQ(status(hostOf(server) + "Origin: https://127.0.0.1:" + port + "\r\n"), "403");
    EXPECT_EQ(status(hostOf(server) + "Origin: http://127.0.0.1:" + port + "\r\n"), "200");
}

TEST(HttpServer, LimitsBodiesAndConnections) {
    HttpSettings settings;
    settings.mostBody = 1000;
    settings.mostConnections = 4;
    settings.idle = std::chrono::milliseconds(300);
    HttpServer server(settings, [](const HttpRequest& r) { return HttpResponse{200, "text/plain", r.body, {}}; });
    {
        Client client(server.port());
        client.send("POST / HTTP/1.1\r\n" + hostOf(server) + "Content-Length: 1001\r\n\r\n");
        EXPECT_THAT(client.readAll(), testing::StartsWith("HTTP/1.1 413"));
    }
    // More connections than are allowed: the oldest idle one makes room.
    std::vector<std::unique_ptr<Client>> clients;
    for (int i = 0; i < 8; ++i) clients.push_back(std::make_unique<Client>(server.port()));
    clients.back()->send("GET / HTTP/1.1\r\n" + hostOf(server) + "\r\n");
    EXPECT_THAT(clients.back()->readUntil("\r\n\r\n"), testing::StartsWith("HTTP/1.1 200"));
    EXPECT_LE(server.connections(), 4u);
    EXPECT_EQ(clients.front()->readAll(), "");
    // A connection without a whole request ends.
    Client slow(server.port());
    slow.send("GET / HT");
    EXPECT_EQ(slow.readAll(), "");
}

TEST(HttpServer, AnswersToTheAddressThatTheClientHasConnectedTo) {
    const auto status = [](const std::string& listen, const std::string& connect, const std::string& host) {
        HttpSettings settings;
        settings.address = listen;
        HttpServer server(settings, [](const HttpRequest&) { return HttpResponse{}; });
        Client client(server.port(), 0, connect);
        client.send("GET / HTTP/1.1\r\nHost: " + host + ":" + std::to_string(server.port()) +
                    "\r\nConnection: close\r\n\r\n");
        return client.readAll().substr(9, 3);
    };
    EXPECT_EQ(status("0.0.0.0", "127.0.0.2", "127.0.0.2"), "200");
    EXPECT_EQ(status("0.0.0.0", "127.0.0.2", "127.0.0.3"), "403");
    EXPECT_EQ(status("0.0.0.0", "127.0.0.2", "example.org"), "403");
    try {
        EXPECT_EQ(status("::1", "::1", "[::1]"), "200");
        EXPECT_EQ(status("::1", "::1", "[::2]"), "403");
        EXPECT_EQ(status("::", "127.0.0.2", "127.0.0.2"), "200");
    } catch (const std::exception& noV6) {
        GTEST_SKIP() << "there is no IPv6: " << noV6.what();
    }
}

// Whoever may not ask is told so before anything of the body is read or kept.
TEST(HttpServer, AdmitsByTheHeader) {
    HttpSettings settings;
    settings.admit = [](const HttpRequest& header) {
        if (header.path != "/known") return HttpAdmission{0, HttpResponse{403, "text/plain", "who?", {}}};
        return HttpAdmission{10, {}};
    };
    HttpServer server(settings, [](const HttpRequest& r) { return HttpResponse{200, "text/plain", r.body, {}}; });
    const auto answer = [&](const std::string& path, const std::string& rest) {
        Client client(server.port());
        client.send("POST " + path + " HTTP/1.1\r\n" + hostOf(server) + rest);
        return client.readAll();
    };
    EXPECT_THAT(answer("/other", "Content-Length: 1000000\r\n\r\n"),
                testing::AllOf(testing::StartsWith("HTTP/1.1 403"), testing::EndsWith("who?")));
    EXPECT_THAT(answer("/known", "Content-Length: 11\r\n\r\n"), testing::StartsWith("HTTP/1.1 413"));
    EXPECT_THAT(answer("/known", "Transfer-Encoding: chunked\r\n\r\nb\r\n0123456789a\r\n0\r\n\r\n"),
                testing::StartsWith("HTTP/1.1 413"));
    EXPECT_THAT(answer("/known", "Connection: close\r\nContent-Length: 10\r\n\r\n0123456789"),
                testing::AllOf(testing::StartsWith("HTTP/1.1 200"), testing::EndsWith("0123456789")));
}

TEST(HttpServer, ConnectionsThatNeverEndTheirBodiesMakeRoom) {
    HttpSettings settings;
    settings.mostConnections = 4;
    HttpServer server(settings, [](const HttpRequest&) { return HttpResponse{}; });
    std::vector<std::unique_ptr<Client>> clients;
    for (int i = 0; i < 4; ++i) {
        clients.push_back(std::make_unique<Client>(server.port()));
        clients.back()->send("POST / HTTP/1.1\r\n" + hostOf(server) + "Content-Length: 1000\r\n\r\nabc");
    }
    while (server.connections() < 4) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));  // until their headers are read
    Client other(server.port());
    other.send("GET / HTTP/1.1\r\n" + hostOf(server) + "Connection: close\r\n\r\n");
    EXPECT_THAT(other.readAll(), testing::StartsWith("HTTP/1.1 200"));
}

// Without a file descriptor for it, accepting fails at once, again and again.
TEST(HttpServer, WaitsForFileDescriptors) {
    HttpServer server({}, [](const HttpRequest&) { return HttpResponse{}; });
    std::vector<int> files;
    asio::io_context context;
    tcp::socket socket(context, tcp::v4());
    for (int file; (file = open("/dev/null", O_RDONLY)) >= 0;) files.push_back(file);
    const auto cpuSeconds = [] {
        timespec now{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
        return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
    };
    const double before = cpuSeconds();
    socket.connect(tcp::endpoint(asio::ip::make_address("127.0.0.1"), server.port()));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_LT(cpuSeconds() - before, 0.1);
    for (const int file : files) close(file);
    asio::write(socket, asio::buffer("GET / HTTP/1.1\r\n" + hostOf(server) + "Connection: close\r\n\r\n"));
    std::string answer;
    boost::system::error_code end;
    asio::read(socket, asio::dynamic_buffer(answer), end);
    EXPECT_THAT(answer, testing::StartsWith("HTTP/1.1 200"));
}

// A deadline of 400 ms, and peers that take three times as long for all of it: progress is what counts.
struct SlowLink {
    static constexpr size_t kPieces = 24, kPiece = 2000;
    static HttpSettings settings() {
        HttpSettings s;
        s.idle = std::chrono::seconds(20);
        s.stalled = std::chrono::milliseconds(400);
        s.leastProgress = kPiece;
        return s;
    }
    HttpServer server{settings(), [](const HttpRequest& request) {
                          if (request.method == "GET")
                              return HttpResponse{200, "text/plain", std::string(8 << 20, 'a'), {}};
                          return HttpResponse{200, "text/plain", std::to_string(request.body.size()), {}};
                      }};
    std::string post(size_t size) const {
        return "POST / HTTP/1.1\r\n" + hostOf(server) + "Connection: close\r\nContent-Length: " + std::to_string(size) +
               "\r\n\r\n";
    }
    static void wait() { std::this_thread::sleep_for(std::chrono::milliseconds(50)); }
};

TEST(HttpServer, TakesBodiesFromSlowLinks) {
    SlowLink link;
    Client client(link.server.port());
    client.send(link.post(SlowLink::kPieces * SlowLink::kPiece));
    for (size_t i = 0; i < SlowLink::kPieces; ++i) {
        SlowLink::wait();
        client.send(std::string(SlowLink::kPiece, 'b'));
    }
    EXPECT_THAT(client.readAll(), testing::EndsWith("\r\n\r\n48000"));
}

TEST(HttpServer, SendsBodiesOverSlowLinks) {
    SlowLink link;
    Client client(link.server.port(), 64 << 10);
    client.send("GET / HTTP/1.1\r\n" + hostOf(link.server) + "Connection: close\r\n\r\n");
    client.readUntil("\r\n\r\n");
    constexpr size_t kPart = 8 << 20 >> 5;
    for (int i = 0; i < 32; ++i) {
        SlowLink::wait();
        EXPECT_EQ(client.read(kPart), std::string(kPart, 'a'));
    }
    EXPECT_EQ(client.readAll(), "");
}

// Whoever stops, or gives a few bytes at a time for ever, is cut.
TEST(HttpServer, CutsPeersThatStall) {
    SlowLink link;
    const auto start = std::chrono::steady_clock::now();
    Client halfway(link.server.port()), deaf(link.server.port(), 64 << 10), drip(link.server.port());
    halfway.send(link.post(10'000) + std::string(5000, 'b'));
    deaf.send("GET / HTTP/1.1\r\n" + hostOf(link.server) + "\r\n");
    drip.send(link.post(10'000));
    std::thread dripping([&] {
        try {
            for (int i = 0; i < 400; ++i) {
                SlowLink::wait();
                drip.send("b");
            }
        } catch (const boost::system::system_error&) {
        }
    });
    EXPECT_EQ(halfway.readAll(), "");
    while (link.server.connections() > 0 && std::chrono::steady_clock::now() - start < std::chrono::seconds(15))
        SlowLink::wait();
    EXPECT_EQ(link.server.connections(), 0u);
    dripping.join();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(15));
}

TEST(HttpServer, SendsEvents) {
    HttpServer server({}, [](const HttpRequest&) {
        HttpResponse response;
        response.events = true;
        return response;
    });
    Client one(server.port()), two(server.port());
    for (Client* client : {&one, &two}) {
        client->send("GET /events HTTP/1.1\r\n" + hostOf(server) + "\r\n");
        EXPECT_THAT(client->readUntil("\r\n\r\n"), testing::HasSubstr("text/event-stream"));
    }
    // A stream listens from the moment when its header has been written, which the client may see a little earlier.
    std::thread sender([&] {
        for (int i = 0; i < 50; ++i) {
            server.send("frame", "{\"number\":1}");
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    });
    for (Client* client : {&one, &two}) EXPECT_EQ(client->readUntil("\n\n"), "event: frame\ndata: {\"number\":1}\n\n");
    sender.join();
}

// It ends while handlers run and clients wait, and again and again.
TEST(HttpServer, EndsAtAnyMoment) {
    for (int i = 0; i < 20; ++i) {
        std::promise<void> begun;
        std::unique_ptr<Client> client;
        {
            HttpServer server({}, [&](const HttpRequest&) {
                begun.set_value();
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                return HttpResponse{};
            });
            client = std::make_unique<Client>(server.port());
            client->send("GET / HTTP/1.1\r\n" + hostOf(server) + "\r\n");
            begun.get_future().wait();
        }
        client->readAll();
    }
}

TEST(HttpServer, SaysWhyItCannotListen) {
    HttpServer server({}, [](const HttpRequest&) { return HttpResponse{}; });
    HttpSettings settings;
    settings.address = "203.0.113.1";  // of no machine
    const auto error = [&] {
        try {
            HttpServer other(settings, [](const HttpRequest&) { return HttpResponse{}; });
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_THAT(error(), testing::StartsWith("cannot listen on 203.0.113.1:0: "));
    settings.address = "nonsense";
    EXPECT_THAT(error(), testing::StartsWith("cannot listen on nonsense:0: "));
}

}  // namespace
}  // namespace drc
