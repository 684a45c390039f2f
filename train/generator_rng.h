// Random numbers for the scene generator. They are independent of the renderer's sampler and of the standard library's
// distributions, because a seed must give the same scenes, byte for byte, whatever changes there.
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

namespace drc::interior {

class Rng {
  public:
    // Different streams of a seed are independent.
    Rng(uint64_t seed, uint64_t stream)
        : state_(mix(seed) ^ mix(stream * 0x9e3779b97f4a7c15ull + 0x632be59bd9b4e019ull)) {}

    uint32_t bits() {
        state_ += 0x9e3779b97f4a7c15ull;
        return static_cast<uint32_t>(mix(state_) >> 32);
    }
    // Uniform in [0, 1).
    float uniform() { return static_cast<float>(bits() >> 8) * 0x1p-24f; }
    float uniform(float lo, float hi) { return lo + (hi - lo) * uniform(); }
    float logUniform(float lo, float hi) { return lo * std::exp(uniform() * std::log(hi / lo)); }
    // Uniform from lo to hi, both included.
    int integer(int lo, int hi) {
        return lo + static_cast<int>((static_cast<uint64_t>(bits()) * static_cast<uint64_t>(hi - lo + 1)) >> 32);
    }
    bool chance(float p) { return uniform() < p; }
    template <typename T>
    const T& pick(const std::vector<T>& v) {
        return v[static_cast<size_t>(integer(0, static_cast<int>(v.size()) - 1))];
    }
    // A separate generator for a part of the work, so that what the part draws does not affect what comes after it.
    Rng fork() {
        const uint64_t high = bits();
        return Rng((high << 32) | bits(), 0);
    }

  private:
    static uint64_t mix(uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }
    uint64_t state_;
};

}  // namespace drc::interior
