#include "view/stream_sender.h"

#include <fmt/core.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <future>
#include <memory>
#include <system_error>
#include <thread>

namespace drc {
namespace {

constexpr std::chrono::milliseconds kTick{50};

using AddressList = std::shared_ptr<const addrinfo>;

std::string reason(int error) { return std::generic_category().message(error); }

AddressList lookUp(const StreamAddress& address) {
    addrinfo hints{}, *list = nullptr;
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    const int error = getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &list);
    if (error != 0) throw Error(error == EAI_SYSTEM ? reason(errno) : gai_strerror(error));
    return {list, [](const addrinfo* l) { freeaddrinfo(const_cast<addrinfo*>(l)); }};
}

// The system cannot be told to give up, and may ask name servers for many seconds, so the look-up runs on a detached
// thread.
AddressList lookUp(const StreamAddress& address, const StreamSender::Patience& patience) {
    std::packaged_task<AddressList()> task([address] { return lookUp(address); });
    std::future<AddressList> found = task.get_future();
    std::thread(std::move(task)).detach();
    const auto start = StreamSender::Clock::now();
    while (found.wait_for(kTick) != std::future_status::ready)
        if (!patience(StreamSender::Clock::now() - start)) throw Error("its name is not found in time");
    return found.get();
}

// Waits, for a tick at most, until the socket accepts bytes or has failed.
bool isReady(int socket) {
    pollfd waiting{socket, POLLOUT, 0};
    return poll(&waiting, 1, int(kTick.count())) > 0;
}

// Connects a socket that does not block. Returns 0, or the errno of the failure.
int connectTo(int socket, const addrinfo& to, const StreamSender::Patience& patience) {
    if (connect(socket, to.ai_addr, to.ai_addrlen) == 0) return 0;
    if (errno != EINPROGRESS && errno != EINTR) return errno;
    const auto start = StreamSender::Clock::now();
    while (!isReady(socket))
        if (!patience(StreamSender::Clock::now() - start)) return ETIMEDOUT;
    int error = 0;
    socklen_t size = sizeof error;
    return getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

}  // namespace

std::string StreamAddress::text() const {
    if (!path.empty()) return "unix:" + path;
    const bool hasColons = host.find(':') != std::string::npos;
    return hasColons ? fmt::format("[{}]:{}", host, port) : fmt::format("{}:{}", host, port);
}

StreamAddress parseStreamAddress(const std::string& text) {
    StreamAddress address;
    constexpr std::string_view kUnix = "unix:";
    if (text.starts_with(kUnix)) {
        address.path = text.substr(kUnix.size());
        const size_t most = sizeof(sockaddr_un::sun_path) - 1;
        if (address.path.empty() || address.path.size() > most)
            throw Error(fmt::format("'{}' is not unix:PATH with a path of 1 to {} bytes", text, most));
        return address;
    }
    const size_t colon = text.rfind(':');
    if (colon != std::string::npos) {
        address.host = text.substr(0, colon);
        const char *begin = text.c_str() + colon + 1, *end = text.c_str() + text.size();
        const auto [stop, error] = std::from_chars(begin, end, address.port);
        if (stop != end || error != std::errc()) address.port = 0;
    }
    const bool inBrackets = address.host.size() >= 2 && address.host.front() == '[' && address.host.back() == ']';
    if (inBrackets) address.host = address.host.substr(1, address.host.size() - 2);
    if (address.port == 0 || address.host.empty() || (!inBrackets && address.host.find(':') != std::string::npos))
        throw Error("'" + text + "' is neither HOST:PORT, as localhost:14158, nor unix:PATH");
    return address;
}

StreamSender::StreamSender(const StreamAddress& address, const Patience& patience) {
    int error = EADDRNOTAVAIL;
    const auto tryTo = [&](const addrinfo& to) {
        socket_ = socket(to.ai_family, to.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, to.ai_protocol);
        error = socket_ < 0 ? errno : connectTo(socket_, to, patience);
        if (error != 0 && socket_ >= 0) close(socket_);
        return error == 0;
    };
    if (!address.path.empty()) {
        sockaddr_un place{};
        place.sun_family = AF_UNIX;
        address.path.copy(place.sun_path, sizeof place.sun_path - 1);
        addrinfo to{};
        to.ai_family = AF_UNIX;
        to.ai_socktype = SOCK_STREAM;
        to.ai_addr = reinterpret_cast<sockaddr*>(&place);
        to.ai_addrlen = sizeof place;
        if (tryTo(to)) return;
        throw Error(reason(error));
    }
    const AddressList addresses = lookUp(address, patience);
    for (const addrinfo* to = addresses.get(); to != nullptr; to = to->ai_next)
        if (tryTo(*to)) return;
    throw Error(reason(error));
}

StreamSender::~StreamSender() { close(socket_); }

void StreamSender::send(std::string_view bytes, const Patience& patience) {
    auto lastSent = Clock::now();
    while (!bytes.empty()) {
        // MSG_NOSIGNAL: a closed connection gives an error, not a signal.
        const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent >= 0) {
            bytes.remove_prefix(size_t(sent));
            lastSent = Clock::now();
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            if (!isReady(socket_) && !patience(Clock::now() - lastSent)) throw GaveUp("it does not read");
        } else if (errno != EINTR) {
            throw Error(reason(errno));
        }
    }
}

bool StreamSender::isOpen() {
    std::array<char, 4096> dropped;
    for (;;) {
        const ssize_t received = recv(socket_, dropped.data(), dropped.size(), MSG_DONTWAIT);
        if (received == 0) return false;
        if (received < 0 && errno != EINTR) return errno == EAGAIN || errno == EWOULDBLOCK;
    }
}

}  // namespace drc
