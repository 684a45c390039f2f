// Files that store a program's state, so that it can continue later: a line of text that identifies the state, values
// of fixed width in little-endian order, and a checksum. A file is written whole or not at all. A damaged or foreign
// file is rejected before any of its values are used.
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
    // All functions throw Error as AtomicFile does. header: one line, without the line end.
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
    // Replaces the file at the path.
    void commit();

  private:
    void flush();

    AtomicFile file_;
    std::string buffer_;
    uint64_t sum_;
};

class StateReader {
  public:
    // Throws Error, in one line that begins with the path, if the file is unreadable or damaged or has another header.
    // kind: the words that all headers of this kind of file begin with; other files are reported as not being of this
    // kind.
    StateReader(const std::string& path, const std::string& kind, const std::string& header);

    // These throw Error if the file ends before the requested size.
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
    // Throws Error if the file contains more than was read.
    void finish() const;
    // Throws Error that the file is damaged, for values that contradict each other.
    [[noreturn]] void fail(const std::string& why) const;

  private:
    std::string path_;
    MappedFile file_;
    std::string_view rest_;
};

// The header of a state file of the given kind. Throws Error as StateReader does.
std::string stateHeader(const std::string& path, const std::string& kind);

}  // namespace drc
