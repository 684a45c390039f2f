// A connection by TCP or a Unix socket that is only written to, by a thread that must not be held up: whoever waits
// says for how long.
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
    // A Unix socket, which other users of the machine reach only if its folder lets them; empty: the connection is TCP.
    std::string path = {};
    // As parseStreamAddress() reads it.
    std::string text() const;
};

// "localhost:14158", "[::1]:14158" for addresses that have colons of their own, or "unix:/run/me/viewer". Throws Error
// on anything else.
StreamAddress parseStreamAddress(const std::string& text);

class StreamSender {
  public:
    using Clock = std::chrono::steady_clock;
    // Whether to go on waiting, given for how long nothing has happened. Asked every 50 ms or more often.
    using Patience = std::function<bool(Clock::duration)>;
    // Thrown by send() when the patience is at an end.
    struct GaveUp : Error {
        using Error::Error;
    };

    // Connects to the first address of the host's that answers. Throws Error, with the reason alone, if none does, or
    // if the patience is at an end before.
    StreamSender(const StreamAddress& address, const Patience& patience);
    ~StreamSender();
    StreamSender(const StreamSender&) = delete;
    StreamSender& operator=(const StreamSender&) = delete;

    // Hands all bytes to the system, which delivers them even after this object is gone. Throws Error, with the reason
    // alone, if the connection is broken. After any exception a part may have been sent: nothing more makes sense.
    void send(std::string_view bytes, const Patience& patience);
    // Whether the other side has it open, as far as is known here. What the other side sends is dropped.
    bool isOpen();

  private:
    int socket_ = -1;
};

}  // namespace drc
