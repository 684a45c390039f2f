// Owen-scrambled Sobol samples, padded: every request for one or two numbers draws from a (0,2)-sequence of its own,
// shuffled and scrambled by hashing (Burley, "Practical Hash-based Owen Scrambling", JCGT 2020). A stream (a pixel, a
// radiance map) has its own scrambles; within a stream, sample indices 0, 1, 2, ... are well distributed for every
// power-of-two count. The same seed, stream and index always give the same numbers, whichever thread asks.
#pragma once
#include <cstdint>

#include "math/rng.h"
#include "math/vec.h"

namespace drc {

inline uint64_t hashCombine(uint64_t a, uint64_t b) { return mixBits(a ^ (mixBits(b) + 0x9e3779b97f4a7c15ull)); }

class Sampler {
  public:
    Sampler(uint64_t stream, uint32_t index) { start(stream, index); }

    void start(uint64_t stream, uint32_t index) {
        stream_ = mixBits(stream);
        index_ = index;
        dimension_ = 0;
    }
    // Numbers in [0, 1).
    float get1D();
    Vec2 get2D();
    // A sampler for a sub-problem, independent of this one and of other splits.
    Sampler split(uint32_t index) { return Sampler(hashCombine(stream_, 0x51ed270b0a1f39c1ull + dimension_++), index); }

  private:
    uint64_t stream_ = 0;
    uint32_t index_ = 0;
    uint32_t dimension_ = 0;
};

}  // namespace drc
