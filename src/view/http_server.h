// A small HTTP server for one program's own pages: every request is answered by a handler, and clients may listen to
// events. Not for the open internet: no TLS, no compression, no files.
#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drc {

struct HttpRequest {
    std::string method;  // "GET" or "POST"; others are refused before
    std::string path;    // of the target, without the query, percent-decoded
    std::vector<std::pair<std::string, std::string>> query;
    std::string body;

    // The value of a query parameter; empty if there is none.
    std::string_view parameter(std::string_view name) const;
};

struct HttpResponse {
    int status = 200;
    std::string type = "text/plain; charset=utf-8";
    std::string body;
    std::vector<std::pair<std::string, std::string>> headers;  // further ones
    bool events = false;  // the connection becomes a stream of server-sent events: see HttpServer::send
};

// Whether a request is read any further.
struct HttpAdmission {
    size_t mostBody = 0;                  // bytes that its body may have
    std::optional<HttpResponse> refusal;  // the answer if it is not
};

struct HttpSettings {
    std::string address = "127.0.0.1";
    uint16_t port = 0;  // 0: any that is free
    // Requests are answered only if their Host header is one of these names, or the address that the client has
    // connected to, with the port: a page of another site that has made its name point here (DNS rebinding) is refused.
    std::vector<std::string> hosts{"127.0.0.1", "localhost"};
    // Asked when the header of a request is there, before its body is read, on the thread that serves all connections.
    // None: all are admitted.
    std::function<HttpAdmission(const HttpRequest& header)> admit;
    size_t mostBody = 64 << 20;  // bytes
    // More make the server close the one that has been idle longest or, if none is, that has sent a body for longest.
    size_t mostConnections = 128;
    size_t mostEventStreams = 32;            // more are refused
    std::chrono::milliseconds idle{10'000};  // until a connection whose request's header is not complete is closed
    // Until a connection is closed that has taken or given less than `leastProgress` bytes of a body, or less than the
    // rest of it. As a whole a transfer may take as long as it needs.
    std::chrono::milliseconds stalled{20'000};
    size_t leastProgress = 4 << 10;
};

class HttpServer {
  public:
    // Called on threads of the server's own, several at a time. What it throws becomes a response of status 500.
    using Handler = std::function<HttpResponse(const HttpRequest&)>;

    // Listens, and serves until it is destroyed. Throws Error if the address cannot be listened to.
    HttpServer(const HttpSettings& settings, Handler handler);
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    uint16_t port() const;
    // Sends an event to all streams. A client that has not taken the previous ones gets only the latest.
    void send(const std::string& event, const std::string& data);
    size_t connections() const;

  private:
    struct Impl;
    std::shared_ptr<Impl> impl_;
};

// Splits the target of a request into path and query. False if it is malformed, or longer than any of the page's.
bool parseTarget(std::string_view target, HttpRequest& request);

// "a%20b" as "a b"; `plus`: also "+" as a space. False if it is malformed or has a zero byte.
bool percentDecode(std::string_view text, bool plus, std::string& decoded);

}  // namespace drc
