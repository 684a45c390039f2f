// A viewer for tests, which understands the packets that tev is sent. It decodes them by their fields, as tev does, not
// by what this program sends.
#pragma once
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace drc::test {

class FakeTev {
  public:
    struct Shown {
        int width = 0, height = 0;
        std::map<std::string, std::vector<float>> channels;  // width * height values each
        int updates = 0;
    };

    // Listens on this port of 127.0.0.1; 0: any that is free. hangUpAfter: breaks the first connection after so many
    // bytes.
    explicit FakeTev(uint16_t port = 0, size_t hangUpAfter = SIZE_MAX) : hangUpAfter_(hangUpAfter) {
        listener_ = socket(AF_INET, SOCK_STREAM, 0);
        const int on = 1;
        setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        if (bind(listener_, reinterpret_cast<sockaddr*>(&address), size) != 0 || listen(listener_, 4) != 0)
            ADD_FAILURE() << "cannot listen: " << std::strerror(errno);
        getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
        port_ = ntohs(address.sin_port);
        thread_ = std::thread([this] { serve(); });
    }
    ~FakeTev() {
        ending_ = true;
        thread_.join();
        close(listener_);
    }
    FakeTev(const FakeTev&) = delete;
    FakeTev& operator=(const FakeTev&) = delete;

    uint16_t port() const { return port_; }
    // Connections are accepted by the system even while nobody reads.
    void read(bool reads) { reads_ = reads; }
    // Waits until a connection has been closed by the other side, and all that it sent has been read.
    void awaitEnd() const {
        await([&] { return ended_ > 0; });
    }
    void awaitUpdates(int count) const {
        await([&] { return updates_ >= count; });
    }
    // The only image; it must be of this name.
    Shown image(const std::string& name) const {
        const std::lock_guard lock(mutex_);
        EXPECT_EQ(images_.size(), 1u);
        const auto found = images_.find(name);
        EXPECT_NE(found, images_.end()) << (images_.empty() ? "nothing" : images_.begin()->first);
        return found == images_.end() ? Shown{} : found->second;
    }
    int created() const { return created_; }
    int connections() const { return connections_; }

  private:
    class Fields {
      public:
        explicit Fields(std::string_view rest) : rest_(rest) {}
        template <class T>
        T number() {
            T value{};
            if (rest_.size() < sizeof value) throw std::runtime_error("the packet ends too early");
            std::memcpy(&value, rest_.data(), sizeof value);
            rest_.remove_prefix(sizeof value);
            return value;
        }
        template <class T>
        std::vector<T> numbers(size_t count) {
            std::vector<T> values(count);
            for (T& value : values) value = number<T>();
            return values;
        }
        std::string text() {
            const size_t end = rest_.find('\0');
            if (end == std::string_view::npos) throw std::runtime_error("a string has no end");
            const std::string value(rest_.substr(0, end));
            rest_.remove_prefix(end + 1);
            return value;
        }
        std::vector<std::string> texts(size_t count) {
            std::vector<std::string> values(count);
            for (std::string& value : values) value = text();
            return values;
        }
        size_t left() const { return rest_.size(); }

      private:
        std::string_view rest_;
    };

    template <class F>
    void await(const F& f) const {
        const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (!f() && std::chrono::steady_clock::now() < limit)
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        EXPECT_TRUE(f()) << "the viewer has waited for a minute";
    }

    bool isReadable(int from) const {
        pollfd waiting{from, POLLIN, 0};
        return poll(&waiting, 1, 5) > 0;
    }

    void serve() {
        while (!ending_) {
            if (!reads_ || !isReadable(listener_)) continue;
            const int connection = accept(listener_, nullptr, nullptr);
            ++connections_;
            receive(connection);
            close(connection);
        }
    }

    void receive(int connection) {
        std::string bytes, chunk(1 << 16, '\0');
        size_t total = 0;
        while (!ending_) {
            if (!reads_ || !isReadable(connection)) continue;
            const ssize_t size = recv(connection, chunk.data(), chunk.size(), 0);
            if (size <= 0) break;
            total += size_t(size);
            if (connections_ == 1 && total > hangUpAfter_) {
                const linger atOnce{1, 0};
                setsockopt(connection, SOL_SOCKET, SO_LINGER, &atOnce, sizeof atOnce);
                return;
            }
            bytes.append(chunk, 0, size_t(size));
            size_t begin = 0;
            uint32_t length = 0;
            while (bytes.size() - begin >= sizeof length) {
                std::memcpy(&length, bytes.data() + begin, sizeof length);
                if (bytes.size() - begin < length) break;
                try {
                    take(Fields(std::string_view(bytes).substr(begin + 4, length - 4)));
                } catch (const std::exception& error) {
                    ADD_FAILURE() << error.what();
                }
                begin += length;
            }
            bytes.erase(0, begin);
        }
        if (!ending_) ++ended_;
    }

    void take(Fields packet) {
        const std::lock_guard lock(mutex_);
        const char type = packet.number<char>();
        packet.number<char>();  // whether to select the image
        const std::string name = packet.text();
        if (type == 4) {
            Shown shown;
            shown.width = packet.number<int32_t>();
            shown.height = packet.number<int32_t>();
            for (const std::string& channel : packet.texts(size_t(packet.number<int32_t>())))
                shown.channels[channel].resize(size_t(shown.width) * size_t(shown.height));
            images_[name] = std::move(shown);
            ++created_;
        } else if (type == 6) {
            Shown& shown = images_.at(name);
            const auto count = size_t(packet.number<int32_t>());
            const auto names = packet.texts(count);
            const auto part = packet.numbers<int32_t>(4);
            const auto offsets = packet.numbers<int64_t>(count), strides = packet.numbers<int64_t>(count);
            const auto values = packet.numbers<float>(packet.left() / sizeof(float));
            for (size_t c = 0; c < count; ++c)
                for (int y = 0; y < part[3]; ++y)
                    for (int x = 0; x < part[2]; ++x)
                        shown.channels.at(names[c]).at(size_t(part[1] + y) * size_t(shown.width) +
                                                       size_t(part[0] + x)) =
                            values.at(size_t(offsets[c] + (int64_t(y) * part[2] + x) * strides[c]));
            ++shown.updates;
            ++updates_;
        } else {
            throw std::runtime_error("a packet of type " + std::to_string(int(type)));
        }
        if (packet.left() != 0 && type == 4) throw std::runtime_error("the packet is too long");
    }

    size_t hangUpAfter_;
    int listener_ = -1;
    uint16_t port_ = 0;
    std::atomic<bool> ending_ = false, reads_ = true;
    std::atomic<int> created_ = 0, updates_ = 0, connections_ = 0, ended_ = 0;
    mutable std::mutex mutex_;
    std::map<std::string, Shown> images_;
    std::thread thread_;
};

}  // namespace drc::test
