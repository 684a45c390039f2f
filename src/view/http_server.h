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
    std::string method;  // "GET" or "POST"; requests of other methods are refused earlier
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
    std::vector<std::pair<std::string, std::string>> headers;  // further headers
    bool events = false;  // the connection becomes a stream of server-sent events: see HttpServer::send
};

// The decision about a request after its header has been read.
struct HttpAdmission {
    size_t mostBody = 0;                  // greatest size of the request's body, bytes
    std::optional<HttpResponse> refusal;  // the answer if the request is refused
};

struct HttpSettings {
    std::string address = "127.0.0.1";
    uint16_t port = 0;  // 0: any that is free
    // Requests are answered only if their Host header is one of these names, or the address that the client has
    // connected to, with the port. This refuses pages of other sites whose name has been made to point here (DNS
    // rebinding).
    std::vector<std::string> hosts{"127.0.0.1", "localhost"};
    // Called after the header of a request, before its body is read, on the thread that serves all connections. Empty:
    // all requests are admitted.
    std::function<HttpAdmission(const HttpRequest& header)> admit;
    size_t mostBody = 64 << 20;  // bytes
    // For one more, the server closes the connection that has been idle longest or, if none is idle, the one that has
    // been sending a body for longest.
    size_t mostConnections = 128;
    size_t mostEventStreams = 32;            // further ones are refused
    std::chrono::milliseconds idle{10'000};  // time limit for the header of a request
    // Time limit for every `leastProgress` bytes of a body that is sent or received, and for the rest of it. The whole
    // transfer may take as long as it needs.
    std::chrono::milliseconds stalled{20'000};
    size_t leastProgress = 4 << 10;
};

class HttpServer {
  public:
    // Called on the server's own threads, several at a time. Exceptions become responses of status 500.
    using Handler = std::function<HttpResponse(const HttpRequest&)>;

    // Serves until it is destroyed. Throws Error if it cannot listen on the address.
    HttpServer(const HttpSettings& settings, Handler handler);
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    uint16_t port() const;
    // Sends an event to all streams. A client that has not yet received earlier events gets only the latest.
    void send(const std::string& event, const std::string& data);
    size_t connections() const;

  private:
    struct Impl;
    std::shared_ptr<Impl> impl_;
};

// Splits the target of a request into path and query. False if it is malformed or too long.
bool parseTarget(std::string_view target, HttpRequest& request);

// Decodes "a%20b" to "a b"; `plus`: also "+" to a space. False if the text is malformed or contains a zero byte.
bool percentDecode(std::string_view text, bool plus, std::string& decoded);

}  // namespace drc
