// A checksum over bytes: it finds damage and changes, not attacks.
#pragma once
#include <cstdint>
#include <string_view>

namespace drc {

inline constexpr uint64_t kChecksumStart = 0xcbf29ce484222325ull;

// FNV-1a over 64-bit words. sum: of what came before, which must be a multiple of eight bytes.
uint64_t checksum(std::string_view bytes, uint64_t sum = kChecksumStart);

}  // namespace drc
