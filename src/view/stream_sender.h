// A connection by TCP or a Unix socket that is only written to, by a thread that must not be blocked: the caller
// decides how long to wait.
#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "base/error.h"

namespace drc {

struct StreamAddress {
    std::string host;  // a name, or an address of IPv4 or IPv6
    uint16_t port = 0;
    // Path of a Unix socket, which other users reach only if its folder's permissions let them; empty: the connection
    // is TCP.
    std::string path = {};
    // In the form that parseStreamAddress() reads.
    std::string text() const;
};

// "localhost:14158", "[::1]:14158" for addresses that have colons of their own, or "unix:/run/me/viewer". Throws Error
// on anything else.
StreamAddress parseStreamAddress(const std::string& text);

class StreamSender {
  public:
    using Clock = std::chrono::steady_clock;
    // Whether to go on waiting, given the time since anything happened. Called every 50 ms or more often.
    using Patience = std::function<bool(Clock::duration)>;
    // Thrown by send() when the patience returns false.
    struct GaveUp : Error {
        using Error::Error;
    };

    // Connects to the first of the host's addresses that answers. Throws Error, whose message is the reason alone, if
    // none does, or if the patience returns false before.
    StreamSender(const StreamAddress& address, const Patience& patience);
    ~StreamSender();
    StreamSender(const StreamSender&) = delete;
    StreamSender& operator=(const StreamSender&) = delete;

    // Hands all bytes to the system, which delivers them even after this object is gone. Throws Error, whose message is
    // the reason alone, if the connection is broken. After any exception, part of the bytes may have been sent, and the
    // connection is of no further use.
    void send(std::string_view bytes, const Patience& patience);
    // Whether the other side still has the connection open, as far as is known here. Drops all data that it has sent.
    bool isOpen();

  private:
    int socket_ = -1;
};

}  // namespace drc
