#include "math/sampler.h"

namespace drc {
namespace {

uint32_t reverseBits(uint32_t x) {
    x = __builtin_bswap32(x);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
    x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
    return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

// A hash in which every bit depends only on lower bits: on a bit-reversed number it is a nested uniform scramble.
uint32_t laineKarras(uint32_t x, uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

uint32_t owenScramble(uint32_t x, uint32_t seed) { return reverseBits(laineKarras(reverseBits(x), seed)); }

// Second dimension of the Sobol sequence. Its generator matrix is Pascal's triangle modulo 2, where entry (i, j) is odd
// if the bits of i are a subset of those of j (Lucas): a sum over supersets, done for each of the five bits at once.
uint32_t sobolSecondDimension(uint32_t index) {
    uint32_t v = index;
    v ^= v >> 16;
    v ^= (v & 0xff00ff00u) >> 8;
    v ^= (v & 0xf0f0f0f0u) >> 4;
    v ^= (v & 0xccccccccu) >> 2;
    v ^= (v & 0xaaaaaaaau) >> 1;
    return reverseBits(v);
}

float toUnit(uint32_t x) { return float(x >> 8) * 0x1p-24f; }

}  // namespace

float Sampler::get1D() {
    const uint64_t h = mixBits(stream_ + 0x9e3779b97f4a7c15ull * ++dimension_);
    const uint32_t shuffled = owenScramble(index_, uint32_t(h));
    return toUnit(owenScramble(reverseBits(shuffled), uint32_t(h >> 32)));
}

Vec2 Sampler::get2D() {
    const uint64_t h = mixBits(stream_ + 0x9e3779b97f4a7c15ull * ++dimension_);
    const uint64_t h2 = mixBits(h ^ 0xd1342543de82ef95ull);
    const uint32_t shuffled = owenScramble(index_, uint32_t(h));
    return Vec2(toUnit(owenScramble(reverseBits(shuffled), uint32_t(h >> 32))),
                toUnit(owenScramble(sobolSecondDimension(shuffled), uint32_t(h2))));
}

}  // namespace drc
