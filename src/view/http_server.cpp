#include "view/http_server.h"

#include <fmt/core.h>
#include <netinet/tcp.h>

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <list>
#include <mutex>
#include <thread>

#include "base/error.h"
#include "base/log.h"

namespace drc {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;

constexpr size_t kMostHeader = 16 << 10;
// Longer targets are refused: no request of the page needs them.
constexpr size_t kMostTarget = 2048;
// Threads that answer requests. A picture takes a few milliseconds to encode.
constexpr int kHandlers = 2;
// Bound on the unsent bytes of a connection in the system's buffers. With megabytes there, it would take minutes to
// find out whether a slow client reads at all.
constexpr int kMostUnsent = 128 << 10;
// Streams of events that have nothing else to send get a line this often, which finds out that a client has gone.
constexpr std::chrono::seconds kHeartbeat{5};
// Time until the next attempt to accept a connection, after there was no file descriptor for one.
constexpr std::chrono::milliseconds kAcceptAgain{100};
constexpr uint16_t kDefaultPort = 80;

}  // namespace

bool parseTarget(std::string_view target, HttpRequest& request) {
    if (target.empty() || target.front() != '/' || target.size() > kMostTarget) return false;
    const size_t mark = target.find('?');
    if (!percentDecode(target.substr(0, mark), false, request.path)) return false;
    if (mark == std::string_view::npos) return true;
    std::string_view query = target.substr(mark + 1);
    while (!query.empty()) {
        const std::string_view pair = query.substr(0, query.find('&'));
        query.remove_prefix(std::min(query.size(), pair.size() + 1));
        if (pair.empty()) continue;
        const size_t equals = pair.find('=');
        std::string name, value;
        if (!percentDecode(pair.substr(0, equals), true, name)) return false;
        if (equals != std::string_view::npos && !percentDecode(pair.substr(equals + 1), true, value)) return false;
        request.query.emplace_back(std::move(name), std::move(value));
    }
    return true;
}

bool percentDecode(std::string_view text, bool plus, std::string& decoded) {
    const auto digit = [](char c) {
        if (c >= '0' && c <= '9') return c - '0';
        if (c >= 'a' && c <= 'f') return c - 'a' + 10;
        if (c >= 'A' && c <= 'F') return c - 'A' + 10;
        return -1;
    };
    decoded.clear();
    for (size_t i = 0; i < text.size(); ++i) {
        char c = text[i];
        if (c == '%') {
            if (i + 2 >= text.size()) return false;
            const int high = digit(text[i + 1]), low = digit(text[i + 2]);
            if (high < 0 || low < 0) return false;
            c = char(high * 16 + low);
            i += 2;
        } else if (c == '+' && plus) {
            c = ' ';
        }
        if (c == '\0') return false;
        decoded += c;
    }
    return true;
}

std::string_view HttpRequest::parameter(std::string_view name) const {
    for (const auto& [key, value] : query)
        if (key == name) return value;
    return {};
}

// One thread serves all connections; only handlers run on other threads.
struct HttpServer::Impl : std::enable_shared_from_this<HttpServer::Impl> {
    class Connection;

    Impl(const HttpSettings& s, Handler h) : settings(s), handler(std::move(h)), acceptor(context) {}

    void listen();
    void accept();
    void remove(const std::list<std::shared_ptr<Connection>>::iterator& at) { connections.erase(at); }
    // Makes room for one more connection.
    void closeIdlest();

    HttpSettings settings;
    Handler handler;
    asio::io_context context{1};
    tcp::acceptor acceptor;
    asio::steady_timer acceptTimer{context};
    asio::thread_pool handlers{kHandlers};
    std::list<std::shared_ptr<Connection>> connections;  // the one that has been idle longest comes first
    std::atomic<size_t> count{0};
    size_t streams = 0;
    uint16_t port = 0;
    std::thread thread;
};

class HttpServer::Impl::Connection : public std::enable_shared_from_this<Connection> {
  public:
    Connection(tcp::socket&& socket, Impl& server) : stream_(std::move(socket)), server_(server) {}

    void start(std::list<std::shared_ptr<Connection>>::iterator at) {
        at_ = at;
        read();
    }
    // Whether the connection waits for a request, or for an event.
    bool isIdle() const { return idle_; }
    // Whether the connection waits for the rest of a request.
    bool isReading() const { return reading_; }
    bool isStream() const { return isStream_; }
    void close() {
        if (closed_) return;
        closed_ = true;
        beast::error_code ignored;
        stream_.socket().shutdown(tcp::socket::shutdown_both, ignored);
        stream_.close();
        const auto self = shared_from_this();
        if (isStream_) --server_.streams;
        heartbeat_.cancel();
        --server_.count;
        server_.remove(at_);
    }

    void send(const std::string& text) {
        if (!isStream_ || closed_) return;
        next_ = text;
        writeEvent();
    }

  private:
    void read() {
        idle_ = true;
        parser_.emplace();
        parser_->header_limit(uint32_t(kMostHeader));
        parser_->body_limit(server_.settings.mostBody);
        stream_.expires_after(server_.settings.idle);
        http::async_read_header(
            stream_, buffer_, *parser_,
            [self = shared_from_this()](beast::error_code error, size_t) { self->headerRead(error); });
    }

    void headerRead(beast::error_code error) {
        if (error == http::error::end_of_stream || closed_) return close();
        if (error == beast::error::timeout || error == asio::error::operation_aborted) return close();
        if (error == http::error::body_limit) return refuse(413, "the request is too large");
        if (error) return refuse(400, "this is no HTTP request");
        idle_ = false;
        // These checks come before the body is read, so that clients that may not ask cannot send data.
        const auto& message = parser_->get();
        if (!hostAllowed(message[http::field::host])) return refuse(403, "this server does not answer to that name");
        if (const auto origin = message[http::field::origin]; !origin.empty() && !originAllowed(origin))
            return refuse(403, "this server does not answer to pages of other sites");
        if (message.method() != http::verb::get && message.method() != http::verb::post &&
            message.method() != http::verb::head)
            return refuse(405, "GET and POST are answered alone");
        request_ = {};
        request_.method = message.method() == http::verb::post ? "POST" : "GET";
        isHead_ = message.method() == http::verb::head;
        keepAlive_ = message.keep_alive();
        if (!parseTarget(message.target(), request_)) return refuse(400, "the request's target is malformed");
        if (server_.settings.admit) {
            HttpAdmission admission = server_.settings.admit(request_);
            if (admission.refusal) {
                keepAlive_ = false;
                return respond(std::move(*admission.refusal));
            }
            const size_t most = std::min(admission.mostBody, server_.settings.mostBody);
            if (parser_->content_length().value_or(0) > most) return refuse(413, "the request is too large");
            parser_->body_limit(most);
        }
        progress_ = 0;
        reading_ = true;
        stream_.expires_after(server_.settings.stalled);
        parser_->eager(true);
        readBody();
    }

    void readBody() {
        if (parser_->is_done()) return requestRead({});
        http::async_read_some(stream_, buffer_, *parser_,
                              [self = shared_from_this()](beast::error_code e, size_t bytes) {
                                  if (e || self->closed_) return self->requestRead(e);
                                  self->progressed(bytes);
                                  self->readBody();
                              });
    }

    // Extends the deadline only after enough bytes: a few at a time could hold a connection forever.
    void progressed(size_t bytes) {
        progress_ += bytes;
        if (progress_ < server_.settings.leastProgress) return;
        progress_ = 0;
        stream_.expires_after(server_.settings.stalled);
    }

    void requestRead(beast::error_code error) {
        reading_ = false;
        if (closed_) return;
        if (error == http::error::body_limit) return refuse(413, "the request is too large");
        if (error == beast::error::timeout) return close();
        if (error) return refuse(400, "the request is malformed or cut short");
        request_.body = std::move(parser_->get().body());
        stream_.expires_never();
        asio::post(server_.handlers, [self = shared_from_this(), request = std::move(request_)] {
            HttpResponse response;
            try {
                response = self->server_.handler(request);
            } catch (const std::exception& e) {
                response = {500, "text/plain; charset=utf-8", e.what(), {}};
            }
            asio::post(self->server_.context,
                       [self, response = std::move(response)]() mutable { self->respond(std::move(response)); });
        });
    }

    bool hostAllowed(std::string_view host) const {
        // Browsers leave out the default port, 80.
        const std::string port = ":" + std::to_string(server_.port);
        if (host.ends_with(port))
            host.remove_suffix(port.size());
        else if (server_.port != kDefaultPort)
            return false;
        return std::ranges::find(server_.settings.hosts, host) != server_.settings.hosts.end() || isOwnAddress(host);
    }
    // Whether `host` is the IP address that the client has connected to.
    bool isOwnAddress(std::string_view host) const {
        if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
        beast::error_code error;
        const asio::ip::address named = asio::ip::make_address(std::string(host), error);
        if (error) return false;
        const tcp::endpoint end = stream_.socket().local_endpoint(error);
        if (error) return false;
        // Sockets of IPv6 report addresses of IPv4 in mapped form.
        const asio::ip::address own = end.address();
        if (named == own) return true;
        return own.is_v6() && own.to_v6().is_v4_mapped() && named.is_v4() &&
               asio::ip::make_address_v4(asio::ip::v4_mapped, own.to_v6()) == named.to_v4();
    }
    bool originAllowed(std::string_view origin) const {
        constexpr std::string_view kScheme = "http://";
        return origin.starts_with(kScheme) && hostAllowed(origin.substr(kScheme.size()));
    }

    void refuse(int status, const std::string& why) {
        keepAlive_ = false;
        respond({status, "text/plain; charset=utf-8", why + "\n", {}});
    }

    void respond(HttpResponse&& response) {
        if (closed_) return;
        if (response.events) {
            if (server_.streams >= server_.settings.mostEventStreams)
                return refuse(503, "too many pages listen already");
            isStream_ = true;
            ++server_.streams;
        }
        auto& message = response_.emplace();
        message.version(11);
        message.result(unsigned(response.status));
        message.set(http::field::content_type, response.events ? "text/event-stream" : response.type);
        message.set(http::field::cache_control, "no-store");
        message.set("X-Content-Type-Options", "nosniff");
        message.set("Referrer-Policy", "no-referrer");
        message.set("Cross-Origin-Resource-Policy", "same-origin");
        for (const auto& [name, value] : response.headers) message.set(name, value);
        message.keep_alive(keepAlive_ && !isStream_);
        if (isStream_) {
            // The body has no length: it ends when the connection is closed.
            message.set(http::field::connection, "close");
            eventHeader_.emplace(message.base());
            eventSerializer_.emplace(*eventHeader_);
            stream_.expires_after(server_.settings.stalled);
            http::async_write_header(stream_, *eventSerializer_,
                                     [self = shared_from_this()](beast::error_code e, size_t) {
                                         if (e || self->closed_) return self->close();
                                         self->listening_ = true;
                                         self->idle_ = true;
                                         self->listenForEnd();
                                         self->beat();
                                         self->writeEvent();
                                     });
            return;
        }
        message.body() = isHead_ ? std::string() : std::move(response.body);
        message.prepare_payload();
        serializer_.emplace(message);
        progress_ = 0;
        stream_.expires_after(server_.settings.stalled);
        writeResponse();
    }

    void writeResponse() {
        http::async_write_some(stream_, *serializer_, [self = shared_from_this()](beast::error_code e, size_t bytes) {
            if (e || self->closed_) return self->close();
            if (!self->serializer_->is_done()) {
                self->progressed(bytes);
                return self->writeResponse();
            }
            self->serializer_.reset();
            if (!self->response_->keep_alive()) return self->close();
            self->response_.reset();
            // Moved to the end, as the one that has been idle for the shortest time.
            self->server_.connections.splice(self->server_.connections.end(), self->server_.connections, self->at_);
            self->read();
        });
    }

    // A client of a stream sends nothing; this read finds out that the client has gone.
    void listenForEnd() {
        stream_.expires_never();
        stream_.socket().async_read_some(asio::buffer(ignored_),
                                         [self = shared_from_this()](beast::error_code e, size_t) {
                                             if (e || self->closed_) return self->close();
                                             self->listenForEnd();
                                         });
    }
    void beat() {
        heartbeat_.expires_after(kHeartbeat);
        heartbeat_.async_wait([self = weak_from_this()](beast::error_code e) {
            const auto still = self.lock();
            if (e || !still || still->closed_) return;
            // A write that has been pending for this long will never complete.
            if (still->writing_ &&
                std::chrono::steady_clock::now() - still->writingSince_ > still->server_.settings.stalled)
                return still->close();
            if (still->next_.empty()) still->next_ = ":\n\n";
            still->writeEvent();
            still->beat();
        });
    }
    void writeEvent() {
        if (!listening_ || writing_ || next_.empty() || closed_) return;
        writing_ = true;
        writingSince_ = std::chrono::steady_clock::now();
        written_ = std::move(next_);
        next_.clear();
        asio::async_write(stream_.socket(), asio::buffer(written_),
                          [self = shared_from_this()](beast::error_code e, size_t) {
                              self->writing_ = false;
                              if (e) return self->close();
                              self->writeEvent();
                          });
    }

    beast::tcp_stream stream_;
    Impl& server_;
    std::list<std::shared_ptr<Connection>>::iterator at_;
    beast::flat_buffer buffer_{kMostHeader};
    std::optional<http::request_parser<http::string_body>> parser_;
    HttpRequest request_;
    std::optional<http::response<http::string_body>> response_;
    std::optional<http::response_serializer<http::string_body>> serializer_;
    std::optional<http::response<http::empty_body>> eventHeader_;
    std::optional<http::response_serializer<http::empty_body>> eventSerializer_;
    asio::steady_timer heartbeat_{stream_.get_executor()};
    std::array<char, 512> ignored_{};
    std::string next_, written_;
    std::chrono::steady_clock::time_point writingSince_{};
    size_t progress_ = 0;  // bytes of a body transferred since the deadline was set
    bool idle_ = true, reading_ = false, closed_ = false, keepAlive_ = false, isHead_ = false;
    bool isStream_ = false, listening_ = false, writing_ = false;
};

void HttpServer::Impl::listen() {
    try {
        const tcp::endpoint endpoint(asio::ip::make_address(settings.address), settings.port);
        acceptor.open(endpoint.protocol());
        acceptor.set_option(asio::socket_base::reuse_address(true));
        acceptor.bind(endpoint);
        acceptor.listen(asio::socket_base::max_listen_connections);
        port = acceptor.local_endpoint().port();
    } catch (const boost::system::system_error& error) {
        throw Error(fmt::format("cannot listen on {}:{}: {}", settings.address, settings.port, error.code().message()));
    }
    accept();
}

void HttpServer::Impl::accept() {
    acceptor.async_accept([self = shared_from_this()](beast::error_code error, tcp::socket socket) {
        if (error == asio::error::operation_aborted) return;
        if (error) {
            // Accepting at once would fail again.
            self->closeIdlest();
            self->acceptTimer.expires_after(kAcceptAgain);
            self->acceptTimer.async_wait([self](beast::error_code cancelled) {
                if (!cancelled) self->accept();
            });
            return;
        }
        {
            if (self->connections.size() >= self->settings.mostConnections) self->closeIdlest();
            if (self->connections.size() < self->settings.mostConnections) {
                beast::error_code ignored;
                socket.set_option(tcp::no_delay(true), ignored);
                ::setsockopt(socket.native_handle(), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &kMostUnsent, sizeof kMostUnsent);
                const auto connection = std::make_shared<Connection>(std::move(socket), *self);
                self->connections.push_back(connection);
                ++self->count;
                connection->start(std::prev(self->connections.end()));
            }
        }
        self->accept();
    });
}

void HttpServer::Impl::closeIdlest() {
    for (const auto& connection : connections)
        if (connection->isIdle() && !connection->isStream()) return connection->close();
    for (const auto& connection : connections)
        if (connection->isReading()) return connection->close();
}

HttpServer::HttpServer(const HttpSettings& settings, Handler handler)
    : impl_(std::make_shared<Impl>(settings, std::move(handler))) {
    impl_->listen();
    impl_->thread = std::thread([impl = impl_] {
        for (;;) {
            try {
                impl->context.run();
                return;
            } catch (const std::exception& error) {
                logDebug(std::string("the web server goes on after: ") + error.what());
            }
        }
    });
}

HttpServer::~HttpServer() {
    asio::post(impl_->context, [impl = impl_] {
        beast::error_code ignored;
        impl->acceptor.close(ignored);
        impl->acceptTimer.cancel();
        while (!impl->connections.empty()) impl->connections.front()->close();
        impl->context.stop();
    });
    impl_->thread.join();
    impl_->handlers.stop();
    impl_->handlers.join();
    // Run the responses that handlers have posted meanwhile: they hold connections, which refer to the server.
    impl_->context.restart();
    impl_->context.poll();
}

uint16_t HttpServer::port() const { return impl_->port; }
size_t HttpServer::connections() const { return impl_->count; }

void HttpServer::send(const std::string& event, const std::string& data) {
    asio::post(impl_->context, [impl = impl_, text = "event: " + event + "\ndata: " + data + "\n\n"] {
        const auto connections = impl->connections;
        for (const auto& connection : connections) connection->send(text);
    });
}

}  // namespace drc
