// Prefix sums of eight weights in SIMD registers. They serve to choose an index in proportion to its weight without a
// branch per weight, which would often be mispredicted.
#pragma once
#include <immintrin.h>

#include <bit>

namespace drc {

class EightSums {
  public:
    static constexpr int kCount = 8;

    // weights: eight non-negative numbers. offset: sum of the weights that precede these eight; added to all sums.
    explicit EightSums(const float* weights, float offset = 0) {
        __m256 s = _mm256_loadu_ps(weights);
        nonZero_ = maskOf(_mm256_cmp_ps(s, _mm256_setzero_ps(), _CMP_GT_OQ));
        s = _mm256_add_ps(s, shiftedUp<4>(s));
        s = _mm256_add_ps(s, shiftedUp<8>(s));
        // These are prefix sums within each half. The total of the first half is still missing from the second.
        const __m256 firstHalf = _mm256_permute2f128_ps(s, s, 0x08);
        s = _mm256_add_ps(s, _mm256_permute_ps(firstHalf, 0xff));
        sums_[0] = offset;
        _mm256_storeu_ps(sums_ + 1, _mm256_add_ps(s, _mm256_set1_ps(offset)));
    }
    // Sum of the offset and the first i weights, i in [0, 8].
    float before(int i) const { return sums_[i]; }
    float total() const { return sums_[kCount]; }
    // Index of the weight whose interval of the prefix sums contains target; 8 if target lies beyond them all. A weight
    // of zero is never chosen, even if the sums increase there by rounding, because they are added in different orders.
    int find(float target) const {
        const __m256 below = _mm256_cmp_ps(_mm256_loadu_ps(sums_ + 1), _mm256_set1_ps(target), _CMP_LE_OQ);
        const int count = std::popcount(maskOf(below));
        if (count == kCount) return kCount;
        const unsigned upTo = nonZero_ & ((2u << count) - 1);
        return upTo != 0 ? int(std::bit_width(upTo)) - 1 : std::countr_zero(nonZero_ | 1u << kCount);
    }
    // Index of the last weight that is not zero; -1 if all are zero.
    int last() const { return int(std::bit_width(nonZero_)) - 1; }

  private:
    template <int kBytes>
    static __m256 shiftedUp(__m256 s) {
        return _mm256_castsi256_ps(_mm256_slli_si256(_mm256_castps_si256(s), kBytes));
    }
    static unsigned maskOf(__m256 comparison) { return unsigned(_mm256_movemask_ps(comparison)); }

    unsigned nonZero_;  // bit i is set if weight i is not zero
    float sums_[kCount + 1];
};

}  // namespace drc
