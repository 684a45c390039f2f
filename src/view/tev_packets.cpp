#include "view/tev_packets.h"

#include <bit>
#include <cassert>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace drc::tev {
namespace {

static_assert(std::endian::native == std::endian::little);

// The types of packets that this program sends, each in its latest version.
enum class Type : char { ReloadImage = 1, CloseImage = 2, CreateImage = 4, UpdateImageV3 = 6, OpenImageV2 = 7 };

class Packet {
  public:
    explicit Packet(Type type) {
        add(uint32_t(0));  // the length, set by finished()
        add(type);
    }
    template <class T>
    requires(std::is_integral_v<T> || std::is_enum_v<T>) Packet& add(T value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
        return *this;
    }
    Packet& add(bool value) { return add(char(value)); }
    Packet& add(std::string_view text) {
        assert(text.find('\0') == std::string_view::npos);
        bytes_.append(text).push_back('\0');
        return *this;
    }
    Packet& add(std::span<const std::string> texts) {
        for (const std::string& text : texts) add(std::string_view(text));
        return *this;
    }
    Packet& add(std::span<const float> values) {
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
        return *this;
    }
    void reserve(size_t more) { bytes_.reserve(bytes_.size() + more); }
    std::string finished() && {
        if (bytes_.size() > UINT32_MAX) throw std::length_error("a packet for tev has 4 GiB or more");
        const auto length = uint32_t(bytes_.size());
        std::memcpy(bytes_.data(), &length, sizeof length);
        return std::move(bytes_);
    }

  private:
    std::string bytes_;
};

}  // namespace

std::string openImage(std::string_view path, std::string_view channels, bool grabFocus) {
    Packet packet(Type::OpenImageV2);
    packet.add(grabFocus).add(path).add(channels);
    return std::move(packet).finished();
}

std::string reloadImage(std::string_view name, bool grabFocus) {
    Packet packet(Type::ReloadImage);
    packet.add(grabFocus).add(name);
    return std::move(packet).finished();
}

std::string closeImage(std::string_view name) {
    Packet packet(Type::CloseImage);
    packet.add(name);
    return std::move(packet).finished();
}

std::string createImage(std::string_view name, bool grabFocus, int width, int height,
                        std::span<const std::string> channels) {
    Packet packet(Type::CreateImage);
    packet.add(grabFocus).add(name).add(int32_t(width)).add(int32_t(height));
    packet.add(int32_t(channels.size())).add(channels);
    return std::move(packet).finished();
}

std::string updateImage(std::string_view name, bool grabFocus, const PixelRegion& part,
                        std::span<const std::string> channels, std::span<const float> values) {
    assert(values.size() == part.count() * channels.size());
    Packet packet(Type::UpdateImageV3);
    packet.reserve(values.size_bytes() + 1024);
    packet.add(grabFocus).add(name).add(int32_t(channels.size())).add(channels);
    for (const int side : {part.x0, part.y0, part.width(), part.height()}) packet.add(int32_t(side));
    // The offset of each channel's first value, and the distance between its values.
    for (size_t i = 0; i < channels.size(); ++i) packet.add(int64_t(i));
    for (size_t i = 0; i < channels.size(); ++i) packet.add(int64_t(channels.size()));
    packet.add(values);
    return std::move(packet).finished();
}

}  // namespace drc::tev
