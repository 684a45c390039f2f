#include "base/checksum.h"

#include <cstring>

namespace drc {

uint64_t checksum(std::string_view bytes, uint64_t sum) {
    const auto add = [&](uint64_t word) {
        sum = (sum ^ word) * 0x100000001b3ull;
        sum ^= sum >> 29;
    };
    size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) {
        uint64_t word;
        std::memcpy(&word, bytes.data() + i, 8);
        add(word);
    }
    for (; i < bytes.size(); ++i) add(uint64_t(uint8_t(bytes[i])));
    return sum;
}

}  // namespace drc
