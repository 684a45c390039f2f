// Owen-scrambled Sobol samples, padded: every request for one or two numbers draws from a (0,2)-sequence of its own,
// shuffled and scrambled by hashing (Burley, "Practical Hash-based Owen Scrambling", JCGT 2020). Each stream (a pixel,
// a radiance map) has its own scrambling; within a stream, sample indices 0, 1, 2, ... are well distributed for every
// power-of-two count. A stream and an index always give the same numbers, on any thread.
#pragma once
#include <array>
#include <cstdint>

#include "math/rng.h"
#include "math/vec.h"

namespace drc {

inline uint64_t hashCombine(uint64_t a, uint64_t b) { return mixBits(a ^ (mixBits(b) + 0x9e3779b97f4a7c15ull)); }

namespace detail {

// Eight numbers in a SIMD register. The functions below work on one number or on eight.
using Uint8 = uint32_t __attribute__((vector_size(32)));
using Int8 = int32_t __attribute__((vector_size(32)));
using Float8 = float __attribute__((vector_size(32)));

template <class U>
inline U reverseBits(U x) {
    x = (x << 16) | (x >> 16);
    x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
    x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
    return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

// Laine and Karras's hash, in which every output bit depends only on the input bits up to its own. Applied to a
// bit-reversed number, it is a nested uniform (Owen) scramble.
template <class U>
inline U laineKarras(U x, U seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

// Second dimension of the Sobol sequence. Its generator matrix is Pascal's triangle modulo 2, whose entry (i, j) is odd
// exactly if the bits of i are a subset of those of j (Lucas's theorem). The matrix product is therefore an XOR over
// supersets, computed for one of the five index bits at a time. The result is bit-reversed, least significant digit
// first.
template <class U>
inline U sobolSecondDimensionReversed(U v) {
    v ^= v >> 16;
    v ^= (v & 0xff00ff00u) >> 8;
    v ^= (v & 0xf0f0f0f0u) >> 4;
    v ^= (v & 0xccccccccu) >> 2;
    v ^= (v & 0xaaaaaaaau) >> 1;
    return v;
}

inline float toUnit(uint32_t x) { return float(x >> 8) * 0x1p-24f; }

}  // namespace detail

class Sampler {
  public:
    Sampler(uint64_t stream, uint32_t index) { start(stream, index); }

    void start(uint64_t stream, uint32_t index) {
        stream_ = mixBits(stream);
        reversedIndex_ = detail::reverseBits(index);
        dimension_ = 0;
    }
    // One number in [0, 1).
    float get1D() {
        const uint64_t h = mixBits(stream_ + 0x9e3779b97f4a7c15ull * ++dimension_);
        return radicalInverse(shuffled(h), uint32_t(h >> 32));
    }
    Vec2 get2D() {
        const uint64_t h = mixBits(stream_ + 0x9e3779b97f4a7c15ull * ++dimension_);
        const uint64_t h2 = mixBits(h ^ 0xd1342543de82ef95ull);
        const uint32_t i = shuffled(h);
        const uint32_t y = detail::laineKarras(detail::sobolSecondDimensionReversed(i), uint32_t(h2));
        return Vec2(radicalInverse(i, uint32_t(h >> 32)), detail::toUnit(detail::reverseBits(y)));
    }
    // Four pairs, each like one from get2D(). Computing them side by side in SIMD registers takes little longer than
    // computing one.
    std::array<Vec2, 4> getFour2D() {
        // Twelve 32-bit seeds: four to shuffle the indices of four sequences, eight to scramble their two coordinates.
        uint64_t h[6];
        for (uint64_t& seeds : h) seeds = mixBits(stream_ + 0x9e3779b97f4a7c15ull * ++dimension_);
        const auto low = [&](int k) { return uint32_t(h[k]); };
        const auto high = [&](int k) { return uint32_t(h[k] >> 32); };
        const detail::Uint8 shuffle = {low(0), low(1), low(2), low(3), low(0), low(1), low(2), low(3)};
        const detail::Uint8 scramble = {low(4), high(4), low(5), high(5), high(0), high(1), high(2), high(3)};
        const detail::Uint8 index = detail::Uint8{} + reversedIndex_;
        const detail::Uint8 shuffled = detail::reverseBits(detail::laineKarras(index, shuffle));
        // Lanes 0 to 3 compute the first coordinates, lanes 4 to 7 the second.
        constexpr detail::Uint8 kFirst = {~0u, ~0u, ~0u, ~0u, 0, 0, 0, 0};
        const detail::Uint8 digits = (shuffled & kFirst) | (detail::sobolSecondDimensionReversed(shuffled) & ~kFirst);
        const detail::Uint8 bits = detail::reverseBits(detail::laineKarras(digits, scramble));
        const detail::Float8 u = __builtin_convertvector(detail::Int8(bits >> 8), detail::Float8) * 0x1p-24f;
        return {Vec2(u[0], u[4]), Vec2(u[1], u[5]), Vec2(u[2], u[6]), Vec2(u[3], u[7])};
    }
    // A sampler for a sub-problem, independent of this one and of other calls of split.
    Sampler split(uint32_t index) { return Sampler(hashCombine(stream_, 0x51ed270b0a1f39c1ull + dimension_++), index); }

  private:
    // A nested uniform scramble reverses the bits, hashes and reverses again. Pairs of reversals that cancel are left
    // out.
    uint32_t shuffled(uint64_t h) const {
        return detail::reverseBits(detail::laineKarras(reversedIndex_, uint32_t(h)));
    }
    // First dimension of the Sobol sequence: the index with its bits reversed, then scrambled.
    static float radicalInverse(uint32_t i, uint32_t seed) {
        return detail::toUnit(detail::reverseBits(detail::laineKarras(i, seed)));
    }

    uint64_t stream_ = 0;
    uint32_t reversedIndex_ = 0;
    uint32_t dimension_ = 0;
};

}  // namespace drc
