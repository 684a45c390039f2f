// Pseudo-random numbers and hashes. All functions are deterministic and give the same results on every machine.
#pragma once
#include <bit>
#include <cstdint>
#include <type_traits>

#include "math/vec.h"

namespace drc {

// Maps the upper 24 bits of x to a uniform float in [0, 1).
constexpr float uniformFloat(uint32_t x) { return static_cast<float>(x >> 8) * 0x1p-24f; }

// A bijection of 64-bit numbers in which flipping any input bit flips every output bit with a probability near 1/2
// (Stafford's variant 13 of the MurmurHash3 finaliser).
constexpr uint64_t mixBits(uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

namespace detail {
template <typename T>
constexpr uint64_t hashBits(T v) {
    if constexpr (std::is_floating_point_v<T>) {
        // Adding 0.0 turns -0 into 0, so that equal numbers have equal hashes.
        return std::bit_cast<uint64_t>(static_cast<double>(v) + 0.0);
    } else if constexpr (std::is_enum_v<T>) {
        return static_cast<uint64_t>(static_cast<std::underlying_type_t<T>>(v));
    } else {
        static_assert(std::is_integral_v<T>, "hash takes integers, enums and floating-point numbers");
        return static_cast<uint64_t>(v);
    }
}
}  // namespace detail

// 64-bit hash of any number of integers, enums or floating-point numbers; their order matters. Negative integers are
// sign-extended to 64 bits, so that the type's width makes no difference.
template <typename... Args>
constexpr uint64_t hash(Args... args) {
    uint64_t h = mixBits(sizeof...(Args));
    ((h = mixBits((h ^ detail::hashBits(args)) + 0x9e3779b97f4a7c15ull)), ...);
    return h;
}

// The upper 32 bits of hash().
template <typename... Args>
constexpr uint32_t hash32(Args... args) {
    return static_cast<uint32_t>(hash(args...) >> 32);
}

// The PCG-XSH-RR generator with 64 bits of state (O'Neill, "PCG: A Family of Simple Fast Space-Efficient Statistically
// Good Algorithms for Random Number Generation", 2014). Period 2^64, and 2^63 independent sequences.
class Pcg32 {
  public:
    constexpr explicit Pcg32(uint64_t seed = 0x853c49e6748fea9bull, uint64_t sequence = 0) : inc_((sequence << 1) | 1) {
        nextUint();
        state_ += seed;
        nextUint();
    }

    constexpr uint32_t nextUint() {
        const uint64_t old = state_;
        state_ = old * kMultiplier + inc_;
        return std::rotr(static_cast<uint32_t>(((old >> 18) ^ old) >> 27), static_cast<int>(old >> 59));
    }
    // Uniform in [0, bound), without modulo bias. bound > 0.
    constexpr uint32_t nextUint(uint32_t bound) {
        const uint32_t threshold = (~bound + 1u) % bound;
        for (;;) {
            const uint32_t r = nextUint();
            if (r >= threshold) return r % bound;
        }
    }
    // Uniform in [0, 1).
    constexpr float nextFloat() { return uniformFloat(nextUint()); }
    Vec2 nextVec2() {
        const float x = nextFloat();
        return Vec2(x, nextFloat());
    }
    // Skips delta numbers, as if nextUint had been called that often. A negative delta goes back.
    constexpr void advance(int64_t delta) {
        // Composes the affine map x -> m x + c with itself delta times, by repeated squaring.
        uint64_t m = kMultiplier, c = inc_, mTotal = 1, cTotal = 0;
        for (uint64_t d = static_cast<uint64_t>(delta); d > 0; d >>= 1) {
            if (d & 1) {
                mTotal *= m;
                cTotal = cTotal * m + c;
            }
            c *= m + 1;
            m *= m;
        }
        state_ = mTotal * state_ + cTotal;
    }

  private:
    static constexpr uint64_t kMultiplier = 6364136223846793005ull;
    uint64_t state_ = 0;
    uint64_t inc_;
};

}  // namespace drc
