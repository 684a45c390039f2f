// Files that a program's state is saved in, so that it can go on later: a line of text that says what it is the state
// of, values of fixed width in little-endian order, and a checksum. They are written whole or not at all, and a damaged
// or foreign file is refused before anything of it is used.
#pragma once
#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

#include "base/atomic_file.h"
#include "base/mapped_file.h"

namespace drc {

static_assert(std::endian::native == std::endian::little, "values are written as they lie in memory");

template <typename T>
concept StateValue = std::is_arithmetic_v<T>;

class StateWriter {
  public:
    // Throws Error as AtomicFile does, as do all functions. header: one line, without its end.
    StateWriter(const std::string& path, const std::string& header);

    void bytes(std::span<const std::byte> data);
    template <StateValue T>
    void value(T v) {
        bytes(std::as_bytes(std::span(&v, 1)));
    }
    template <StateValue T, size_t N>
    void values(std::span<const T, N> v) {
        bytes(std::as_bytes(v));
    }
    // Puts the file in its place.
    void commit();

  private:
    void flush();

    AtomicFile file_;
    std::string buffer_;
    uint64_t sum_;
};

class StateReader {
  public:
    // Throws Error, in one line that begins with the path, if the file cannot be read, if it is damaged, or if its
    // header is another one: kind is what the headers of all such files begin with, by which others are told apart.
    StateReader(const std::string& path, const std::string& kind, const std::string& header);

    // All throw Error if the file does not have as much.
    void bytes(std::span<std::byte> to);
    template <StateValue T>
    T value() {
        T v;
        bytes(std::as_writable_bytes(std::span(&v, 1)));
        return v;
    }
    template <StateValue T, size_t N>
    void values(std::span<T, N> to) {
        bytes(std::as_writable_bytes(to));
    }
    size_t remaining() const { return rest_.size(); }
    // Throws Error if the file has more than what was read.
    void finish() const;
    // Throws Error: the values contradict each other.
    [[noreturn]] void fail(const std::string& why) const;

  private:
    std::string path_;
    MappedFile file_;
    std::string_view rest_;
};

// The header of a file that a StateWriter has written, of this kind. Throws Error as StateReader does.
std::string stateHeader(const std::string& path, const std::string& kind);

}  // namespace drc
