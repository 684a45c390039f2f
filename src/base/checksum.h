// A checksum over bytes. It detects damage and changes, not attacks.
#pragma once
#include <cstdint>
#include <string_view>

namespace drc {

inline constexpr uint64_t kChecksumStart = 0xcbf29ce484222325ull;

// Like FNV-1a, but over 64-bit words and with a shift that mixes high bits into low ones. sum: checksum of the
// preceding bytes; their number must be a multiple of eight for the result to equal that of all bytes in one call.
uint64_t checksum(std::string_view bytes, uint64_t sum = kChecksumStart);

}  // namespace drc
